// Puts script, style and every file of the page into its HTML: a page that is one file and works from disk.
//
// Vite makes the fonts into `data:` addresses (assetsInlineLimit), this plugin the modules of the core, compressed; script
// and style follow. A classic script: a module cannot be loaded from file:// in every browser.

import { readFileSync } from 'node:fs'
import { gzipSync } from 'node:zlib'
import type { Plugin } from 'vite'

/** Unpacks the script beside it and runs it. What is written in the page stays a plain text: base64 has no mark of HTML. */
const BEGIN = `(async () => {
  const packed = document.getElementById('packed').textContent
  const bytes = Uint8Array.from(atob(packed), (letter) => letter.charCodeAt(0))
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'))
  const script = document.createElement('script')
  script.textContent = await new Response(stream).text()
  document.body.append(script)
})()`

export function oneFile(name: string): Plugin {
  return {
    name: 'one-file',
    enforce: 'pre',
    // The fit is half as long as all the rest: in its place the view says, in words of its own, that it is not there.
    resolveId(source, importer) {
      if (source === './data' && importer?.endsWith('/views/index.ts'))
        return importer.replace('index.ts', 'data-absent.ts')
      return source === './webm' ? (importer?.replace('video.ts', 'webm-absent.ts') ?? null) : null
    },
    load(id) {
      if (!id.endsWith('.wasm?url')) return null
      // The fit is asked for by the view Data, which is not in this file; a browser that unpacks the script has vectors.
      if (/libration-(?:fit|scalar)/.test(id)) return "export default ''"
      const packed = gzipSync(readFileSync(id.slice(0, -'?url'.length)), { level: 9 })
      return `export default 'data:application/gzip;base64,${packed.toString('base64')}'`
    },
    transformIndexHtml: {
      order: 'pre',
      // A font that is inside needs no early request.
      handler: (html) => html.replace(/\s*<link rel="preload"[^>]*>/g, ''),
    },
    generateBundle: {
      order: 'post',
      handler(_, bundle) {
        const files = Object.values(bundle)
        const page = files.find((each) => each.fileName.endsWith('.html'))
        if (page?.type !== 'asset') throw new Error('the page is not in the bundle')
        let html = String(page.source)
        for (const file of files) {
          if (file === page) continue
          if (file.type === 'chunk') {
            const tag = new RegExp(`\\s*<script[^>]*src="[^"]*${file.fileName}"[^>]*></script>`)
            if (!tag.test(html)) throw new Error(`${file.fileName} is not asked for by the page`)
            html = html.replace(tag, '')
            const packed = gzipSync(file.code, { level: 9 }).toString('base64')
            const tags = `<script type="text/plain" id="packed">${packed}</script>\n<script>${BEGIN}</script>`
            html = html.replace('</body>', () => `${tags}\n</body>`)
          } else if (file.fileName.endsWith('.css')) {
            const tag = new RegExp(`<link[^>]*href="[^"]*${file.fileName}"[^>]*>`)
            html = html.replace(tag, () => `<style>${String(file.source)}</style>`)
          } else {
            throw new Error(`${file.fileName} is not in the page`)
          }
          delete bundle[file.fileName]
        }
        page.source = html
        page.fileName = name
      },
    },
  }
}
