// Where the modules of the core come from: files beside the page, or text inside it in the offline file, compressed.
// One of the first two is needed to begin; the second holds what the views of the period and the functions need, and the cubic
// formulas, and follows.

import fit from 'libration/libration-fit.wasm?url'
import motions from 'libration/libration-motions.wasm?url'
import period from 'libration/libration-period.wasm?url'
import reader from 'libration/libration-reader.wasm?url'
import scalar from 'libration/libration-scalar.wasm?url'
import second from 'libration/libration-second.wasm?url'
import simd from 'libration/libration-simd.wasm?url'

/** What the build of one file makes of a module (bundle/one-file.ts): gzip in base64. */
const PACKED = 'data:application/gzip;base64,'

function unpacked(address: string): Promise<Response> {
  const letters = atob(address.slice(PACKED.length))
  const bytes = Uint8Array.from(letters, (letter) => letter.charCodeAt(0))
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'))
  return Promise.resolve(new Response(stream))
}

/** Unpacked only if it is asked for. */
function source(address: string): string | PromiseLike<Response> {
  if (!address.startsWith(PACKED)) return address
  // biome-ignore lint/suspicious/noThenProperty: a promise that begins when it is awaited
  return { then: (done, failed) => unpacked(address).then(done, failed) }
}

export const SOURCES = { simd: source(simd), scalar: source(scalar) }
export const SECOND = source(second)
/** The reader of files and g from a period: asked for when their part of the view Data opens; the fit with the first file. */
export const READER = source(reader)
export const FIT = source(fit)
export const PERIOD = source(period)
/** Springs and friction: asked for when one of these views opens. */
export const MOTIONS = source(motions)
