// What the page weighs, and that it asks for nothing from elsewhere.
//
// The build prints the table, and fails where the page asks for another address or lacks a part. With --bounds, `npm run weigh`,
// it fails too where the page is heavier than it may be.

import { readdirSync, readFileSync, statSync } from 'node:fs'
import { join } from 'node:path'
import { gzipSync } from 'node:zlib'

const bounds = process.argv.includes('--bounds')
const DIST = new URL('../dist/', import.meta.url).pathname
/** Bytes: all that is loaded first, gzipped; the offline file as it is. */
const FIRST_LOAD = 150_000
const OFFLINE = 600_000
/** Modules that are asked for when they are needed, gzipped, and when that is. */
const LATER = {
  reader: { most: 128_000, when: 'when Data from a file opens' },
  fit: { most: 152_000, when: 'with the first file' },
  period: { most: 36_000, when: 'when Data from a period opens' },
  motions: { most: 110_000, when: 'when springs or friction open' },
}

/** @param {string} folder @returns {string[]} */
function files(folder) {
  return readdirSync(folder).flatMap((name) => {
    const path = join(folder, name)
    return statSync(path).isDirectory() ? files(path) : [path]
  })
}

const all = files(DIST).map((path) => {
  const bytes = readFileSync(path)
  return {
    name: path.slice(DIST.length),
    bytes: bytes.length,
    gzipped: /\.woff2$/.test(path) ? bytes.length : gzipSync(bytes, { level: 9 }).length,
  }
})
/** @type {string[]} */
const failures = []

// The first load has one module of the core: that with vectors, which every browser of today loads. The scalar one is for old
// browsers, and the second comes when the page works.
const cores = all.filter(({ name }) => /libration-(simd|scalar)[^/]*\.wasm$/.test(name))
const of = (/** @type {string} */ kind) =>
  cores.find(({ name }) => name.includes(`libration-${kind}`))?.gzipped ?? Number.NaN
/** A file of the page by its name. @param {string} name */
const textOf = (name) => readFileSync(join(DIST, name), 'utf8')
// What is loaded at once: the files that the page names, what their scripts import at once, and the fonts of their style. The views
// behind the other tabs are parts of their own, with their style and fonts: asked for by the script and waited for by nothing.
const atOnce = new Set(['index.html', 'service-worker.js'])
for (const name of atOnce) {
  if (!/\.(html|js|css)$/.test(name)) continue
  const named = name.endsWith('.js')
    ? /(?:from|import)\s*"\.\/([^"]+)"/g
    : /(?:src|href)="\.\/([^"]+)"|url\(\.\/([^)]+)\)/g
  for (const [, one, other] of textOf(name).matchAll(named)) {
    const found = all.find((each) => each.name.endsWith(`/${(one ?? other ?? '').replace(/^assets\//, '')}`))
    if (found) atOnce.add(found.name)
  }
}
const parts = all.filter((each) => each.name !== 'offline.html' && !each.name.endsWith('.wasm'))
const first = parts.filter(({ name }) => atOnce.has(name))
const later = parts.filter(({ name }) => !atOnce.has(name))
const others = first.reduce((sum, { gzipped }) => sum + gzipped, 0)
const load = others + of('simd')
console.log(`${'file'.padEnd(48)} ${'bytes'.padStart(8)} ${'gzipped'.padStart(8)}`)
for (const { name, bytes, gzipped } of all)
  console.log(`${name.padEnd(48)} ${String(bytes).padStart(8)} ${String(gzipped).padStart(8)}`)
console.log(`first load ${load} bytes gzipped of ${FIRST_LOAD}: core ${of('simd')}, the rest ${others}`)
console.log(`first load of a browser without vectors ${others + of('scalar')}`)
console.log(`then ${later.reduce((sum, { gzipped }) => sum + gzipped, 0)} for the other views`)
if (first.filter(({ name }) => name.endsWith('.js')).length !== 2)
  failures.push('the first load has other scripts than its own and the service worker')
if (!later.some(({ name }) => name.includes('later-'))) failures.push('the part with the first views is not there')
if (!all.some(({ name }) => name === 'licences.txt')) failures.push('the licences of the libraries are not there')
if (cores.length !== 2) failures.push(`two modules of the core are expected, there are ${cores.length}`)
if (bounds && !(load <= FIRST_LOAD)) failures.push(`the first load is ${load} bytes gzipped, allowed are ${FIRST_LOAD}`)

for (const [kind, { most, when }] of Object.entries(LATER)) {
  const modules = all.filter(({ name }) => new RegExp(`libration-${kind}[^/]*\\.wasm$`).test(name))
  const weight = modules[0]?.gzipped ?? Number.NaN
  console.log(`then ${weight} for the module ${kind}, ${when}`)
  if (modules.length !== 1) failures.push(`one module ${kind} is expected, there are ${modules.length}`)
  if (bounds && !(weight <= most)) failures.push(`the module ${kind} is ${weight} bytes gzipped, allowed are ${most}`)
}

const offline = all.find(({ name }) => name === 'offline.html')
if (!offline) failures.push('there is no offline.html')
else {
  console.log(`offline.html ${offline.bytes} bytes of ${OFFLINE}`)
  if (bounds && offline.bytes > OFFLINE) failures.push(`offline.html is ${offline.bytes} bytes, allowed are ${OFFLINE}`)
}

for (const { name } of all.filter((each) => /\.(html|css)$/.test(each.name))) {
  const text = readFileSync(join(DIST, name), 'utf8').replace(/(<script[^>]*>)[\s\S]*?(<\/script>)/g, '$1$2')
  const asked = [...text.matchAll(/(?:src|href)="(?!data:|#)([^"]*)"|url\((?!["']?(?:data:|#))([^)]*)\)/g)].map(
    (match) => match[1] ?? match[2] ?? '',
  )
  for (const address of asked) {
    const outside = /^(?:https?:)?\/\//.test(address) || address.startsWith('/')
    const own = name === 'offline.html' && address !== 'offline.html'
    if (outside || own) failures.push(`${name} asks for ${address}`)
  }
}

for (const failure of failures) console.error(failure)
process.exit(failures.length === 0 ? 0 : 1)
