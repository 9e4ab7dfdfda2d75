// The error panel: formula minus exact on the axis of time of the plot above, linear or logarithmic on both sides of zero.

import { html, nothing, type TemplateResult } from 'lit-html'
import { switches } from '../controls/parts'
import { extent } from '../draw/curve'
import { hatchedRegions, type Line, plot } from '../draw/plot'
import { linearScale, type Scale, symmetricLogScale, symmetricLogTicks, type Tick } from '../draw/scale'
import type { Words } from '../language'
import { degrees } from '../number'
import { errorFactor, inPercent, isLog, type Study } from '../study'
import { roundTicksOf } from './axis-ticks'
import { chart } from './chart'
import type { PlotSize } from './chart-spec'
import { curveColumn, curveName } from './compare'
import type { Live } from './page'
import { periodMarks, periodVerticals, timeScale, timeText, timeTicks } from './time-axis'

/** Largest size that the axis has room for; a curve beyond it leaves the plot with a mark. */
const MOST = { percent: 300, degrees: 540 }

function sizes(study: Study, factor: number): { least: number; most: number } {
  const found = study.shown.map(({ largest }) => (largest?.value ?? 0) * factor).filter((size) => size > 0)
  return found.length === 0 ? { least: 1, most: 1 } : { least: Math.min(...found), most: Math.max(...found) }
}

/** The power of ten below the smallest of the largest errors: each curve is seen. */
function logUnit(least: number, most: number): number {
  return 10 ** Math.max(Math.floor(Math.log10(least) + 1e-9), Math.floor(Math.log10(most)) - 12)
}

interface ErrorAxis {
  readonly log: boolean
  readonly factor: number
  readonly unit: number
  readonly most: number
}

function axisOf(page: Live, study: Study): ErrorAxis {
  const percent = inPercent(page.state, study)
  const factor = errorFactor(percent, study.motion)
  const { least, most } = sizes(study, factor)
  const kept = Math.min(most, percent ? MOST.percent : MOST.degrees)
  return { log: isLog(page.state, study), factor, unit: logUnit(Math.min(least, kept), kept), most: kept }
}

function scaleAndTicks(page: Live, axis: ErrorAxis, { height, rem }: PlotSize): { sy: Scale; ys: Tick[] } {
  const { words } = page
  const room = Math.min(7, Math.max(3, Math.floor(height / (1.15 * rem))))
  const high = 1.12 * axis.most
  if (axis.log) {
    const end = 1.6 * axis.most
    const sy = symmetricLogScale(axis.unit, [-end, end], [height, 0])
    const values = symmetricLogTicks(axis.unit, end, room)
    return { sy, ys: values.map((value) => ({ value, text: powerText(words, value) })) }
  }
  const sy = linearScale([-high, high], [height, 0])
  return { sy, ys: roundTicksOf(words, -high, high, room) }
}

/** 100, 0.01, 10^{−6}: the label of a power of ten. */
export function powerText(words: Words, value: number): string {
  const exponent = Math.round(Math.log10(Math.abs(value)))
  if (value === 0 || Math.abs(exponent) < 4) return words.significant(value, 1)
  return `${value < 0 ? '−' : ''}10^{${String(exponent).replace('-', '−')}}`
}

/** Of the exact motion, from end to end. */
const NO_ERROR = new Float64Array(2)

function draw(page: Live, study: Study, size: PlotSize): TemplateResult {
  const { words, t, session } = page
  const axis = axisOf(page, study)
  const { sy, ys } = scaleAndTicks(page, axis, size)
  const sx = timeScale(study.window, size)
  const { pointed } = session
  const exactNow = study.motion.theta(t)
  const lines: Line[] = [
    ...study.shown.map((drawn) => ({
      x: study.times,
      y: drawn.error,
      clothes: drawn.clothes,
      factor: axis.factor,
      faded: pointed !== null && pointed !== drawn.key,
    })),
    {
      x: Float64Array.of(study.window.from, study.window.to),
      y: NO_ERROR,
      clothes: 'c-exact',
      faded: pointed !== null,
    },
  ]
  return plot(
    {
      ...size,
      sx,
      sy,
      xs: timeTicks(words, study.window, size),
      ys,
      xLabels: false,
      lines,
      hatched: hatchedRegions(study.shown.map(({ error }) => ({ x: study.times, y: error }))),
      verticals: periodVerticals(page, study, periodMarks(study)).map(({ x }) => ({ x, text: '' })),
      now: t,
      dots: study.shown.map((drawn) => ({
        clothes: drawn.clothes,
        y: axis.factor * (drawn.solution.theta(t) - exactNow),
      })),
    },
    [study, sy.key, words, pointed],
  )
}

function caption(page: Live, study: Study, axis: ErrorAxis, percent: boolean): string {
  const { words } = page
  const { plots, compare } = words.say
  const errors = study.shown.map(({ curve, largest }) => {
    const name = curveName(page, curve)
    if (!largest) return `${name} ${compare.hatched}`
    const size = largest.value * axis.factor
    return words.fill(plots.captionErrorOne, {
      name,
      error: percent ? words.percent(size) : words.degrees(size),
      t: timeText(words, largest.t),
    })
  })
  if (errors.length === 0) return words.fill(plots.empty, { add: plots.emptyAdd })
  return words.fill(plots.captionError, {
    from: timeText(words, study.window.from),
    to: timeText(words, study.window.to),
    errors: errors.join('; '),
  })
}

function emptyNote({ words, store }: Live): TemplateResult {
  const { plots } = words.say
  const [before = '', after = ''] = plots.empty.split('{add}')
  const open = (event: Event) => {
    event.stopPropagation()
    store.setSession({ menu: 'add' })
  }
  return html`<p class="plot-note">${before}<button type="button" class="text-button" @click=${open}>${plots.emptyAdd}</button>${after}</p>`
}

/** Per cent of the amplitude or degrees; without an amplitude there is no choice. */
function percentOrDegrees({ words, state, store }: Live, { motion }: Study): TemplateResult | typeof nothing {
  if (motion.regime !== 'libration') return nothing
  const { plots } = words.say
  return switches(
    plots.unit,
    [
      { value: 'percent' as const, text: '%', name: plots.percentName },
      { value: 'degrees' as const, text: '°', name: plots.degreesName },
    ],
    state.errorUnit,
    (errorUnit) => store.set({ errorUnit }),
    'units',
  )
}

export function errorChart(page: Live, study: Study): TemplateResult {
  const { words, state, store } = page
  const { plots } = words.say
  const percent = inPercent(state, study)
  const axis = axisOf(page, study)
  const first = study.shown[0]
  const unit = percent
    ? words.fill(plots.errorPercent, { angle: `${words.given(Number(degrees(study.motion.thetaMax).toFixed(2)))}°` })
    : plots.errorDegrees
  return chart(page, {
    key: 'error',
    className: 'second-chart',
    title: plots.error,
    unit,
    name: plots.error,
    height: 8.25,
    xLabels: false,
    switches: html`${percentOrDegrees(page, study)}${switches(
      plots.axis,
      [
        { value: 'log' as const, text: plots.log },
        { value: 'linear' as const, text: plots.linear },
      ],
      axis.log ? 'log' : 'linear',
      (errorAxis) => store.set({ errorAxis }),
    )}`,
    draw: (size) => draw(page, study, size),
    caption: () => caption(page, study, axis, percent),
    spoken: () => caption(page, study, axis, percent),
    window: study.window,
    table: () => ({
      caption: words.fill(words.say.table.caption, { plot: plots.error, unit }),
      file: 'error',
      first: { title: words.say.table.time, values: study.times, factor: 1, decimals: 3 },
      columns: study.shown.map((drawn) => ({
        ...curveColumn(page, drawn),
        values: drawn.error,
        factor: axis.factor,
        decimals: 4,
      })),
    }),
    ...(first
      ? {
          sound: () => {
            const [low, high] = extent(first.error)
            return { values: first.error, low, high }
          },
        }
      : {}),
    note: study.shown.length === 0 ? emptyNote(page) : nothing,
  })
}
