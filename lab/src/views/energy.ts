// The energy over time: of step-by-step solutions the total, which drifts; else its two parts and their sum.

import { html, nothing, type TemplateResult } from 'lit-html'
import type { Column } from '../columns'
import { switches } from '../controls/parts'
import { extent } from '../draw/curve'
import { type Line, plot } from '../draw/plot'
import { linearScale, roundTicks } from '../draw/scale'
import { type Study, showsTotal } from '../study'
import { ticksAt } from './axis-ticks'
import { chart } from './chart'
import type { PlotSize } from './chart-spec'
import { curveColumn, curveName } from './compare'
import type { Live } from './page'
import { periodMarks, periodVerticals, timeScale, timeText, timeTicks } from './time-axis'

/** Per cent of the energy at the top. */
const FACTOR = 100
/** As a part of the energy at the top. */
const LEAST_DRIFT = 2e-3

function lines(page: Live, study: Study, total: boolean): Line[] {
  const x = study.times
  const { pointed } = page.session
  // It does not change: a line from end to end.
  const ends = Float64Array.of(study.window.from, study.window.to)
  const exact: Line = {
    x: ends,
    y: study.total.subarray(0, 2),
    clothes: 'c-exact',
    factor: FACTOR,
    faded: pointed !== null,
  }
  if (!total) {
    return [
      { x, y: study.parts().potential, clothes: 'c-potential', factor: FACTOR },
      { x, y: study.parts().kinetic, clothes: 'c-kinetic', factor: FACTOR },
      exact,
    ]
  }
  const others = study.shown.map(
    (drawn): Line => ({
      ...drawn.energy,
      clothes: drawn.clothes,
      factor: FACTOR,
      faded: pointed !== null && pointed !== drawn.key,
    }),
  )
  return [exact, ...numericalOnly(study, others)]
}

/** The energy of a formula that is not a motion says nothing: only of solutions that step. */
function numericalOnly<T>(study: Study, all: readonly T[]): T[] {
  return all.filter((_, i) => study.shown[i]?.numerical)
}

function domain(study: Study, total: boolean): [number, number] {
  if (!total) {
    const [, high] = extent(study.total)
    return [0, 1.12 * FACTOR * Math.max(high, 1e-9)]
  }
  let [low, high] = extent(study.total)
  for (const { energy, numerical } of study.shown) {
    if (!numerical) continue
    const [a, b] = extent(energy.y)
    low = Math.min(low, a)
    high = Math.max(high, b)
  }
  const middle = study.motion.energyRatio
  // A drift below a fifth of a per cent is flat: no axis is spent on it.
  const least = Math.max(LEAST_DRIFT, high - low)
  // Fitted to the drift; a drift of many times the energy leaves the plot with a mark.
  const top = Math.min(high, middle + 4 * Math.max(middle, 0.05))
  return [FACTOR * (low - 0.25 * least), FACTOR * (top + 0.25 * least)]
}

/** Two ticks at least: where round numbers leave one, the outermost of finer ones. */
export function energyTicks([low, high]: readonly [number, number], most: number): number[] {
  const values = roundTicks(low, high, Math.max(2, most))
  if (values.length > 1) return values
  const finer = roundTicks(low, high, 6)
  return [finer[0] as number, finer.at(-1) as number]
}

function draw(page: Live, study: Study, total: boolean, size: PlotSize): TemplateResult {
  const { words, t, session } = page
  const { height, rem } = size
  const ends = domain(study, total)
  const sy = linearScale(ends, [height, 0])
  const { plots } = words.say
  const near = ends[0] < 100 && ends[1] > 100
  const y = sy(100) > 1.1 * rem ? sy(100) - 0.3 * rem : sy(100) + 0.9 * rem
  const labels = near ? [{ x: 0.25 * rem, y, text: plots.top, anchor: 'start' as const }] : []
  return plot(
    {
      ...size,
      sx: timeScale(study.window, size),
      sy,
      xs: timeTicks(words, study.window, size),
      ys: ticksAt(words, energyTicks(ends, Math.floor(height / (1.25 * rem)))),
      xLabels: true,
      lines: lines(page, study, total),
      levels: near ? [100] : [],
      labels,
      verticals: periodVerticals(page, study, periodMarks(study)).map(({ x }) => ({ x, text: '' })),
      now: t,
    },
    [study, total, sy.key, words, session.pointed],
  )
}

function columns(page: Live, study: Study, total: boolean): Column[] {
  const { words } = page
  const { plots } = words.say
  const numbers = { factor: FACTOR, decimals: 4 }
  if (!total) {
    const { kinetic, potential } = study.parts()
    return [
      { title: plots.kinetic, clothes: 'c-kinetic', values: kinetic, ...numbers },
      { title: plots.potential, clothes: 'c-potential', values: potential, ...numbers },
      { title: plots.sum, clothes: 'c-exact', values: study.total, ...numbers },
    ]
  }
  const stepping = study.shown.filter(({ numerical }) => numerical)
  return [
    { ...curveColumn(page), values: study.total, ...numbers },
    ...stepping.map((drawn) => ({ ...curveColumn(page, drawn), values: drawn.energy.y, ...numbers })),
  ]
}

function caption(page: Live, study: Study): string {
  const { words } = page
  const { plots } = words.say
  const percent = (part: number) => words.percent(100 * part, 4)
  const exact = words.fill(plots.captionEnergy, { energy: percent(study.motion.energyRatio) })
  const drifts = study.shown
    .filter(({ numerical }) => numerical)
    .map(({ curve, energy }) => {
      const [low, high] = extent(energy.y)
      return words.fill(plots.captionDrift, { name: curveName(page, curve), least: percent(low), most: percent(high) })
    })
  return [exact, ...drifts].join(' ')
}

function sample(clothes: string): TemplateResult {
  return html`<svg viewBox="0 0 24 8"><path class="c ${clothes}" d="M0 4H24"/></svg>`
}

export function energyChart(page: Live, study: Study): TemplateResult {
  const { words, state, store } = page
  const { plots } = words.say
  const total = showsTotal(state, study)
  const values = total
    ? (study.shown.find(({ numerical }) => numerical)?.energy.y ?? study.total)
    : study.parts().kinetic
  const key = html`<span class="parts-key" aria-hidden="true">${sample('c-kinetic')}${plots.kinetic} ${sample('c-potential')}${plots.potential}</span>`
  return chart(page, {
    key: 'energy',
    className: 'third-chart',
    title: total ? plots.totalTitle : plots.partsTitle,
    unit: plots.energyUnit,
    name: total ? plots.totalTitle : plots.partsTitle,
    height: 4.25,
    xLabels: true,
    switches: html`${total ? nothing : key}${switches(
      plots.shows,
      [
        { value: 'total' as const, text: plots.total },
        { value: 'parts' as const, text: plots.parts },
      ],
      total ? 'total' : 'parts',
      (energy) => store.set({ energy }),
    )}`,
    draw: (size) => draw(page, study, total, size),
    caption: () => caption(page, study),
    spoken: () => `${timeText(words, page.t)}. ${caption(page, study)}`,
    window: study.window,
    table: () => ({
      caption: words.fill(words.say.table.caption, {
        plot: total ? plots.totalTitle : plots.partsTitle,
        unit: plots.energyUnit,
      }),
      file: 'energy',
      first: { title: words.say.table.time, values: study.times, factor: 1, decimals: 3 },
      columns: columns(page, study, total),
    }),
    sound: () => {
      const [low, high] = extent(values)
      return { values, low, high }
    },
  })
}
