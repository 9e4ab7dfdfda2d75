// Keeps what the page has loaded, so that a second visit works without a network. Nothing is fetched that the page did not
// ask for: the page says what it has loaded, and the browser's own cache still holds it.

const CACHE = 'libration-lab'

self.addEventListener('install', () => self.skipWaiting())
self.addEventListener('activate', (event) => event.waitUntil(self.clients.claim()))

/** The addresses of one visit: kept, and those of earlier versions of the page let go. */
async function keep(addresses) {
  const cache = await caches.open(CACHE)
  const wanted = new Set(addresses)
  for (const request of await cache.keys()) if (!wanted.has(request.url)) await cache.delete(request)
  for (const address of wanted) {
    if (await cache.match(address, { ignoreVary: true })) continue
    const response = await fetch(address, { cache: 'force-cache' })
    if (response.ok) await cache.put(address, response)
  }
}

self.addEventListener('message', (event) => {
  const addresses = event.data
  const here = self.registration.scope
  if (!Array.isArray(addresses)) return
  event.waitUntil(keep(addresses.filter((each) => typeof each === 'string' && each.startsWith(here))))
})

/** The page itself from the network if there is one; what it consists of has its digest in its name and never changes. */
async function answer(request) {
  const kept = await caches.match(request, { ignoreSearch: request.mode === 'navigate', ignoreVary: true })
  if (request.mode !== 'navigate') return kept ?? fetch(request)
  try {
    const fresh = await fetch(request)
    if (fresh.ok && kept) await (await caches.open(CACHE)).put(request, fresh.clone())
    return fresh
  } catch (error) {
    if (kept) return kept
    throw error
  }
}

self.addEventListener('fetch', (event) => {
  if (event.request.method === 'GET' && event.request.url.startsWith(self.registration.scope))
    event.respondWith(answer(event.request))
})
