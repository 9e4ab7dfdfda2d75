// Two builds of one page: dist/ for a server, with relative paths, and dist/offline.html, one file that works from disk; and
// dist/widget.js, its drawing as one module for notebooks.

import { createRequire } from 'node:module'
import { dirname } from 'node:path'
import { defineConfig } from 'vitest/config'
import { browserCore } from './bundle/browser-core.ts'
import { firstLoad, isFirst } from './bundle/first-load.ts'
import { formulas } from './bundle/formulas.ts'
import { licences } from './bundle/licences.ts'
import { oneFile } from './bundle/one-file.ts'
import { stillPage } from './bundle/still.ts'
import { widget } from './bundle/widget.ts'

/** Vite does not find files of a package's `exports` by a pattern once they have a query. */
const core = dirname(createRequire(import.meta.url).resolve('libration/libration-simd.wasm'))

export default defineConfig(({ mode, command }) => {
  const offline = mode === 'offline'
  const notebook = mode === 'widget'
  return {
    base: './',
    publicDir: offline || notebook ? false : 'public',
    resolve: { alias: [{ find: /^libration\/(.*\.wasm)/, replacement: `${core}/$1` }] },
    server: { fs: { allow: ['..'] } },
    plugins: [
      browserCore(),
      ...(notebook ? [] : [firstLoad()]),
      formulas(),
      ...(notebook ? [widget()] : [stillPage(command === 'build')]),
      ...(notebook ? [] : offline ? [oneFile('offline.html')] : [licences()]),
    ],
    build: {
      target: 'es2022',
      modulePreload: false,
      emptyOutDir: !offline && !notebook,
      ...(notebook ? { lib: { entry: 'src/widget.ts', formats: ['es' as const], fileName: () => 'widget.js' } } : {}),
      assetsInlineLimit: offline ? Number.MAX_SAFE_INTEGER : 0,
      cssCodeSplit: !offline,
      reportCompressedSize: false,
      rolldownOptions: {
        output: notebook
          ? { codeSplitting: false }
          : offline
            ? { format: 'iife', codeSplitting: false }
            : { codeSplitting: { groups: [{ name: 'index', test: isFirst }] } },
      },
    },
    // A busy machine is no failure.
    test: { include: ['tests/**/*.test.ts'], testTimeout: 240_000, hookTimeout: 240_000 },
  }
})
