// The little markup of the catalogues, for the eye and for the ear: *bold*, _symbol_, _symbol_{index}, ^{power}.
//
// `_T_{0}` is T with an index 0; `_θ'_` has a dot above, `_θ''_` two. Spoken text is the same without marks, with symbols
// in words where the catalogue has them.

import { html, nothing, svg, type TemplateResult } from 'lit-html'

interface Piece {
  readonly kind: 'text' | 'bold' | 'symbol' | 'dotted' | 'twice' | 'index' | 'power'
  readonly text: string
}

const MARKS = /\*([^*]+)\*|_([^_{}]+)_(?:\{([^}]+)\})?|\^\{([^}]+)\}/g

export function pieces(text: string): Piece[] {
  if (!/[*_^]/.test(text)) return text === '' ? [] : [{ kind: 'text', text }]
  const out: Piece[] = []
  let from = 0
  const push = (kind: Piece['kind'], part: string) => part !== '' && out.push({ kind, text: part })
  for (const match of text.matchAll(MARKS)) {
    push('text', text.slice(from, match.index))
    const [whole, bold, symbol, index, power] = match
    if (bold !== undefined) push('bold', bold)
    else if (symbol !== undefined) {
      if (symbol.endsWith("''")) push('twice', symbol.slice(0, -2))
      else if (symbol.endsWith("'")) push('dotted', symbol.slice(0, -1))
      else push('symbol', symbol)
      push('index', index ?? '')
    } else push('power', power ?? '')
    from = match.index + whole.length
  }
  push('text', text.slice(from))
  return out
}

/** As it is shown in the page. Values that are given are filled in after the marks, so that what others wrote has none. */
export function rich(text: string, values: Parameters<typeof filled>[1] = {}): TemplateResult {
  return html`${pieces(text).map((piece) => {
    switch (piece.kind) {
      case 'bold':
        return html`<b>${rich(piece.text, values)}</b>`
      case 'symbol':
        return html`<i>${piece.text}</i>`
      case 'dotted':
        return html`<i class="dotted">${piece.text}</i>`
      case 'twice':
        return html`<i class="dotted twice">${piece.text}</i>`
      case 'index':
        return html`<sub>${rich(piece.text)}</sub>`
      case 'power':
        return html`<sup>${piece.text}</sup>`
      default:
        return filled(piece.text, values)
    }
  })}`
}

/** As text inside a drawing, so that an exported picture has it as text. */
export function richSvg(text: string): TemplateResult {
  return svg`${pieces(text).map((piece) => {
    switch (piece.kind) {
      case 'bold':
        return svg`<tspan font-weight="650">${piece.text}</tspan>`
      case 'symbol':
        return svg`<tspan class="symbol">${piece.text}</tspan>`
      case 'dotted':
        // A full stop, raised: a mark that combines is not where it belongs in every font.
        return svg`<tspan class="symbol">${piece.text}</tspan><tspan class="symbol" dx="-0.3em" dy="-0.85em">.</tspan><tspan class="symbol" dx="0.06em" dy="0.85em">\u200b</tspan>`
      case 'twice':
        return svg`<tspan class="symbol">${piece.text}</tspan><tspan class="symbol" dx="-0.42em" dy="-0.85em">..</tspan><tspan class="symbol" dx="-0.06em" dy="0.85em">\u200b</tspan>`
      case 'index':
        return svg`<tspan dy="3" font-size="72%">${piece.text}</tspan><tspan dy="-3">\u200b</tspan>`
      case 'power':
        return svg`<tspan dy="-4" font-size="72%">${piece.text}</tspan><tspan dy="4">\u200b</tspan>`
      default:
        return piece.text || nothing
    }
  })}`
}

/** Without marks: for labels, titles, tables and speech. */
export function plain(text: string): string {
  return pieces(text)
    .map(({ kind, text: part }) => {
      if (kind === 'dotted') return `${part}\u0307`
      if (kind === 'twice') return `${part}\u0308`
      if (kind === 'power') return superscript(part)
      return kind === 'bold' ? plain(part) : part
    })
    .join('')
}

function superscript(text: string): string {
  return text.replace(/[−0-9]/g, (sign) => '⁻⁰¹²³⁴⁵⁶⁷⁸⁹'['−0123456789'.indexOf(sign)] ?? sign)
}

/** With {name} replaced. What is missing stays visible, so that a test finds it. */
export function filled(text: string, values: Readonly<Record<string, string | number>>): string {
  return text.replace(/\{([a-zA-Z]\w*)\}/g, (whole, name: string) => String(values[name] ?? whole))
}
