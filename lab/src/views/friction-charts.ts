// The damped motion over time: its angle with the turning points joined, and its energy, each beside the motion without friction.

import { html, nothing, svg, type TemplateResult } from 'lit-html'
import type { TableSpec } from '../columns'
import { extent } from '../draw/curve'
import { dotsOf } from '../draw/dots'
import { type Line, plot } from '../draw/plot'
import { degreeTicks, linearScale } from '../draw/scale'
import { plain } from '../language/rich'
import { remember } from '../memory'
import type { DampedMotion, Turning } from '../model/friction'
import { DEGREES } from '../number'
import { roundTicksOf, ticksAt } from './axis-ticks'
import { chart } from './chart'
import type { PlotSize } from './chart-spec'
import type { FrictionView, Tracks } from './friction-view'
import { timeScale, timeTicks } from './time-axis'

/** Upper and lower turning points: of two neighbours one is a highest and one a lowest angle. */
export function envelopeOf({ t, theta }: Turning): { x: Float64Array; y: Float64Array }[] {
  const count = t.length
  if (count < 3) return []
  const highFirst = (theta[0] as number) > (theta[1] as number) ? 0 : 1
  return [highFirst, 1 - highFirst].map((first) => {
    const pick = (values: Float64Array) => values.filter((_, i) => i % 2 === first)
    return { x: pick(t), y: pick(theta) }
  })
}

const envelope = remember((damped: DampedMotion) => envelopeOf(damped.turning))

/** Ends of the axis of angles, with a little room; the motion without friction is seen as far as it is there. */
function ends({ theta, free }: Tracks): [number, number] {
  const [low, high] = extent(theta).map((each) => each * DEGREES) as [number, number]
  const [freeLow, freeHigh] = extent(free).map((each) => each * DEGREES) as [number, number]
  // One that turns over would leave the damped one flat.
  const both = freeHigh - freeLow <= 361
  const least = both ? Math.min(low, freeLow) : low
  const most = both ? Math.max(high, freeHigh) : high
  const room = 0.06 * (most - least) || 1
  return [least - room, most + room]
}

function drawAngle({ page, damped, tracks, averaged }: FrictionView, size: PlotSize): TemplateResult {
  const { words, t, state } = page
  const { height, rem } = size
  const window = { from: 0, to: state.until }
  const [low, high] = ends(tracks)
  const sx = timeScale(window, size)
  const sy = linearScale([low, high], [height, 0])
  const ticks = degreeTicks(low, high, Math.min(7, Math.max(3, Math.floor(height / (1.15 * rem)))))
  const { times, theta, free } = tracks
  const joined: Line[] = damped.driven
    ? []
    : envelope(damped).map((each) => ({ ...each, clothes: 'c-envelope', factor: DEGREES }))
  const now = damped.at(t).theta * DEGREES
  const law = averaged && averaged.count > 0 ? averaged : null
  const part = (values: Float64Array) => ({
    x: (law?.t ?? values).subarray(0, law?.count),
    y: values.subarray(0, law?.count),
  })
  const dots =
    law &&
    [law.above, law.below].map(
      (values) => svg`<path class="averaged-dots" d=${dotsOf(part(values), sx, sy, DEGREES)}/>`,
    )
  return plot(
    {
      ...size,
      sx,
      sy,
      xs: timeTicks(words, window, size),
      ys: ticksAt(words, ticks, '°'),
      xLabels: false,
      lines: [
        { x: times, y: free, clothes: 'c-free', factor: DEGREES },
        ...joined,
        { x: times, y: theta, clothes: 'c-damped', factor: DEGREES },
      ],
      hatched: damped.rests,
      ...(dots ? { under: svg`<g transform="scale(0.1)">${dots}</g>` } : {}),
      now: t,
      dots: [{ clothes: 'c-exact', y: now }],
    },
    [tracks, words, averaged, averaged?.count],
  )
}

/** When half of the energy is lost; NaN where it is not. */
export const halfOf = remember((damped: DampedMotion): number => {
  const outcome = damped.driven ? null : damped.outcome()
  return outcome?.kind === 'halves' ? outcome.t : Number.NaN
})

function drawEnergy({ page, damped, tracks }: FrictionView, size: PlotSize): TemplateResult {
  const { words, t, state, motion } = page
  const { height, rem } = size
  const window = { from: 0, to: state.until }
  const most = 106 * Math.max(extent(tracks.energy)[1], motion.energyRatio) || 1
  const sx = timeScale(window, size)
  const sy = linearScale([0, most], [height, 0])
  const level = { x: Float64Array.of(0, state.until), y: Float64Array.of(motion.energyRatio, motion.energyRatio) }
  const half = halfOf(damped)
  return plot(
    {
      ...size,
      sx,
      sy,
      xs: timeTicks(words, window, size),
      ys: roundTicksOf(words, 0, most, Math.min(6, Math.max(3, Math.floor(height / (1.3 * rem))))),
      xLabels: true,
      lines: [
        { ...level, clothes: 'c-free', factor: 100 },
        { x: tracks.times, y: tracks.energy, clothes: 'c-damped', factor: 100 },
      ],
      hatched: damped.rests,
      verticals: half <= state.until ? [{ x: half, text: words.say.damped.half }] : [],
      now: t,
      dots: [{ clothes: 'c-exact', y: 100 * damped.energyAt(t) }],
    },
    [tracks, words],
  )
}

function tableOf({ page, tracks }: FrictionView): TableSpec {
  const { words } = page
  const { damped: say, table } = words.say
  const { times, theta, velocity, energy, free } = tracks
  return {
    caption: words.fill(table.caption, { plot: say.angle, unit: '°' }),
    file: 'friction',
    first: { title: table.time, values: times, factor: 1, decimals: 3 },
    columns: [
      { title: `_θ_, ${say.dampedColumn}`, values: theta, factor: DEGREES, decimals: 3 },
      { title: `_θ_, ${say.freeColumn}`, values: free, factor: DEGREES, decimals: 3 },
      { title: "_θ'_, rad/s", values: velocity, factor: 1, decimals: 4 },
      { title: `${say.energy}, %`, values: energy, factor: 100, decimals: 3 },
    ],
  }
}

export function dampedAngle(view: FrictionView): TemplateResult {
  const { page, damped, tracks } = view
  const { words, state } = page
  const say = words.say.damped
  const degrees = (value: number) => `${words.fixed(value * DEGREES, 1)}°`
  const [least, most] = extent(tracks.theta)
  return chart(page, {
    key: 'friction-angle',
    className: 'first-chart friction-angle',
    title: say.angle,
    unit: damped.driven || state.torque !== 0 ? say.angleUnitDriven : say.angleUnit,
    name: say.angle,
    height: 14,
    xLabels: false,
    window: { from: 0, to: state.until },
    draw: (size) => drawAngle(view, size),
    caption: words.fill(say.captionAngle, {
      to: words.with(words.given(state.until), words.say.units.s),
      least: degrees(least),
      most: degrees(most),
      count: damped.turning.t.length,
    }),
    spoken: `${words.fixed(page.t, 2)} s: ${degrees(damped.at(page.t).theta)}`,
    table: () => tableOf(view),
    sound: () => ({ values: tracks.theta, low: least, high: most }),
    note: html`${damped.reach < state.until ? html`<p class="plot-note">${words.fill(say.reached, { time: words.with(words.fixed(damped.reach, 1), words.say.units.s) })}</p>` : nothing}
      ${damped.rests.length > 0 ? html`<p class="plot-note">${say.held}</p>` : nothing}`,
  })
}

export function dampedEnergy(view: FrictionView): TemplateResult {
  const { page, damped, tracks } = view
  const { words, state } = page
  const say = words.say.damped
  const percent = (value: number) => words.percent(100 * value)
  return chart(page, {
    key: 'friction-energy',
    className: 'second-chart friction-energy',
    title: say.energy,
    unit: say.energyUnit,
    name: say.energy,
    height: 9,
    xLabels: true,
    window: { from: 0, to: state.until },
    draw: (size) => drawEnergy(view, size),
    caption: words.fill(say.captionEnergy, {
      first: percent(tracks.energy[0] as number),
      last: percent(tracks.energy[tracks.energy.length - 1] as number),
    }),
    spoken: `${words.fixed(page.t, 2)} s: ${plain(percent(damped.energyAt(page.t)))}`,
    table: () => tableOf(view),
    sound: () => ({ values: tracks.energy, low: 0, high: extent(tracks.energy)[1] }),
  })
}
