// The measured values with the fitted curve, and what is left of them below, on one axis.

import { html, nothing, svg, type TemplateResult } from 'lit-html'
import { lawOf } from '../against-swing'
import type { TableSpec } from '../columns'
import { switches } from '../controls/parts'
import { extent, type Points } from '../draw/curve'
import { dotsOf } from '../draw/dots'
import { type Line, plot } from '../draw/plot'
import { linearScale, type Scale, type Tick } from '../draw/scale'
import type { Axis, Measurement } from '../measurement'
import { remember } from '../memory'
import type { Model } from '../model'
import type { Reading, Result } from '../model/fit-protocol'
import { DEGREES } from '../number'
import { roundTicksOf } from './axis-ticks'
import { chart } from './chart'
import type { PlotSize } from './chart-spec'
import type { Live } from './page'

/** From SI to the unit that is shown. */
const FACTORS = { angle: DEGREES, velocity: DEGREES, acceleration: 1, gate: 1, swings: 1 } as const

/** What is drawn: points from left to right, and the fitted curve through them. */
interface DrawnRecord {
  readonly reading: Reading
  readonly result: Result | null
  readonly bySwing: boolean
  /** Abscissas in the unit of the axis. */
  readonly x: Float64Array
  readonly y: Float64Array
  readonly residual: Float64Array
  readonly curve: Points | null
  readonly factor: number
}

/** Values in the order of their abscissas: the swings of a record fall while its time rises. */
function ordered(order: readonly number[], values: Float64Array): Float64Array {
  return Float64Array.from(order, (i) => values[i] as number)
}

const shownOf = remember(
  (model: Model, reading: Reading | null, result: Result | null, axis: Axis): DrawnRecord | null => {
    if (!reading) return null
    const factor = FACTORS[reading.measured]
    const table = reading.measured === 'swings'
    const inDegrees = (values: Float64Array) => values.map((each) => each * DEGREES)
    if (!result) {
      const { x, y } = reading
      return { reading, result, bySwing: table, x: table ? inDegrees(x) : x, y, residual: y, curve: null, factor }
    }
    const bySwing = table || (reading.measured === 'gate' && axis === 'swing')
    if (!bySwing) {
      const { x, measured: y, residual, fitted } = result
      return { reading, result, bySwing, x, y, residual, curve: { x, y: fitted }, factor }
    }
    // A table has the angles that were read, a gate those of the fit.
    const angles = table ? result.x : result.swings
    const order = Array.from(angles, (_, i) => i).sort((i, j) => (angles[i] as number) - (angles[j] as number))
    const law = lawOf(model, angles, result)
    const x = inDegrees(ordered(order, angles))
    const curve = law ? { x: inDegrees(law.x), y: law.y } : { x, y: ordered(order, result.fitted) }
    const [y, residual] = [result.measured, result.residual].map((each) => ordered(order, each)) as [
      Float64Array,
      Float64Array,
    ]
    return { reading, result, bySwing, x, y, residual, curve, factor }
  },
)

/** Values whose dots may be larger. */
const FEW = 120

/** An axis with a little room at its ends. */
function axis(page: Live, values: Float64Array, factor: number, height: number, rem: number): [Scale, Tick[]] {
  const [least, most] = extent(values).map((each) => each * factor) as [number, number]
  const room = 0.06 * (most - least) || 1
  const [low, high] = [least - room, most + room]
  const sy = linearScale([low, high], [height, 0])
  return [sy, roundTicksOf(page.words, low, high, Math.min(7, Math.max(3, Math.floor(height / (1.15 * rem)))))]
}

function draw(page: Live, shown: DrawnRecord, size: PlotSize, y: Float64Array, lines: readonly Line[], below: boolean) {
  const { x, factor } = shown
  const { width, height, rem } = size
  const [first, last] = extent(x)
  // Between few values a line would end in the frame.
  const few = x.length < FEW
  const room = few ? 0.02 * (last - first) : 0
  const [low, high] = [first - room, last > first ? last + room : first + 1]
  const sx = linearScale([low, high], [0, width])
  const [sy, ys] = axis(page, y, factor, height, rem)
  const dots = (points: Points) => dotsOf(points, sx, sy, factor)
  return plot(
    {
      ...size,
      sx,
      sy,
      xs: roundTicksOf(page.words, low, high, width < 26 * rem ? 5 : 9),
      ys,
      xLabels: below,
      lines,
      under: svg`<g transform="scale(0.1)"><path class="data-dots ${few ? 'few' : ''}" d=${dots({ x, y })}/></g>`,
    },
    [shown, page.words, y],
  )
}

function tableOf(page: Live, { reading, result, bySwing, x, y, residual, factor }: DrawnRecord): TableSpec {
  const { data, table } = page.words.say
  const column = (title: string, values: Float64Array) => ({ title, values, factor, decimals: 4 })
  const { measured } = reading
  return {
    caption: page.words.fill(table.caption, { plot: data.titles[measured], unit: unitOf(page, measured, bySwing) }),
    file: 'fit',
    first: { title: bySwing ? data.swingColumn : data.timeColumn, values: x, factor: 1, decimals: 3 },
    columns: result
      ? [
          column(data.measuredColumn, y),
          column(
            data.fittedColumn,
            y.map((each, i) => each - (residual[i] as number)),
          ),
          column(data.residualColumn, residual),
        ]
      : [column(data.measuredColumn, y)],
  }
}

/** The units of both axes in words. */
function unitOf({ words }: Live, measured: Reading['measured'], bySwing: boolean): string {
  const { units } = words.say.data
  return measured === 'gate' && bySwing ? units.gateBySwing : units[measured]
}

/** Of a light gate: periods against the time, or against the swing by the fit. */
function axes(page: Live, measurement: Measurement, { reading, result }: DrawnRecord): TemplateResult | typeof nothing {
  if (reading.measured !== 'gate' || !result) return nothing
  const { data } = page.words.say
  return switches(
    data.against,
    (['swing', 'time'] as const).map((value) => ({ value, text: data.axes[value] })),
    measurement.axis,
    (axis) => measurement.draw(axis),
  )
}

function dataChart(page: Live, measurement: Measurement, shown: DrawnRecord): TemplateResult {
  const { words } = page
  const { data } = words.say
  const { reading, result, bySwing, x, y, curve, factor } = shown
  const lines = curve ? [{ ...curve, clothes: 'c-exact thin', factor }] : []
  const [from, to] = extent(x).map((each) => words.significant(each)) as [string, string]
  return chart(page, {
    key: 'data',
    className: 'first-chart',
    title: data.titles[reading.measured],
    unit: unitOf(page, reading.measured, bySwing),
    name: data.titles[reading.measured],
    height: 12.5,
    xLabels: result === null,
    switches: axes(page, measurement, shown),
    draw: (size) => draw(page, shown, size, y, lines, result === null),
    caption: words.fill(result ? data.captionData : data.captionRead, { count: y.length, from, to }),
    table: () => tableOf(page, shown),
    sound: () => {
      const [low, high] = extent(y)
      return { values: y, low, high }
    },
  })
}

function residualChart(page: Live, shown: DrawnRecord, result: Result): TemplateResult {
  const { words } = page
  const { data } = words.say
  const { reading, factor, x, residual } = shown
  const unit = data.plain[reading.measured]
  const number = (value: number) => words.with(words.significant(value * factor), unit)
  const [low, high] = extent(residual)
  const zero = { x: Float64Array.of(...extent(x)), y: new Float64Array(2), clothes: 'c-exact thin' }
  return chart(page, {
    key: 'residual',
    className: 'second-chart',
    title: data.residual,
    unit: words.fill(data.residualUnit, { unit }),
    name: data.residual,
    height: 8.25,
    xLabels: true,
    draw: (size) => draw(page, shown, size, residual, [zero], true),
    caption: words.fill(data.captionResidual, { rms: number(result.fit.rms), most: number(Math.max(-low, high)) }),
    table: () => tableOf(page, shown),
  })
}

/** Both charts; nothing before a file is read. */
export function dataCharts(page: Live, measurement: Measurement): TemplateResult | null {
  const { reading, result, axis } = measurement
  const shown = shownOf(page.model, reading, result, axis)
  if (!shown) return null
  const first = dataChart(page, measurement, shown)
  return result ? html`${first}${residualChart(page, shown, result)}` : first
}
