// The measured values with the fitted curve, and what is left of them below, on one axis.

import { html, svg, type TemplateResult } from 'lit-html'
import { extent, type Points } from '../draw/curve'
import { dotsOf } from '../draw/dots'
import { type Line, plot } from '../draw/plot'
import { linearScale, roundTicks, type Scale, type Tick, tickDecimals } from '../draw/scale'
import type { Measurement } from '../measurement'
import { remember } from '../memory'
import type { Reading, Result } from '../model/fit-protocol'
import { chart, type PlotSize } from './chart'
import type { Live } from './page'

const DEGREES = 180 / Math.PI
/** From SI to the unit that is shown. */
const FACTORS = { angle: DEGREES, velocity: DEGREES, acceleration: 1, gate: 1, swings: 1 } as const

/** What is drawn. */
interface DrawnRecord {
  readonly reading: Reading
  readonly result: Result | null
  /** Abscissas in the unit of the axis. */
  readonly x: Float64Array
  readonly factor: number
}

const shownOf = remember((reading: Reading | null, result: Result | null): DrawnRecord | null => {
  if (!reading) return null
  const x = result?.x ?? reading.x
  const inDegrees = reading.measured === 'swings'
  const factor = FACTORS[reading.measured]
  return { reading, result, x: inDegrees ? x.map((each) => each * DEGREES) : x, factor }
})

/** An axis with a little room at its ends. */
function axis(page: Live, values: Float64Array, factor: number, height: number, rem: number): [Scale, Tick[]] {
  const [least, most] = extent(values).map((each) => each * factor) as [number, number]
  const room = 0.06 * (most - least) || 1
  const [low, high] = [least - room, most + room]
  const sy = linearScale([low, high], [height, 0])
  const ticks = roundTicks(low, high, Math.min(7, Math.max(3, Math.floor(height / (1.15 * rem)))))
  const decimals = tickDecimals(ticks)
  return [sy, ticks.map((value) => ({ value, text: page.words.fixed(value, decimals) }))]
}

function draw(page: Live, shown: DrawnRecord, size: PlotSize, y: Float64Array, lines: readonly Line[], below: boolean) {
  const { x, factor } = shown
  const { width, height, rem } = size
  const [low, high] = extent(x)
  const sx = linearScale([low, high > low ? high : low + 1], [0, width])
  const ticks = roundTicks(low, high, width < 26 * rem ? 5 : 9)
  const decimals = tickDecimals(ticks)
  const [sy, ys] = axis(page, y, factor, height, rem)
  const dots = (points: Points) => dotsOf(points, sx, sy, factor)
  return plot(
    {
      ...size,
      sx,
      sy,
      xs: ticks.map((value) => ({ value, text: page.words.fixed(value, decimals) })),
      ys,
      xLabels: below,
      lines,
      under: svg`<g transform="scale(0.1)"><path class="data-dots" d=${dots({ x, y })}/></g>`,
    },
    [shown, page.words, y],
  )
}

function tableOf(page: Live, { reading, result, x, factor }: DrawnRecord) {
  const { data, table } = page.words.say
  const column = (title: string, values: Float64Array) => ({ title, values, factor, decimals: 4 })
  const { measured } = reading
  return {
    caption: page.words.fill(table.caption, { plot: data.titles[measured], unit: data.units[measured] }),
    file: 'fit',
    first: { title: measured === 'swings' ? data.swingColumn : data.timeColumn, values: x, factor: 1, decimals: 3 },
    columns: result
      ? [
          column(data.measuredColumn, result.measured),
          column(data.fittedColumn, result.fitted),
          column(data.residualColumn, result.residual),
        ]
      : [column(data.measuredColumn, reading.y)],
  }
}

function dataChart(page: Live, shown: DrawnRecord): TemplateResult {
  const { words } = page
  const { data } = words.say
  const { reading, result, x, factor } = shown
  const y = result?.measured ?? reading.y
  const lines = result ? [{ x, y: result.fitted, clothes: 'c-exact thin', factor }] : []
  const [from, to] = extent(x).map((each) => words.significant(each)) as [string, string]
  return chart(page, {
    key: 'data',
    className: 'first-chart',
    title: data.titles[reading.measured],
    unit: data.units[reading.measured],
    name: data.titles[reading.measured],
    height: 12.5,
    xLabels: result === null,
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
  const { reading, factor, x } = shown
  const unit = data.plain[reading.measured]
  const number = (value: number) => words.with(words.significant(value * factor), unit)
  const [low, high] = extent(result.residual)
  const zero = { x: Float64Array.of(...extent(x)), y: new Float64Array(2), clothes: 'c-exact thin' }
  return chart(page, {
    key: 'residual',
    className: 'second-chart',
    title: data.residual,
    unit: words.fill(data.residualUnit, { unit }),
    name: data.residual,
    height: 8.25,
    xLabels: true,
    draw: (size) => draw(page, shown, size, result.residual, [zero], true),
    caption: words.fill(data.captionResidual, { rms: number(result.fit.rms), most: number(Math.max(-low, high)) }),
    table: () => tableOf(page, shown),
  })
}

/** Both charts; nothing before a file is read. */
export function dataCharts(page: Live, { reading, result }: Measurement): TemplateResult | null {
  const shown = shownOf(reading, result)
  if (!shown) return null
  const first = dataChart(page, shown)
  return result ? html`${first}${residualChart(page, shown, result)}` : first
}
