// The build of dist/widget.js, one module for notebooks: the core with vectors is text inside it, and its style a string.

import { readFileSync } from 'node:fs'
import { gzipSync } from 'node:zlib'
import type { Plugin } from 'vite'

export function widget(): Plugin {
  return {
    name: 'widget',
    enforce: 'pre',
    load(id) {
      if (!id.endsWith('.wasm?url')) return null
      // The motion of a pendulum is in the first module; every browser that a notebook runs in has vectors.
      if (!id.includes('libration-simd')) return "export default ''"
      const packed = gzipSync(readFileSync(id.slice(0, -'?url'.length)), { level: 9 })
      return `export default 'data:application/gzip;base64,${packed.toString('base64')}'`
    },
  }
}
