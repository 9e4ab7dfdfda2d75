// Pictures to take along: a chart with its title and a key of its curves, and the drawn pendulum, each as one <svg>.

import { html, nothing, svg, type TemplateResult } from 'lit-html'
import { BOX, type PendulumSpec, pendulum, spot } from '../draw/pendulum'
import { plain, richSvg } from '../language/rich'
import { MM, REM } from '../save/svg'
import type { ChartSpec } from './chart-spec'

/** Units around the plot: 640 wide in all, which is 160 mm. */
const WIDTH = 640
const EDGE = { left: 72, right: 24, top: 38, bottom: 32 } as const
const ROW = 22
/** The line of a key, and what is before and after it. */
const SAMPLE = { width: 40, gap: 8, after: 18 } as const
/** Room for a wider font: a machine may not have ours. */
const WIDER = 1.2
/** Around the box of the pendulum, where names of angles stand. */
const ROUND = { x: 14, y: 6 } as const

export const CHART_MM = WIDTH * MM
export const PENDULUM_MM = (BOX.width + 2 * ROUND.x) * MM

let ruler: CanvasRenderingContext2D | null = null

function textWidth(text: string): number {
  ruler ??= document.createElement('canvas').getContext('2d')
  if (!ruler) return 7 * text.length
  ruler.font = '14px "Libration Sans"'
  return ruler.measureText(text).width
}

interface Keyed {
  readonly text: string
  readonly clothes: string
  readonly x: number
  readonly row: number
}

/** Names beside their lines, in rows as wide as the plot. */
function keyOf(spec: ChartSpec): Keyed[] {
  let [x, row] = [0, 0]
  return (spec.table?.().columns ?? []).flatMap(({ title, clothes }) => {
    if (clothes === undefined) return []
    const text = plain(title)
    const width = SAMPLE.width + SAMPLE.gap + WIDER * textWidth(text)
    if (x > 0 && x + width > WIDTH - EDGE.left - EDGE.right) [x, row] = [0, row + 1]
    const placed = { text, clothes, x, row }
    x += width + SAMPLE.after
    return [placed]
  })
}

function framed(
  width: number,
  height: number,
  title: string,
  about: string,
  corner: string,
  inside: TemplateResult,
): TemplateResult {
  return html`<svg xmlns="http://www.w3.org/2000/svg" viewBox="${corner} ${width} ${height}"><title>${title}</title><desc>${about}</desc><defs><pattern id="hatch" width="8" height="8" patternUnits="userSpaceOnUse" patternTransform="rotate(45)"><path d="M0 0V8" stroke="var(--edge)" stroke-width="1" opacity="0.8"/></pattern></defs>${inside}</svg>`
}

const text = (of: string | (() => string)): string => plain(typeof of === 'string' ? of : of())

/** A chart; `about` is put behind its sentence in the description. */
export function chartPicture(spec: ChartSpec, about: string): TemplateResult {
  const height = spec.height * REM
  const key = keyOf(spec)
  const rows = key.length === 0 ? 0 : (key.at(-1)?.row ?? 0) + 1
  const below = EDGE.top + height + EDGE.bottom
  const all = below + (rows > 0 ? rows * ROW + 8 : 0)
  const size = { width: WIDTH - EDGE.left - EDGE.right, height, rem: REM }
  const head = svg`<text class="picture-title" x=${EDGE.left} y="20">${richSvg(spec.title)}${spec.unit ? svg`<tspan class="picture-unit" dx="8">${richSvg(spec.unit)}</tspan>` : nothing}</text>`
  const names = key.map(({ text: name, clothes, x, row }) => {
    const y = below + 10 + row * ROW
    return svg`<path class="c ${clothes}" d="M${EDGE.left + x} ${y}h${SAMPLE.width}"/><text class="picture-key" x=${EDGE.left + x + SAMPLE.width + SAMPLE.gap} y=${y + 5}>${name}</text>`
  })
  const inside = svg`<path class="picture-paper" d="M0 0H${WIDTH}V${all}H0Z"/>${head}<g transform="translate(${EDGE.left} ${EDGE.top})">${spec.draw(size)}</g>${names}`
  return framed(WIDTH, all, plain(spec.title), `${text(spec.caption)} ${about}`, '0 0', inside)
}

/** The pendulum with its bob. */
export function pendulumPicture(spec: PendulumSpec, title: string, about: string): TemplateResult {
  const [width, height] = [BOX.width + 2 * ROUND.x, BOX.height + 2 * ROUND.y]
  const at = spot(spec.angle)
  const inside = svg`<path class="picture-paper" d="M${-ROUND.x} ${-ROUND.y}h${width}v${height}h${-width}Z"/>${pendulum(spec)}<circle class="bob" cx=${at.x.toFixed(2)} cy=${at.y.toFixed(2)} r="10"/>`
  return framed(width, height, title, about, `${-ROUND.x} ${-ROUND.y}`, inside)
}

/** Pixels of a film so wide: whole and even, as H.264 asks. */
export function filmHeight(width: number): number {
  return 2 * Math.round((width * (BOX.height + 2 * ROUND.y)) / (BOX.width + 2 * ROUND.x) / 2)
}
