// Keeps what the page has loaded, so that a second visit works without a network. Nothing is fetched that the page did not
// ask for: the page says what it has loaded, and the browser's own cache still holds it.
//
// The browser may end this worker at any time, and the network may go at any time: what is kept is always a page with all its parts.

const CACHE = 'libration-lab'

self.addEventListener('install', () => self.skipWaiting())
self.addEventListener('activate', (event) => event.waitUntil(self.clients.claim()))

async function fetchInto(cache, address) {
  const response = await fetch(address, { cache: 'force-cache' })
  if (!response.ok) throw new Error(`${address}: answered ${response.status}`)
  await cache.put(address, response)
}

/** A visit: its parts first, then the page, which asks for them, and last the parts of other versions are let go. */
async function keep(page, parts) {
  const cache = await caches.open(CACHE)
  for (const part of parts) if (!(await cache.match(part, { ignoreVary: true }))) await fetchInto(cache, part)
  // Without a network the visit was of the page that is kept.
  await fetchInto(cache, page).catch(async (error) => {
    if (!(await cache.match(page, { ignoreVary: true }))) throw error
  })
  const wanted = new Set([page, ...parts])
  for (const request of await cache.keys()) if (!wanted.has(request.url)) await cache.delete(request)
}

/** The answer says that all is kept. */
self.addEventListener('message', (event) => {
  const { page, parts } = event.data
  const here = self.registration.scope
  const ours = parts.filter((each) => each.startsWith(here))
  event.waitUntil(keep(page, ours).then(() => event.ports[0].postMessage('kept')))
})

/** The page itself from the network if there is one; what it consists of has its digest in its name and never changes. */
async function answer(request) {
  const navigates = request.mode === 'navigate'
  const kept = () => caches.match(request, { ignoreSearch: navigates, ignoreVary: true })
  if (!navigates) return (await kept()) ?? fetch(request)
  return fetch(request).catch(async (error) => {
    const page = await kept()
    if (page) return page
    throw error
  })
}

self.addEventListener('fetch', (event) => {
  if (event.request.method === 'GET' && event.request.url.startsWith(self.registration.scope))
    event.respondWith(answer(event.request))
})
