// Puts script, style and every file of the page into its HTML: a page that is one file and works from disk.
//
// Vite makes the fonts into `data:` addresses (assetsInlineLimit), this plugin the modules of the core; script and style follow, in one
// compressed text. A classic script: a module cannot be loaded from file:// in every browser.

import { readFileSync } from 'node:fs'
import { gzipSync } from 'node:zlib'
import type { Plugin } from 'vite'

/**
 * The letters of the packed text: base 94, the printable letters without `<`, so that it has no mark of HTML; nine bytes are eleven letters.
 */
function letters(bytes: Buffer): string {
  const padded = Buffer.concat([bytes, Buffer.alloc((9 - (bytes.length % 9)) % 9)])
  let text = ''
  for (let i = 0; i < padded.length; i += 9) {
    let rest = BigInt(`0x${padded.toString('hex', i, i + 9)}`)
    let eleven = ''
    for (let k = 0; k < 11; k++) {
      const code = 32 + Number(rest % 94n)
      eleven = String.fromCharCode(code < 60 ? code : code + 1) + eleven
      rest /= 94n
    }
    text += eleven
  }
  return text
}

/** Style and script in one text that unpacks itself: the style, a null letter, the script. */
function packed(style: string, script: string): string {
  const bytes = gzipSync(`${style}\0${script}`, { level: 9 })
  const begin = `(async () => {
  const still = document.getElementById('still')
  still.hidden = true
  try {
    const text = document.getElementById('packed').textContent
    const bytes = new Uint8Array((text.length / 11) * 9)
    for (let i = 0, at = 0; i < text.length; ) {
      let [high, middle, low] = [0, 0, 0]
      for (let k = 0; k < 11; k++) {
        const code = text.charCodeAt(i++)
        low = low * 94 + code - (code < 60 ? 32 : 33)
        middle = middle * 94 + (low >>> 24)
        high = high * 94 + (middle >>> 24)
        low &= 0xffffff
        middle &= 0xffffff
      }
      for (const part of [high, middle, low]) for (const shift of [16, 8, 0]) bytes[at++] = part >>> shift
    }
    const stream = new Blob([bytes.subarray(0, ${bytes.length})]).stream().pipeThrough(new DecompressionStream('gzip'))
    const [style, script] = (await new Response(stream).text()).split('\\0')
    document.head.append(Object.assign(document.createElement('style'), { textContent: style }))
    document.body.append(Object.assign(document.createElement('script'), { textContent: script }))
  } catch (error) {
    still.hidden = false
    throw error
  }
})()`
  return `<script type="text/plain" id="packed">${letters(bytes)}</script>\n<script>${begin}</script>`
}

/** What the part that needs no script looks like without the style of the page. */
const PLAIN = '<style>body { font: 1rem/1.4 sans-serif; margin: 1rem auto; max-width: 60rem; padding: 0 1rem }</style>'

export function oneFile(name: string): Plugin {
  return {
    name: 'one-file',
    enforce: 'pre',
    // The fit is half as long as all the rest: in its place the view says, in words of its own, that it is not there.
    resolveId(source, importer) {
      if (source === './data' && importer?.endsWith('/views/index.ts'))
        return importer.replace('index.ts', 'data-absent.ts')
      return source === '../save/video' ? (importer?.replace('views/film.ts', 'save/video-absent.ts') ?? null) : null
    },
    load(id) {
      if (!id.endsWith('.wasm?url')) return null
      // Some are asked for by the view Data, which is not in this file; a browser that unpacks the script has vectors.
      if (/libration-(?:fit|period|reader|scalar)/.test(id)) return "export default ''"
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
        let style = ''
        let script = ''
        for (const file of files) {
          if (file === page) continue
          const chunk = file.type === 'chunk'
          if (!chunk && !file.fileName.endsWith('.css')) throw new Error(`${file.fileName} is not in the page`)
          const tag = new RegExp(
            chunk
              ? `\\s*<script[^>]*src="[^"]*${file.fileName}"[^>]*></script>`
              : `<link[^>]*href="[^"]*${file.fileName}"[^>]*>`,
          )
          if (!tag.test(html)) throw new Error(`${file.fileName} is not asked for by the page`)
          html = html.replace(tag, '')
          if (chunk) script += file.code
          else style += file.source
          delete bundle[file.fileName]
        }
        html = html.replace('</head>', () => `<noscript>${PLAIN}</noscript>\n</head>`)
        html = html.replace('</body>', () => `${packed(style, script)}\n</body>`)
        page.source = html
        page.fileName = name
      },
    },
  }
}
