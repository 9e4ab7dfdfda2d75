// The formulas of the derivation as MathML, made when the page is built: no converter is in the page.
//
// A file of formulas has one a line, `name: piece & piece`; the module made of it has a list of pieces by each name.

import temml from 'temml'
import type { Plugin } from 'vite'

const SPACE = '<mspace width="0.1667em"></mspace>'
const twoSpaces = new RegExp(`(${SPACE}(?:<mrow>)*)${SPACE}`, 'g')

/**
 * One piece, without what a browser does not need: classes of a style sheet that the page has not. Dots and tildes are accents, and
 * before the name of a function there is one thin space, whether it is written or not.
 */
function mathml(tex: string): string {
  return temml
    .renderToString(tex, { displayMode: true, throwOnError: true, xml: false })
    .replace(/ (?:class|style)="[^"]*"/g, '')
    .replaceAll('<mover>', '<mover accent="true">')
    .replace(twoSpaces, '$1')
    .replace('<math display="block">', '<math displaystyle="true">')
}

export function formulasOf(source: string): Record<string, readonly string[]> {
  const out: Record<string, readonly string[]> = {}
  for (const line of source.split('\n')) {
    if (line.trim() === '' || line.startsWith('%')) continue
    const [, name, tex] = /^([\w-]+): (.+)$/.exec(line) ?? []
    if (!name || !tex) throw new Error(`not a formula: ${line}`)
    if (out[name]) throw new Error(`${name} stands twice`)
    out[name] = tex.split(' & ').map((piece) => mathml(piece.trim()))
  }
  return out
}

export function formulas(): Plugin {
  return {
    name: 'formulas',
    transform(code, id) {
      if (!id.endsWith('.tex')) return null
      return { code: `export default ${JSON.stringify(formulasOf(code))}`, map: null }
    },
  }
}
