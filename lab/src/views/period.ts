// The period against the amplitude: exact, and every formula of the registry; below, their errors. One amplitude goes through both.

import { html, nothing, svg, type TemplateResult } from 'lit-html'
import type { TableSpec } from '../columns'
import { switches } from '../controls/parts'
import { afterKey, partAlong } from '../controls/slide'
import { pathOf } from '../draw/curve'
import { placedLabels } from '../draw/labels'
import { type Line, plot } from '../draw/plot'
import { linearScale, logScale, roundTicks, type Scale, type Tick } from '../draw/scale'
import { plain, rich } from '../language/rich'
import { remember } from '../memory'
import type { Model } from '../model'
import { degrees, radians } from '../number'
import {
  AMPLITUDES,
  nearestOf,
  type PeriodResult,
  periodAt,
  periodCurve,
  periodResults,
  TABLE_ROWS,
} from '../period-study'
import { periodKind, periodRows } from '../periods'
import { amplitudeOf, amplitudeValue, angleText, release } from './amplitude'
import { chart } from './chart'
import type { Cursor, PlotSize } from './chart-spec'
import { formulaList, formulaName, formulaShort, signedPercent } from './formula-list'
import type { Live } from './page'

const resultsOf = remember(
  (model: Model, periods: readonly string[] | null, thetaMax: number, order: 'registry' | 'error') =>
    periodResults(model, periodRows(periods), thetaMax, order),
)

/** Of all formulas, at the amplitude of the motion; NaN where it has none. */
function resultsNow(page: Live): PeriodResult[] {
  const { model, state } = page
  const amplitude = amplitudeOf(page)
  return resultsOf(model, state.periods, amplitude === null ? Number.NaN : radians(amplitude), state.periodOrder)
}

/** In the order of the registry, so that curves do not change places with the sort. */
const shownRows = (page: Live) => periodRows(page.state.periods).filter(({ on }) => on)

function cursorOf(page: Live, label: string, text: string): Cursor {
  const amplitude = amplitudeOf(page) ?? 180
  const { store } = page
  return {
    label,
    least: 0,
    most: 180,
    now: amplitude,
    text,
    key: (event) => {
      // As it is now: a second key may come before the page is drawn again.
      const { theta0, velocity0 } = store.state
      const value = velocity0 === 0 ? degrees(Math.abs(theta0)) : amplitude
      const next = afterKey(event, { value, least: 0, most: 180, step: 1 })
      if (next !== null) release(page, next)
      return next !== null
    },
    drag: {
      begin: () => store.setSession({ held: 'amplitude' }),
      at: (x, _, element) => release(page, Math.round(180 * partAlong(x, element))),
      end: () => store.setSession({ held: null }),
    },
  }
}

function amplitudeTicks({ words }: Live, { width, rem }: PlotSize): Tick[] {
  const values = width < 26 * rem ? [0, 60, 120, 180] : [0, 30, 60, 90, 120, 150, 180]
  return values.map((each) => ({ value: each, text: `${words.typed(each)}°` }))
}

const RATIO_ENDS = [0.8, 4] as const

function drawRatio(page: Live, size: PlotSize): TemplateResult {
  const { model, words, session, state } = page
  const { period } = words.say
  const { height, rem, width } = size
  const sx = linearScale([0, 180], [0, width])
  const sy = linearScale(RATIO_ENDS, [height, 0])
  const rows = shownRows(page)
  const amplitude = amplitudeOf(page)
  const exact = periodCurve(model, 'exact')
  const lines: Line[] = [
    ...rows.map(({ key, name }) => ({
      x: AMPLITUDES,
      y: periodCurve(model, key).ratio,
      clothes: periodKind(name).clothes,
      faded: session.pointed !== null && session.pointed !== name,
    })),
    {
      x: AMPLITUDES,
      y: exact.ratio,
      clothes: 'c-exact',
      faded: session.pointed !== null && session.pointed !== 'exact',
    },
  ]
  const now = amplitude ?? Number.NaN
  const ratio = amplitude === null ? Number.NaN : periodAt(model, 'exact', radians(amplitude)).ratio
  const y = Math.max(sy(Math.min(ratio, 3.2)) - 1.4 * rem, 1.9 * rem)
  const left = sx(now) > 9 * rem
  const value = Number.isFinite(ratio) ? words.fixed(ratio, 4) : words.say.facts.infinite
  const reading = words.fill(period.reading, { ratio: value })
  const drawing = plot(
    {
      ...size,
      sx,
      sy,
      xs: amplitudeTicks(page, size),
      ys: [1, 2, 3, 4].map((each) => ({ value: each, text: words.typed(each) })),
      xLabels: false,
      lines,
      now,
      dots: Number.isFinite(ratio) ? [{ clothes: 'c-exact', y: ratio }] : [],
    },
    [model, state.periods, words, session.pointed],
  )
  const beside = now > 120 && now < 172 ? sx(now) - 0.5 * rem : sx(158)
  const limit = html`<span class="period-reading left limit" aria-hidden="true" style="left:${beside.toFixed(1)}px;top:${1.25 * rem}px">${period.noLimit}</span>`
  if (amplitude === null) return html`${drawing}${limit}`
  return html`${drawing}${limit}<span class="period-reading ${left ? 'left' : ''}" aria-hidden="true" style="left:${sx(now).toFixed(1)}px;top:${y.toFixed(1)}px">${rich(reading)}</span>`
}

const LOG_ENDS = [1e-5, 200] as const
const LINEAR_ENDS = [-60, 60] as const

function errorScale(page: Live, height: number): { sy: Scale; ys: Tick[]; log: boolean } {
  const { words, state } = page
  if (state.periodAxis === 'linear') {
    const values = roundTicks(-60, 60, 7)
    return {
      log: false,
      sy: linearScale(LINEAR_ENDS, [height, 0]),
      ys: values.map((each) => ({ value: each, text: words.fixed(each, 0) })),
    }
  }
  const powers = [-5, -4, -3, -2, -1, 0, 1, 2]
  return {
    log: true,
    sy: logScale(LOG_ENDS, [height, 0]),
    ys: powers.map((power) => ({ value: 10 ** power, text: words.fixed(10 ** power, Math.max(0, -power)) })),
  }
}

function drawError(page: Live, size: PlotSize): TemplateResult {
  const { model, words, session, state } = page
  const { height, rem, width } = size
  const sx = linearScale([0, 180], [0, width])
  const { sy, ys, log } = errorScale(page, height)
  const rows = shownRows(page)
  const amplitude = amplitudeOf(page)
  const faded = (name: string) => session.pointed !== null && session.pointed !== name
  const lines: Line[] = rows.map(({ key, name }) => {
    const { size: sizes, error } = periodCurve(model, key)
    return { x: AMPLITUDES, y: log ? sizes : error, clothes: periodKind(name).clothes, factor: 100, faded: faded(name) }
  })
  const halos = rows.flatMap(({ key, name }) => {
    const { stated, error } = periodCurve(model, key)
    if (!stated) return []
    const y = log ? stated : signedStated(stated, error)
    const d = pathOf({ x: AMPLITUDES, y }, sx, sy, 100)
    return [svg`<path class="c halo ${periodKind(name).clothes} ${faded(name) ? 'faded' : ''}" d=${d}/>`]
  })
  const names = rows.map(({ key, name }, i) => ({
    ...(lines[i] as Line),
    text: plain(formulaName(page, name, key)),
  }))
  const labels = () =>
    log
      ? placedLabels(names, { sx, sy, width, height, letter: 0.46 * rem, line: 0.95 * rem }).map(({ x, y, text }) => ({
          x,
          y: y + 0.3 * rem,
          text,
          ink: true,
        }))
      : []
  const dots =
    amplitude === null
      ? []
      : rows.map(({ key, name }) => {
          const { error } = periodAt(model, key, radians(amplitude))
          return { clothes: periodKind(name).clothes, y: 100 * (log ? Math.abs(error) : error) }
        })
  const drawing = plot(
    {
      ...size,
      sx,
      sy,
      xs: amplitudeTicks(page, size),
      ys,
      xLabels: true,
      lines,
      labels,
      under: svg`<g transform="scale(0.1)">${halos}</g>`,
      now: amplitude ?? Number.NaN,
      dots,
    },
    [model, state.periods, words, session.pointed, log],
  )
  if (amplitude === null) return drawing
  return html`${drawing}<b class="handle spot" style="left:${sx(amplitude).toFixed(1)}px;top:${height}px"></b>`
}

const signed = new WeakMap<Float64Array, Float64Array>()

/** The error with its sign, where a range is stated. */
function signedStated(stated: Float64Array, error: Float64Array): Float64Array {
  const before = signed.get(stated)
  if (before) return before
  const made = stated.map((each, i) => (Number.isNaN(each) ? Number.NaN : (error[i] as number)))
  signed.set(stated, made)
  return made
}

function ratioTable(page: Live): TableSpec {
  const { model, words } = page
  const { period, table, compare } = words.say
  const column = (title: string, key: string, clothes: string, about: string) => ({
    title,
    clothes,
    about,
    values: periodCurve(model, key).ratio,
    factor: 1,
    decimals: 6,
  })
  return {
    caption: words.fill(table.caption, { plot: period.tableRatio, unit: '_T_/_T_{0}' }),
    file: 'period',
    first: { title: period.amplitudeColumn, values: AMPLITUDES, factor: 1, decimals: 0 },
    columns: [
      column(compare.exact, 'exact', 'c-exact', period.exactBy),
      ...shownRows(page).map(({ key, name }) =>
        column(formulaName(page, name, key), key, periodKind(name).clothes, formulaShort(page, name)),
      ),
    ],
    some: TABLE_ROWS,
  }
}

function errorTable(page: Live): TableSpec {
  const { model, words } = page
  const { period, table } = words.say
  return {
    caption: words.fill(table.caption, { plot: period.tableError, unit: '%' }),
    file: 'period-error',
    first: { title: period.amplitudeColumn, values: AMPLITUDES, factor: 1, decimals: 0 },
    columns: shownRows(page).map(({ key, name }) => ({
      title: formulaName(page, name, key),
      clothes: periodKind(name).clothes,
      about: formulaShort(page, name),
      values: periodCurve(model, key).error,
      factor: 100,
      decimals: 4,
    })),
    some: TABLE_ROWS,
  }
}

/** The exact ratio at the amplitude, in words. */
function ratioText(page: Live): string {
  const { words, model } = page
  const { period } = words.say
  const amplitude = amplitudeOf(page)
  if (amplitude === null) return period.rotation
  const { ratio } = periodAt(model, 'exact', radians(amplitude))
  return Number.isFinite(ratio)
    ? words.fill(period.at, { angle: angleText(page, amplitude), ratio: words.fixed(ratio, 4) })
    : words.fill(period.endless, { angle: angleText(page, amplitude) })
}

function errorsText(page: Live): string {
  const amplitude = amplitudeOf(page)
  const { words } = page
  if (amplitude === null) return words.say.period.rotation
  const errors = resultsNow(page)
    .filter(({ on }) => on)
    .map(({ key, name, error }) => `${plain(formulaName(page, name, key))} ${signedPercent(words, error)}`)
  if (errors.length === 0) return words.say.period.empty
  return words.fill(words.say.period.errorsAt, { angle: angleText(page, amplitude), errors: errors.join('; ') })
}

function ratioChart(page: Live): TemplateResult {
  const { words, model } = page
  const { period } = words.say
  const { ratio } = periodCurve(model, 'exact')
  return chart(page, {
    key: 'period',
    className: 'first-chart period-chart',
    title: period.title,
    unit: '_T_/_T_{0}',
    name: period.title,
    height: 14,
    xLabels: false,
    draw: (size) => drawRatio(page, size),
    caption: `${period.caption} ${ratioText(page)}`,
    cursor: cursorOf(page, period.cursor, plain(ratioText(page))),
    table: () => ratioTable(page),
    sound: () => ({ values: ratio, low: 1, high: RATIO_ENDS[1] }),
  })
}

function errorChart(page: Live): TemplateResult {
  const { words, model, state, store, session } = page
  const { period, plots } = words.say
  const rows = shownRows(page)
  const heard = rows.find(({ name }) => name === session.pointed) ?? rows[0]
  return chart(page, {
    key: 'period-error',
    className: 'second-chart period-chart',
    title: plots.error,
    unit: state.periodAxis === 'log' ? period.errorUnit : period.errorUnitLinear,
    name: plots.error,
    height: 16.5,
    xLabels: true,
    switches: switches(
      plots.axis,
      [
        { value: 'log' as const, text: plots.log },
        { value: 'linear' as const, text: plots.linear },
      ],
      state.periodAxis,
      (periodAxis) => store.set({ periodAxis }),
    ),
    draw: (size) => drawError(page, size),
    caption: errorsText(page),
    cursor: cursorOf(page, period.cursorError, plain(errorsText(page))),
    table: () => errorTable(page),
    ...(heard
      ? {
          sound: () => {
            const values = periodCurve(model, heard.key).size.map((each) => Math.log10(each))
            return { values, low: -7, high: 0 }
          },
        }
      : {}),
    note: rows.length === 0 ? html`<p class="plot-note">${period.empty}</p>` : nothing,
  })
}

export function period(page: Live): TemplateResult {
  const amplitude = amplitudeOf(page)
  const at = amplitude === null ? null : angleText(page, amplitude)
  return html`<div class="period-columns"><div class="column middle">${ratioChart(page)}${errorChart(page)}</div>
    <div class="column right">${amplitudeValue(page)}${formulaList(page, resultsNow(page), at)}</div></div>`
}

/** The exact ratio, and the nearest of the formulas that are drawn. */
export function periodSentence(page: Live): string {
  const { words, model } = page
  const { period } = words.say
  const amplitude = amplitudeOf(page)
  if (amplitude === null) return period.rotation
  const angle = angleText(page, amplitude)
  const { ratio } = periodAt(model, 'exact', radians(amplitude))
  if (!Number.isFinite(ratio) || page.motion.balanced) return words.fill(period.endless, { angle })
  const first = words.fill(period.sentence, { angle, ratio: words.fixed(ratio, 3) })
  const best = nearestOf(resultsNow(page))
  if (!best) return first
  const percent = words.percent(Math.abs(100 * best.error), 2)
  const name = plain(formulaName(page, best.name, best.key))
  const which = best.error === 0 ? period.nearestSame : best.error < 0 ? period.nearestShort : period.nearestLong
  return `${first} ${words.fill(which, { name, percent })}`
}
