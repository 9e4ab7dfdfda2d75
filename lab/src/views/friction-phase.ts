// The damped motion in the phase plane: a spiral into the rest, and of a driven pendulum its Poincaré section.

import { html, svg, type TemplateResult } from 'lit-html'
import type { TableSpec } from '../columns'
import { extent, type Points, pathOf } from '../draw/curve'
import { dotsOf } from '../draw/dots'
import { plot } from '../draw/plot'
import { linearScale, roundTicks, roundUp, type Scale } from '../draw/scale'
import { startRing } from '../draw/start-ring'
import { remember } from '../memory'
import type { Section } from '../model/section'
import { DEGREES } from '../number'
import { roundTicksOf, ticksAt } from './axis-ticks'
import { chart } from './chart'
import type { PlotSize } from './chart-spec'
import type { FrictionView, Tracks } from './friction-view'
import type { Live } from './page'
import { background, withinTurn } from './portrait'

/** Within one turn, in degrees: where it goes over the top the line is lifted. */
export function withinOneTurn(theta: Float64Array, velocity: Float64Array): { x: Float64Array; y: Float64Array } {
  const [x, y]: [number[], number[]] = [[], []]
  let before = Number.NaN
  theta.forEach((angle, i) => {
    const here = withinTurn(angle)
    if (Math.abs(here - before) > Math.PI) {
      x.push(here * DEGREES)
      y.push(Number.NaN)
    }
    before = here
    x.push(here * DEGREES)
    y.push(velocity[i] as number)
  })
  return { x: Float64Array.from(x), y: Float64Array.from(y) }
}

const spiralOf = remember((tracks: Tracks) => withinOneTurn(tracks.theta, tracks.velocity))

/** Of all angles, or of those of a motion that stays near the bottom. */
function spiralScales({ x, y }: Points, { width, height }: PlotSize): { sx: Scale; sy: Scale } {
  const farthest = (values: Float64Array) => Math.max(...extent(values).map(Math.abs))
  const most = farthest(x)
  const reach = most > 100 ? 180 : roundUp(1.08 * most || 1)
  const fastest = roundUp(1.08 * farthest(y) || 1)
  return { sx: linearScale([-reach, reach], [0, width]), sy: linearScale([-fastest, fastest], [height, 0]) }
}

function axes({ words }: Live, sx: Scale, sy: Scale) {
  const angles = sx.high === 180 ? [-180, -90, 0, 90, 180] : roundTicks(sx.low, sx.high, 5)
  return { xs: ticksAt(words, angles, '°'), ys: roundTicksOf(words, sy.low, sy.high, 5) }
}

function drawSpiral({ page, damped, tracks }: FrictionView, size: PlotSize): TemplateResult {
  const { words, motion, t, state } = page
  const spiral = spiralOf(tracks)
  const { sx, sy } = spiralScales(spiral, size)
  const separatrix = background(motion).separatrix.map(
    (each) => svg`<path class="separatrix" d=${pathOf(each, sx, sy)}/>`,
  )
  const drawing = plot(
    {
      ...size,
      sx,
      sy,
      ...axes(page, sx, sy),
      xLabels: true,
      lines: [{ ...spiral, clothes: 'c-damped' }],
      under: svg`<g transform="scale(0.1)">${separatrix}</g>`,
    },
    [tracks, words],
  )
  const start = startRing(sx(withinTurn(state.theta0) * DEGREES), sy(state.velocity0), size)
  const { theta, velocity } = damped.at(t)
  return html`${drawing}${start}<b class="orbit-spot" style="left:${sx(withinTurn(theta) * DEGREES).toFixed(1)}px;top:${sy(velocity).toFixed(1)}px"></b>`
}

/** Least span of the velocities of a section, as a part of that of the phase portrait: rounding is not drawn large. */
const LEAST_SPAN = 0.25

/** Ends of the axis of velocities of a section. */
export function sectionEnds(velocities: Float64Array, portrait: number): [number, number] {
  const [low, high] = velocities.length === 0 ? [-1, 1] : extent(velocities)
  const middle = (low + high) / 2
  const half = Math.max(0.62 * (high - low), (LEAST_SPAN / 2) * portrait)
  return [middle - half, middle + half]
}

function drawSection({ page, tracks }: FrictionView, section: Section, size: PlotSize): TemplateResult {
  const { words } = page
  const { angles, velocities, count, repeats } = section
  // Of a motion that repeats its cycle is drawn: without what the start has left in it.
  const from = repeats === null ? 0 : count - repeats
  const [x, y] = [angles.subarray(from, count), velocities.subarray(from, count)]
  const portrait = spiralScales(spiralOf(tracks), size).sy
  const sx = linearScale([-180, 180], [0, size.width])
  const sy = linearScale(sectionEnds(y, portrait.high - portrait.low), [size.height, 0])
  const few = repeats === null ? '' : 'few'
  return plot(
    {
      ...size,
      sx,
      sy,
      ...axes(page, sx, sy),
      xLabels: true,
      lines: [],
      under: svg`<g transform="scale(0.1)"><path class="section-dots ${few}" d=${dotsOf({ x, y }, sx, sy, 1, DEGREES)}/></g>`,
    },
    [section, count, words, sy.key],
  )
}

function spiralTable({ page, tracks }: FrictionView): TableSpec {
  const { words } = page
  const { damped: say, table } = words.say
  const { times, theta, velocity } = tracks
  return {
    caption: words.fill(table.caption, { plot: say.phase, unit: 'rad/s' }),
    file: 'friction-phase',
    first: { title: table.time, values: times, factor: 1, decimals: 3 },
    columns: [
      { title: '_θ_, °', values: theta.map(withinTurn), factor: DEGREES, decimals: 3 },
      { title: "_θ'_, rad/s", values: velocity, factor: 1, decimals: 4 },
    ],
  }
}

function sectionTable({ page }: FrictionView, { angles, velocities, count }: Section): TableSpec {
  const { words } = page
  const { damped: say, table } = words.say
  return {
    caption: words.fill(table.caption, { plot: say.section, unit: 'rad/s' }),
    file: 'section',
    first: { title: '_n_', values: Float64Array.from({ length: count }, (_, i) => i + 1), factor: 1, decimals: 0 },
    columns: [
      { title: '_θ_, °', values: angles.slice(0, count), factor: DEGREES, decimals: 3 },
      { title: "_θ'_, rad/s", values: velocities.slice(0, count), factor: 1, decimals: 4 },
    ],
  }
}

export function spiralChart(view: FrictionView): TemplateResult {
  const { page } = view
  const { words, state } = page
  const say = words.say.damped
  return chart(page, {
    key: 'friction-phase',
    className: 'friction-phase',
    title: say.phase,
    unit: say.phaseUnit,
    name: say.phase,
    height: 13,
    xLabels: true,
    draw: (size) => drawSpiral(view, size),
    caption: words.fill(say.captionPhase, { to: words.with(words.given(state.until), words.say.units.s) }),
    table: () => spiralTable(view),
  })
}

export function sectionChart(view: FrictionView, section: Section): TemplateResult {
  const { page } = view
  const { words } = page
  const say = words.say.damped
  const { count, most, done } = section
  const points = words.fill(say.points, { count, most })
  return chart(page, {
    key: 'friction-section',
    className: 'friction-section',
    title: say.section,
    unit: say.sectionUnit,
    name: say.section,
    height: 13,
    xLabels: true,
    draw: (size) => drawSection(view, section, size),
    caption: words.fill(say.captionSection, { count }),
    table: () => sectionTable(view, section),
    note: html`<p class="plot-note section-progress">${done ? points : html`<progress max=${most} .value=${count} aria-label=${say.progress}></progress> ${points}`}</p>`,
  })
}
