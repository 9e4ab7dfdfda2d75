// Where the two modules of the core come from: files beside the page, or text inside it in the offline file.

import scalar from 'libration/libration-scalar.wasm?url'
import simd from 'libration/libration-simd.wasm?url'

export const SOURCES = { simd, scalar }
