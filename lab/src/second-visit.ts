// A second visit without a network: a service worker keeps what this visit has loaded (public/service-worker.js).

/** Quietly nothing where a page may not have one: from disk, in a sandboxed frame, while it is being written. */
export async function keepForLater(): Promise<void> {
  if (!import.meta.env.PROD || !('serviceWorker' in navigator) || !location.protocol.startsWith('http')) return
  try {
    await navigator.serviceWorker.register('./service-worker.js')
    const { active } = await navigator.serviceWorker.ready
    const page = location.href.replace(/[?#].*$/, '')
    const loaded = performance.getEntriesByType('resource').map(({ name }) => name)
    active?.postMessage([page, ...loaded.filter((name) => !name.endsWith('/service-worker.js'))])
  } catch {
    // Storage is closed to this page; it works as well, only not without a network.
  }
}
