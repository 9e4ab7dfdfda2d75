// A drawing of the page as a file of its own: the styles of the page written into the elements, in the colours of the light theme.
//
// Other programs do not know `vector-effect`, a nested drawing that overflows, or the sizes of the page: strokes inside a scaled
// group are divided by its scale, and the plot becomes a group. Text stays text, with fonts that the reader's machine may have.

import { render, type TemplateResult } from 'lit-html'

/** Millimetres of one unit of a drawing: its text of 14 units is 10 points high. */
export const MM = 0.25
/** Pixels of 1 rem while a picture is drawn, whatever the screen. */
export const REM = 16

const FONTS = {
  sans: "'Libration Sans', 'Source Sans 3', 'Source Sans Pro', system-ui, sans-serif",
  math: "'Libration Math', 'STIX Two Text', Georgia, serif",
}

/** What is written where it is not the initial value. */
const INITIAL: Readonly<Record<string, string>> = {
  fill: '#000000',
  stroke: 'none',
  'stroke-width': '1',
  'stroke-dasharray': 'none',
  'stroke-linecap': 'butt',
  'stroke-linejoin': 'miter',
  opacity: '1',
  'paint-order': 'normal',
}
const OF_STROKES = ['stroke-width', 'stroke-dasharray', 'stroke-linecap', 'stroke-linejoin']
const OF_TEXT = ['font-family', 'font-size', 'font-style', 'font-weight'] as const

const number = (value: number): string => String(Number(value.toFixed(3)))

function colour(value: string): string {
  const parts = value.match(/^rgba?\((\d+), (\d+), (\d+)(?:, ([\d.]+))?\)$/)
  if (!parts) return value.replace(/"/g, '')
  if (parts[4] !== undefined && Number(parts[4]) === 0) return 'none'
  return `#${[1, 2, 3].map((at) => Number(parts[at]).toString(16).padStart(2, '0')).join('')}`
}

/** A property as it is written; lengths in units of the group that the element is in. */
function written(name: string, style: CSSStyleDeclaration, scale: number): string {
  const value = style.getPropertyValue(name)
  const fixed = style.getPropertyValue('vector-effect') === 'non-scaling-stroke'
  const lengths = (text: string) =>
    text.replace(/([\d.e-]+)px/g, (_, size: string) => number(Number(size) / (fixed ? scale : 1)))
  switch (name) {
    case 'fill':
    case 'stroke':
      return colour(value)
    case 'stroke-width':
    case 'stroke-dasharray':
      return lengths(value)
    case 'font-size':
      return number(Number.parseFloat(value))
    case 'font-family':
      return value.includes('Math') ? FONTS.math : FONTS.sans
    default:
      return value
  }
}

const SVG = 'http://www.w3.org/2000/svg'

/** A letter that stands over a plot in the page, as text in it. */
function letter(from: HTMLElement, style: CSSStyleDeclaration): SVGTextElement {
  const size = Number.parseFloat(style.fontSize)
  const text = document.createElementNS(SVG, 'text')
  text.textContent = from.textContent
  const attributes = {
    x: number(Number.parseFloat(from.style.left)),
    y: number(Number.parseFloat(from.style.top) + 0.35 * size),
    'text-anchor': 'middle',
    fill: colour(style.color),
    // As the paper around it in the page.
    stroke: colour(style.backgroundColor),
    'stroke-width': '4',
    'stroke-linejoin': 'round',
    'paint-order': 'stroke',
    'font-family': FONTS.sans,
    'font-size': number(size),
    'font-weight': style.fontWeight,
  }
  for (const [name, value] of Object.entries(attributes)) text.setAttribute(name, value)
  return text
}

function scaleOf(element: Element): number {
  return Number(/scale\(([\d.]+)\)/.exec(element.getAttribute('transform') ?? '')?.[1] ?? 1)
}

/** Writes the styles of an element of the page into its copy, and those of all that is in it. */
function inline(from: Element, to: Element, outer: number): void {
  const scale = outer * scaleOf(from)
  const style = getComputedStyle(from)
  if (from.classList.contains('letter-mark')) {
    to.replaceWith(letter(from as HTMLElement, style))
    return
  }
  // What stands over a drawing without a letter is at the time shown.
  const empty = to.localName === 'text' && to.textContent === ''
  if (empty || style.display === 'none' || to.namespaceURI !== SVG) {
    to.remove()
    return
  }
  const group = ['g', 'svg', 'defs', 'pattern'].includes(to.localName)
  const text = to.localName === 'text' || to.localName === 'tspan'
  if (!['title', 'desc'].includes(to.localName)) {
    const names = group ? ['opacity'] : Object.keys(INITIAL)
    for (const name of names) {
      const value = written(name, style, scale)
      const unstroked = OF_STROKES.includes(name) && style.stroke === 'none'
      if (value === INITIAL[name] || unstroked || (to.localName === 'tspan' && name === 'opacity'))
        to.removeAttribute(name)
      else to.setAttribute(name, value)
    }
    if (text) for (const name of OF_TEXT) to.setAttribute(name, written(name, style, scale))
  }
  for (const name of ['class', 'style', 'aria-hidden']) to.removeAttribute(name)
  // The copies first, since some of them are taken out.
  const copies = [...to.children]
  for (const [i, child] of Array.from(from.children).entries()) inline(child, copies[i] as Element, scale)
}

/** The plot as a group: in other programs a drawing inside a drawing is cut off at its edges, with the numbers at the axes. */
function opened(drawing: Element): void {
  for (const nested of drawing.querySelectorAll('svg[viewBox]')) {
    const group = document.createElementNS(SVG, 'g')
    group.append(...nested.childNodes)
    nested.replaceWith(group)
  }
}

/** Without the marks in which the renderer keeps its places. */
function withoutComments(drawing: Element): void {
  const walker = document.createTreeWalker(drawing, NodeFilter.SHOW_COMMENT)
  const found: Node[] = []
  while (walker.nextNode()) found.push(walker.currentNode)
  for (const each of found) each.parentNode?.removeChild(each)
}

/** Draws pictures outside of what is seen; kept while a film is made, closed after. */
export class Studio {
  readonly #host = document.createElement('div')

  /** `className` is of the frame in the page that the styles ask for. */
  constructor(className: string) {
    this.#host.className = `picture ${className}`
    this.#host.setAttribute('aria-hidden', 'true')
    document.body.append(this.#host)
  }

  /** The file of a template whose root is an <svg> with a viewBox in units of the page. */
  draw(template: TemplateResult): string {
    render(template, this.#host)
    const drawing = this.#host.querySelector('svg') as SVGSVGElement
    // The same picture wherever the pointer is.
    for (const each of drawing.querySelectorAll('.faded')) each.classList.remove('faded')
    const copy = drawing.cloneNode(true) as SVGSVGElement
    inline(drawing, copy, 1)
    opened(copy)
    withoutComments(copy)
    const { width, height } = drawing.viewBox.baseVal
    copy.setAttribute('width', `${number(width * MM)}mm`)
    copy.setAttribute('height', `${number(height * MM)}mm`)
    return `<?xml version="1.0" encoding="UTF-8"?>\n${new XMLSerializer().serializeToString(copy)}\n`
  }

  close(): void {
    this.#host.remove()
  }
}

/** One picture, drawn while the page is light and 1 rem is 16 pixels: the same file from every screen. Nothing of it is seen. */
export function svgFile(className: string, template: TemplateResult): string {
  const studio = new Studio(className)
  const { style, dataset } = document.documentElement
  const { fontSize } = style
  const { theme } = dataset
  try {
    style.fontSize = `${REM}px`
    dataset.theme = 'light'
    return studio.draw(template)
  } finally {
    style.fontSize = fontSize
    if (theme === undefined) delete dataset.theme
    else dataset.theme = theme
    studio.close()
  }
}
