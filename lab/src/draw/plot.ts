// One plot: grid, ticks, hatching, curves, marks of what leaves the frame, labels and points. Plain numbers in, SVG out.
//
// The origin is the upper left corner of the plot itself; tick labels stand outside it, in the gutter of the page.

import { nothing, svg, type TemplateResult } from 'lit-html'
import { guard } from 'lit-html/directives/guard.js'
import { richSvg } from '../language/rich'
import { colourOf } from './clothes'
import { gaps, leavings, type Points, pathOf } from './curve'
import type { Scale, Tick } from './scale'

export interface Line extends Points {
  readonly clothes: string
  /** From the unit of the data to that of the axis. */
  readonly factor?: number
  /** Others are faded while one is pointed at. */
  readonly faded?: boolean
  readonly thick?: boolean
}

export interface Label {
  readonly x: number
  readonly y: number
  readonly text: string
  readonly anchor?: 'start' | 'middle' | 'end'
  readonly ink?: boolean
  readonly alarm?: boolean
}

interface Dot {
  readonly clothes: string
  readonly y: number
}

export interface PlotSpec {
  readonly width: number
  readonly height: number
  /** Pixels of 1 rem. */
  readonly rem: number
  readonly sx: Scale
  readonly sy: Scale
  readonly xs: readonly Tick[]
  readonly ys: readonly Tick[]
  /** Whether the x axis has its numbers here; else they stand at the plot below, and on a phone here too. */
  readonly xLabels: boolean
  readonly lines: readonly Line[]
  readonly hatched?: readonly (readonly [number, number])[]
  /** Dotted verticals with a label at the top. */
  readonly verticals?: readonly { readonly x: number; readonly text: string }[]
  /** Dashed horizontals. */
  readonly levels?: readonly number[]
  /** A function where finding their places takes time: it is asked only when the still part is drawn. */
  readonly labels?: readonly Label[] | (() => readonly Label[])
  readonly rings?: readonly { readonly x: number; readonly y: number }[]
  /** The line at the time shown, and the curves' points on it. */
  readonly now?: number
  readonly dots?: readonly Dot[]
  readonly under?: TemplateResult | typeof nothing
}

const whole = (value: number): number => Math.round(value) + 0.5

function grid({ sx, sy, xs, ys, width, height }: PlotSpec): TemplateResult {
  return svg`${xs.map((tick) => svg`<path class="grid-line" d="M${whole(sx(tick.value))} 0V${height}"/>`)}
    ${ys.map((tick) => svg`<path class=${tick.value === 0 ? 'zero-line' : 'grid-line'} d="M0 ${whole(sy(tick.value))}H${width}"/>`)}`
}

function tickLabels({ sx, sy, xs, ys, xLabels, width, height, rem }: PlotSpec): TemplateResult {
  const line = 0.875 * rem
  return svg`${ys.map((tick) => {
    const y = Math.min(sy(tick.value) + 0.35 * line, height + 0.1 * line)
    return svg`<text class="tick" x=${-0.5 * rem} y=${y.toFixed(1)} text-anchor="end">${richSvg(tick.text)}</text>`
  })}
  ${xs.map((tick) => {
    const x = sx(tick.value)
    const end = x > width - 0.5 * rem
    return svg`<text class="tick ${xLabels ? '' : 'own'}" x=${(end ? width : x).toFixed(1)} y=${(height + 0.5 * rem + 0.8 * line).toFixed(1)} text-anchor=${end ? 'end' : 'middle'}>${richSvg(tick.text)}</text>`
  })}`
}

/** Triangles in the colour of the curve, on the edge through which it goes. */
function leavingMarks(line: Line, { sx, sy, height, rem }: PlotSpec): TemplateResult {
  const low = Math.min(sy.low, sy.high)
  const high = Math.max(sy.low, sy.high)
  const slack = 1e-6 * (low > 0 ? low : high - low)
  const half = 0.3125 * rem
  const tall = 0.4375 * rem
  return svg`${leavings(line, low - slack, high + slack, line.factor ?? 1).map(({ x, up }) => {
    const px = sx(x).toFixed(1)
    const d = up
      ? `M${px} ${-tall - 1}l${half} ${tall}h${-2 * half}z`
      : `M${px} ${height + tall + 1}l${half} ${-tall}h${-2 * half}z`
    return svg`<path class="leaving" fill=${colourOf(line.clothes)} d=${d}/>`
  })}`
}

function label({ x, y, text, anchor = 'middle', ink, alarm }: Label): TemplateResult {
  return svg`<text class="label ${ink ? 'ink' : ''} ${alarm ? 'alarm' : ''}" x=${x.toFixed(1)} y=${y.toFixed(1)} text-anchor=${anchor}>${richSvg(text)}</text>`
}

/** All that does not move with time. */
function still(spec: PlotSpec): TemplateResult {
  const { width, height, sx, sy, lines, rem } = spec
  return svg`
    <svg width=${width} height=${height} class="clip">
      ${grid(spec)}
      ${spec.under ?? nothing}
      ${(spec.hatched ?? []).map(([from, to]) => svg`<rect class="hatched" fill="url(#hatch)" x=${sx(from).toFixed(1)} y="0" width=${(sx(to) - sx(from)).toFixed(1)} height=${height}/>`)}
      ${(spec.levels ?? []).map((value) => svg`<path class="level" d="M0 ${whole(sy(value))}H${width}"/>`)}
      ${(spec.verticals ?? []).map(({ x }) => svg`<path class="period-line" d="M${whole(sx(x))} 0V${height}"/>`)}
      <g transform="scale(0.1)">${lines.map(
        (line) =>
          svg`<path class="c ${line.clothes} ${line.faded ? 'faded' : ''} ${line.thick ? 'thick' : ''}" d=${pathOf(line, sx, sy, line.factor)}/>`,
      )}</g>
    </svg>
    ${lines.map((line) => leavingMarks(line, spec))}
    ${(spec.verticals ?? []).map(({ x, text }) => (sx(x) < width - 1.5 * rem ? label({ x: sx(x) + 0.25 * rem, y: 0.9 * rem, text, anchor: 'start' }) : nothing))}
    ${(typeof spec.labels === 'function' ? spec.labels() : (spec.labels ?? [])).map(label)}
    ${(spec.rings ?? []).map(({ x, y }) => svg`<circle class="ring" cx=${sx(x).toFixed(1)} cy=${sy(y).toFixed(1)} r=${0.5 * rem}/>`)}
    ${tickLabels(spec)}`
}

/** The plot. `about` is what its picture depends on, time apart: it is drawn again only when one of these changes. */
export function plot(spec: PlotSpec, about: readonly unknown[]): TemplateResult {
  const { width, height, sx, sy, now, rem } = spec
  const x = now === undefined ? 0 : sx(now)
  const shown = now !== undefined && x >= -0.5 && x <= width + 0.5
  return svg`<svg class="plot-drawing" width=${width} height=${height} viewBox="0 0 ${width} ${height}" aria-hidden="true">
    ${guard([...about, width, height, rem], () => still(spec))}
    ${
      shown
        ? svg`<path class="now-line" d="M${x.toFixed(1)} 0V${height}"/>
      ${(spec.dots ?? []).map(({ clothes, y }) => {
        const py = sy(y)
        if (!(py >= -1 && py <= height + 1)) return nothing
        return svg`<circle class="dot" cx=${x.toFixed(1)} cy=${py.toFixed(1)} r=${0.3125 * rem} fill=${colourOf(clothes)}/>`
      })}`
        : nothing
    }
  </svg>`
}

/** Where any of the lines has no value. */
export function hatchedRegions(lines: readonly Points[]): [number, number][] {
  const all = lines.flatMap(gaps).sort((a, b) => a[0] - b[0])
  const out: [number, number][] = []
  for (const [from, to] of all) {
    const last = out.at(-1)
    if (last && from <= last[1]) last[1] = Math.max(last[1], to)
    else out.push([from, to])
  }
  return out
}
