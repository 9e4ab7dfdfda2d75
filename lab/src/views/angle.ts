// The plot of the angle, or of the velocity, over time: exact and compared, with alarms and hatched regions.

import { html, nothing, type TemplateResult } from 'lit-html'
import type { TableSpec } from '../columns'
import { switches } from '../controls/parts'
import { extent } from '../draw/curve'
import { hatchedRegions, type Line, plot } from '../draw/plot'
import { degreeTicks, linearScale, type Tick } from '../draw/scale'
import { plain, rich } from '../language/rich'
import { remember } from '../memory'
import { DEGREES } from '../number'
import type { Drawn, Study } from '../study'
import { roundTicksOf } from './axis-ticks'
import { chart } from './chart'
import type { PlotSize } from './chart-spec'
import { curveColumn, curveName } from './compare'
import type { Live } from './page'
import { periodMarks, periodVerticals, timeScale, timeText, timeTicks } from './time-axis'

/** Least and greatest of the axis: the exact motion with a margin, and of step-by-step solutions as much as fits three of it. */
function rangeOf(
  exact: Float64Array,
  others: readonly Float64Array[],
  factor: number,
  least: number,
): [number, number] {
  let [low, high] = extent(exact)
  const size = Math.max(high - low, least / factor)
  const most = 3 * size
  const start = { low, high }
  for (const values of others) {
    const [a, b] = extent(values)
    if (a < low) low = Math.max(a, start.low - most)
    if (b > high) high = Math.min(b, start.high + most)
  }
  const margin = 0.06 * Math.max(high - low, least / factor)
  return [(low - margin) * factor, (high + margin) * factor]
}

const quantities = {
  angle: { of: ({ track }: Drawn) => track.theta, factor: DEGREES },
  velocity: { of: ({ track }: Drawn) => track.velocity, factor: 1 },
} as const

function domainOf(study: Study, quantity: 'angle' | 'velocity'): [number, number] {
  const { of, factor } = quantities[quantity]
  const exact = quantity === 'angle' ? study.exact.theta : study.exact.velocity
  const others = study.shown.filter(({ curve }) => !['taylor', 'small-m', 'cubic'].includes(curve.name)).map(of)
  const { regime } = study.motion
  if (regime === 'rest' && quantity === 'angle') return study.motion.balanced ? [-190, 190] : [-16, 16]
  const [low, high] = rangeOf(exact, others, factor, regime === 'rest' ? 2 : 1e-6)
  // A whole circle to the eye: 150 and 170 degrees have the same axis.
  if (quantity === 'angle' && low > -191 && high < 191 && high - low > 200) return [-190, 190]
  if (quantity === 'angle' && low > -191 && high < 191 && low < 0 && high > 0) {
    const reach = Math.max(-low, high)
    return [-reach, reach]
  }
  return [low, high]
}

const rememberedDomain = remember(domainOf)
let held: [number, number] | null = null

/** Axes do not move under a drag; they settle when it ends. */
function settledDomain(page: Live, study: Study): [number, number] {
  const { session, state } = page
  const next = rememberedDomain(study, state.quantity)
  if (session.held !== null && session.held !== 'time') {
    held ??= next
    const whole = state.quantity === 'angle' && held[1] < 190 ? [Math.min(held[0], -190), Math.max(held[1], 190)] : held
    return session.held === 'bob' ? (whole as [number, number]) : held
  }
  held = null
  return next
}

function yTicks(page: Live, [low, high]: [number, number], { height, rem }: PlotSize): Tick[] {
  const { words, state } = page
  const most = Math.min(7, Math.max(2, Math.floor(height / (1.6 * rem))))
  if (state.quantity === 'angle') {
    return degreeTicks(low, high, most).map((value) => ({ value, text: `${words.typed(value)}°` }))
  }
  return roundTicksOf(words, low, high, most)
}

/** Why a curve has no value in the window, in words. */
function gapReasons(page: Live, study: Study): string[] {
  const { words, model } = page
  return study.shown
    .filter(({ gone }) => !Number.isNaN(gone))
    .map(({ curve }) => {
      const name = curveName(page, curve)
      const { reasons } = words.say
      const reason = reasons[curve.name as keyof typeof reasons] ?? reasons.none
      const angle = curve.name === 'fourier' ? words.angle(model.undefinedAbove(curve), 2) : ''
      return words.formula(words.fill(reason, { name, angle }))
    })
}

function hatchNote(page: Live, study: Study): TemplateResult | typeof nothing {
  const reasons = gapReasons(page, study)
  if (reasons.length === 0) return nothing
  return html`<p class="plot-note">${rich(page.words.fill(page.words.say.plots.hatched, { reasons: reasons.join(' ') }))}</p>`
}

/** Solutions that go over the top though the exact motion does not. */
export function alarms({ motion, shown, window }: Study): { drawn: Drawn; t: number }[] {
  if (motion.regime !== 'libration') return []
  return shown.flatMap((drawn) => {
    const t = drawn.solution.overTop
    return t >= window.from && t <= window.to ? [{ drawn, t }] : []
  })
}

export function alarmText(page: Live, study: Study): string {
  const { words } = page
  return alarms(study)
    .map(({ drawn, t }) => {
      const name = curveName(page, drawn.curve)
      return `${words.fill(words.say.alarms.overTop, { name, t: timeText(words, t) })}.`
    })
    .join(' ')
}

function lines(page: Live, study: Study): Line[] {
  const { quantity } = page.state
  const { of, factor } = quantities[quantity]
  const pointed = page.session.pointed
  const x = study.times
  const exact: Line = {
    x,
    y: quantity === 'angle' ? study.exact.theta : study.exact.velocity,
    clothes: 'c-exact',
    factor,
    faded: pointed !== null,
  }
  const others = study.shown.map(
    (drawn): Line => ({
      x,
      y: of(drawn),
      clothes: drawn.clothes,
      factor,
      faded: pointed !== null && pointed !== drawn.key,
    }),
  )
  // The exact motion is on top of all but a Fourier series, which is thinner and would be lost under it.
  const under = others.filter(({ clothes }) => !clothes.startsWith('c-fourier'))
  return [...under, exact, ...others.filter(({ clothes }) => clothes.startsWith('c-fourier'))]
}

function draw(page: Live, study: Study, size: PlotSize): TemplateResult {
  const { words, state, t } = page
  const { width, height } = size
  const domain = settledDomain(page, study)
  const sx = timeScale(study.window, size)
  const sy = linearScale(domain, [height, 0])
  const { quantity } = state
  const { factor } = quantities[quantity]
  const at = (drawn: Drawn) => (quantity === 'angle' ? drawn.solution.theta(t) : drawn.solution.velocity(t)) * factor
  const exactNow = (quantity === 'angle' ? study.motion.theta(t) : study.motion.velocity(t)) * factor
  const found = quantity === 'angle' ? alarms(study) : []
  const rings = found.map(({ drawn, t: when }) => ({ x: when, y: drawn.solution.theta(when) * factor }))
  const labels = found.map(({ drawn, t: when }, i) => {
    const name = curveName(page, drawn.curve)
    const seconds = words.with(words.fixed(when, 2), words.say.units.s)
    const left = sx(when) > width / 2
    // Below the ring and to its freer side; above it where there is no room below.
    const ring = sy(rings[i]?.y ?? 0)
    const below = ring + 1.5 * size.rem < height
    return {
      x: sx(when) + (left ? -0.5 : 0.5) * size.rem,
      y: below ? ring + 1.4 * size.rem : ring - 0.8 * size.rem,
      text: `*${words.fill(words.say.alarms.overTop, { name, t: seconds })}*`,
      alarm: true,
      anchor: left ? ('end' as const) : ('start' as const),
    }
  })
  return plot(
    {
      ...size,
      sx,
      sy,
      xs: timeTicks(words, study.window, size),
      ys: yTicks(page, domain, size),
      xLabels: false,
      lines: lines(page, study),
      hatched: hatchedRegions(study.shown.map((drawn) => ({ x: study.times, y: drawn.track.theta }))),
      verticals: periodVerticals(page, study, periodMarks(study)),
      rings,
      labels,
      now: t,
      dots: [
        ...study.shown.map((drawn) => ({ clothes: drawn.clothes, y: at(drawn) })),
        { clothes: 'c-exact', y: exactNow },
      ],
    },
    [study, quantity, sy.key, words, page.session.pointed],
  )
}

function tableOf(page: Live, study: Study): TableSpec {
  const { words, state } = page
  const { of, factor } = quantities[state.quantity]
  const angle = state.quantity === 'angle'
  const say = words.say.plots
  const unit = angle ? '°' : words.say.units['rad/s']
  const decimals = angle ? 2 : 3
  return {
    caption: words.fill(words.say.table.caption, { plot: angle ? say.angle : say.velocity, unit }),
    file: angle ? 'angle' : 'velocity',
    first: { title: words.say.table.time, values: study.times, factor: 1, decimals: 3 },
    columns: [
      { ...curveColumn(page), values: angle ? study.exact.theta : study.exact.velocity, factor, decimals },
      ...study.shown.map((drawn) => ({ ...curveColumn(page, drawn), values: of(drawn), factor, decimals })),
    ],
  }
}

/** The values of all curves at the time shown, as an arrow key on the plot says them. */
function spoken(page: Live, study: Study): string {
  const { words, state, t } = page
  const angle = state.quantity === 'angle'
  const say = (value: number) =>
    angle ? words.angle(value, 1) : words.with(words.fixed(value, 2), words.say.units['rad/s'])
  const exact = angle ? study.motion.theta(t) : study.motion.velocity(t)
  const others = study.shown.map(({ curve, solution }) => {
    const value = angle ? solution.theta(t) : solution.velocity(t)
    return `${curveName(page, curve)} ${Number.isNaN(value) ? words.say.table.noValue : say(value)}`
  })
  return [timeText(words, t), `${words.say.compare.exact} ${say(exact)}`, ...others].join(', ')
}

export function angleChart(page: Live, study: Study): TemplateResult {
  const { words, state, store } = page
  const { plots } = words.say
  const angle = state.quantity === 'angle'
  const values = angle ? study.exact.theta : study.exact.velocity
  const [low, high] = extent(values)
  const say = (value: number) =>
    angle ? words.angle(value, 1) : words.with(words.fixed(value, 2), words.say.units['rad/s'])
  const caption = () =>
    words.fill(angle ? plots.captionAngle : plots.captionVelocity, {
      from: timeText(words, study.window.from),
      to: timeText(words, study.window.to),
      least: say(low),
      most: say(high),
    })
  return chart(page, {
    key: 'angle',
    className: 'first-chart',
    title: angle ? plots.angleTitle : plots.velocityTitle,
    ...(angle ? {} : { unit: plots.velocityUnit }),
    name: plain(angle ? plots.angle : plots.velocity),
    height: 12.5,
    xLabels: false,
    switches: switches(
      plots.shows,
      [
        { value: 'angle' as const, text: plots.angle },
        { value: 'velocity' as const, text: plots.velocity },
      ],
      state.quantity,
      (quantity) => store.set({ quantity }),
    ),
    draw: (size) => draw(page, study, size),
    caption: () => `${caption()} ${alarmText(page, study)}`.trim(),
    spoken: () => spoken(page, study),
    window: study.window,
    table: () => tableOf(page, study),
    sound: () => ({ values, low, high }),
    note: hatchNote(page, study),
  })
}
