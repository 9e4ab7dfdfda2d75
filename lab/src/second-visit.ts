// A second visit without a network: a service worker keeps what this visit has loaded (public/service-worker.js).

import { retried } from './retry'
import { FIT, MOTIONS, PERIOD, READER, SECOND } from './sources'

/** How long an answer of the worker is waited for, in ms: the browser may end it while it keeps. */
const PATIENCE = 10_000

/** Kept by the worker, as it says; rejects where it says nothing. */
async function kept(visit: { readonly page: string; readonly parts: readonly string[] }): Promise<void> {
  const { active } = await navigator.serviceWorker.ready
  await new Promise<void>((done, lost) => {
    const { port1, port2 } = new MessageChannel()
    port1.onmessage = () => done()
    setTimeout(lost, PATIENCE)
    active?.postMessage(visit, [port2])
  })
}

/** Visits are kept one after the other, so that none lets go what a later one has loaded. */
let turn: Promise<void> = Promise.resolve()
let times = 0
let wholeVisit: () => void
/** Where all parts of the visit have come. */
const whole = new Promise<void>((done) => {
  wholeVisit = done
})

/**
 * Asks the worker to keep a visit that has loaded all its parts, and marks the page when it has: `data-kept`, with how often it did.
 * Quietly nothing where a page may not have one: from disk, in a sandboxed frame, while it is being written.
 */
export function keepForLater(): Promise<void> {
  turn = turn.then(keep)
  wholeVisit()
  return turn
}

/** The same again for what a view has loaded since: never before a visit with all its parts. */
export async function keepMore(): Promise<void> {
  await whole
  await keepForLater()
}

async function keep(): Promise<void> {
  if (!import.meta.env.PROD || import.meta.env.MODE === 'offline') return
  if (!('serviceWorker' in navigator) || !location.protocol.startsWith('http')) return
  try {
    await navigator.serviceWorker.register('./service-worker.js')
    const addressOf = (source: unknown) => (typeof source === 'string' ? [new URL(source, location.href).href] : [])
    // The last part may not be among them yet, and a module of a view that this visit did not open is kept if one before did.
    const last = addressOf(SECOND)
    for (const part of [MOTIONS, READER, FIT, PERIOD].flatMap(addressOf))
      if (await caches.match(part, { ignoreVary: true })) last.push(part)
    const loaded = performance.getEntriesByType('resource').map(({ name }) => name)
    const page = location.href.replace(/[?#].*$/, '')
    const parts = [...loaded, ...last].filter((name) => !name.endsWith('/service-worker.js'))
    await retried(() => kept({ page, parts }))
    times++
    document.documentElement.dataset.kept = String(times)
  } catch {
    // Storage is closed to this page; it works as well, only not without a network.
  }
}
