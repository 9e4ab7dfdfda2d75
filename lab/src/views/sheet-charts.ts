// The three charts of the worksheet, drawn for paper: lines alone, black, told apart by dashes; scaled with the sheet.

import { html, svg, type TemplateResult } from 'lit-html'
import { type Label, type Line, type PlotSpec, plot } from '../draw/plot'
import { linearScale, type Tick } from '../draw/scale'
import { type Exercises, motionsOf } from '../handouts/exercises'
import { plain, rich } from '../language/rich'
import { remember } from '../memory'
import type { Model, Motion } from '../model'
import { DEGREES, radians } from '../number'
import { evenTimes } from '../study'
import type { Live } from './page'
import { portraitGround } from './portrait'

/** Units of the drawing of 1 rem of the page; the sheet scales it. */
const REM = 14
const GUTTER = { left: 44, top: 8, right: 12, bottom: 26 }

type Frame = Pick<PlotSpec, 'width' | 'height' | 'rem'>

function figure(
  { words }: Live,
  name: string,
  { title, caption, frame }: { readonly title: string; readonly caption: string; readonly frame: Frame },
  drawing: TemplateResult,
): TemplateResult {
  const { left, top, right, bottom } = GUTTER
  const box = `${-left} ${-top} ${frame.width + left + right} ${frame.height + top + bottom}`
  return html`<figure class="sheet-chart" data-sheet-chart=${name}><h3>${rich(words.formula(title))}</h3>
    <svg viewBox=${box} role="img" aria-label=${plain(caption)}>${drawing}</svg></figure>`
}

/** Lines at every step, numbers at some. */
function ticks(low: number, high: number, step: number, text: (value: number) => string): Tick[] {
  const count = Math.round((high - low) / step)
  return Array.from({ length: count + 1 }, (_, i) => {
    const value = Number((low + i * step).toPrecision(12))
    return { value, text: text(value) }
  })
}

/** Every degree of the first chart. */
const AMPLITUDES = Float64Array.from({ length: 171 }, (_, i) => i)

/** T/T₀, with a line at every tenth and every ten degrees. */
export function ratioChart(page: Live): TemplateResult {
  const { words, model } = page
  const { handouts } = words.say
  const frame = { width: 620, height: 300, rem: REM }
  const { x, y } = ratioCurve(model)
  const drawing = plot(
    {
      ...frame,
      sx: linearScale([0, 170], [0, frame.width]),
      sy: linearScale([1, 2.5], [frame.height, 0]),
      xs: ticks(0, 170, 10, (value) => (value % 20 === 0 ? `${words.given(value)}°` : '')),
      ys: ticks(1, 2.5, 0.1, (value) => (Math.round(10 * value) % 2 === 0 ? words.fixed(value, 1) : '')),
      xLabels: true,
      lines: [{ x, y, clothes: 'c-exact' }],
    },
    [model, words],
  )
  return figure(page, 'ratio', { title: handouts.ratioChart, caption: handouts.ratioCaption, frame }, drawing)
}

const ratioCurve = remember((model: Model) => ({
  x: AMPLITUDES,
  y: model.periodRatio('exact', AMPLITUDES.map(radians)),
}))

/** The separatrix, faint curves, and three points with their letters. */
export function portraitSheet(page: Live, exercises: Exercises): TemplateResult {
  const { words, model } = page
  const { handouts } = words.say
  const frame = { width: 280, height: 210, rem: REM }
  const motion = sheetMotions(model, exercises).portrait
  const [reach = 1] = motion.levelVelocity(Float64Array.of(0), 1.9)
  // A line at every rad/s, so that a point is read to a part of one.
  const whole = Math.floor(reach)
  const sx = linearScale([-180, 180], [0, frame.width])
  const sy = linearScale([-reach, reach], [frame.height, 0])
  const labels: Label[] = exercises.portrait.points.map(({ name, angle, velocity }) => ({
    x: sx(angle) + 5,
    y: sy(velocity / 10) - 5,
    text: `*${name}*`,
    ink: true,
    anchor: 'start',
  }))
  const dots = exercises.portrait.points.map(
    ({ angle, velocity }) =>
      svg`<circle class="sheet-point" cx=${sx(angle).toFixed(1)} cy=${sy(velocity / 10).toFixed(1)} r="3.5"/>`,
  )
  const drawing = plot(
    {
      ...frame,
      sx,
      sy,
      xs: ticks(-180, 180, 30, (value) => (value % 90 === 0 ? `${words.typed(value)}°` : '')),
      ys: ticks(-whole, whole, 1, (value) => (value % (whole < 9 ? 2 : 5) === 0 ? words.typed(value) : '')),
      xLabels: true,
      lines: [],
      labels,
      under: svg`${portraitGround(motion, sx, sy)}${dots}`,
    },
    [exercises, words],
  )
  return figure(page, 'portrait', { title: handouts.portraitChart, caption: handouts.portraitCaption, frame }, drawing)
}

/** One motion from rest: exact, and by the linear equation. */
export function motionChart(page: Live, exercises: Exercises): TemplateResult {
  const { words, model } = page
  const { handouts } = words.say
  const frame = { width: 280, height: 210, rem: REM }
  const { until, angle } = exercises.reading
  const high = 30 * Math.ceil((angle + 5) / 30)
  const drawing = plot(
    {
      ...frame,
      sx: linearScale([0, until], [0, frame.width]),
      sy: linearScale([-high, high], [frame.height, 0]),
      xs: ticks(0, until, until > 6 ? 0.5 : 0.25, (value) => (Number.isInteger(value) ? words.given(value) : '')),
      ys: ticks(-high, high, 10, (value) => (value % 30 === 0 ? `${words.typed(value)}°` : '')),
      xLabels: true,
      lines: timeCurves(sheetMotions(model, exercises).reading, until),
    },
    [exercises, words],
  )
  return figure(page, 'motion', { title: handouts.motionChart, caption: handouts.motionCaption, frame }, drawing)
}

const sheetMotions = remember(motionsOf)

const timeCurves = remember((motion: Motion, until: number): Line[] => {
  const x = evenTimes({ from: 0, to: until }, 600)
  const linear = motion.solution({ name: 'linear', on: true }, until)
  const line = (y: Float64Array, clothes: string): Line => ({ x, y, clothes, factor: DEGREES })
  const exact = line(motion.sample(x).theta, 'c-exact')
  return 'refused' in linear
    ? [exact]
    : [
        line(
          x.map((t) => linear.theta(t)),
          'c-linear',
        ),
        exact,
      ]
})

/** A line where an answer is written. */
export function blank(): TemplateResult {
  return html`<span class="blank" aria-hidden="true"></span>`
}
