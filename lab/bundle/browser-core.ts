// The package of the core as a browser needs it: without the way to its files that Node has, and without addresses of its
// own, since the page gives the modules (src/sources.ts); in the offline file they would stand a second time.

import type { Plugin } from 'vite'

export function browserCore(): Plugin {
  return {
    name: 'browser-core',
    apply: 'build',
    enforce: 'pre',
    transform(code, id) {
      if (!/\/dist\/(?:core|motions)\.js$/.test(id)) return null
      const replaced = code
        .replace(/new URL\("\.\/libration-(?:simd|scalar|second|motions)\.wasm", import\.meta\.url\)/g, '""')
        .replace('await import("node:fs/promises")', '{}')
      if (replaced.includes('import.meta') || replaced.includes('node:'))
        throw new Error(`${id} has other addresses than the build knows`)
      return replaced
    },
  }
}
