// Potential and phase portrait of a spring, one above the other on one axis of u: where the energy meets the potential it turns.
//
// A click, a drag or the arrow keys in the portrait set the start.

import { html, nothing, svg, type TemplateResult } from 'lit-html'
import type { TableSpec } from '../columns'
import { pathOf } from '../draw/curve'
import { plot } from '../draw/plot'
import { grainOf, linearScale, type Scale } from '../draw/scale'
import { startRing } from '../draw/start-ring'
import { plain } from '../language/rich'
import { remember } from '../memory'
import type { SpringOrbit } from '../model/spring'
import { potential } from '../model/spring-force'
import { levelCurves, levelThrough } from '../model/spring-levels'
import { inRange } from '../state'
import { roundTicksOf } from './axis-ticks'
import { chart } from './chart'
import type { Cursor, PlotSize } from './chart-spec'
import type { Live } from './page'
import type { SpringAxes } from './spring-axes'
import { type SpringView, shortNumber } from './spring-view'

const POINTS = 400

const potentialOf = remember((orbit: SpringOrbit, reach: number) => {
  const u = Float64Array.from({ length: POINTS + 1 }, (_, i) => reach * ((2 * i) / POINTS - 1))
  return { x: u, y: u.map((each) => potential(orbit.force, each)) }
})

/** Energies of faint curves, between and around those of the equilibria. */
function faintEnergies({ barriers, equilibria }: SpringOrbit, { lowest, highest }: SpringAxes): number[] {
  const own = [...new Set([...barriers, ...equilibria.map(({ height }) => height)])]
  const even = Array.from({ length: 8 }, (_, i) => lowest + ((highest - lowest) * (i + 0.7)) / 6)
  return even.filter((energy) => own.every((each) => Math.abs(energy - each) > 0.02 * (highest - lowest)))
}

const groundOf = remember((force: SpringOrbit['force'], axes: SpringAxes, orbit: SpringOrbit) => ({
  faint: faintEnergies(orbit, axes).flatMap((energy) => levelCurves(force, energy, axes.reach)),
  separatrix: orbit.barriers.flatMap((energy) => {
    const parted = orbit.equilibria.filter(({ stable, height }) => !stable && height === energy).map(({ u }) => u)
    return levelCurves(force, energy, axes.reach, parted)
  }),
}))

const curveOf = remember(levelThrough)

export function axisOf({ reach }: SpringAxes, width: number): Scale {
  return linearScale([-reach, reach], [0, width])
}

/** A vertical at each turning point, through both charts. */
function turningLines({ low, high }: SpringOrbit, sx: Scale, height: number): TemplateResult[] {
  return [low, high]
    .filter((u) => Number.isFinite(u))
    .map((u) => svg`<path class="period-line" d="M${Math.round(sx(u)) + 0.5} 0V${height}"/>`)
}

function marks({ equilibria }: SpringOrbit, sx: Scale, y: (height: number) => number): TemplateResult[] {
  return equilibria.map(
    ({ u, height, stable }) =>
      svg`<circle class="equilibrium ${stable ? 'stable' : 'unstable'}" cx=${sx(u).toFixed(1)} cy=${y(height).toFixed(1)} r="4"/>`,
  )
}

function drawPotential({ page, orbit, axes, now }: SpringView, size: PlotSize): TemplateResult {
  const { width, height, rem } = size
  const { words } = page
  const sx = axisOf(axes, width)
  const sy = linearScale([axes.lowest, axes.highest], [height, 0])
  const { low, high, energy, force, u0 } = orbit
  const [from, to] = [Math.max(low, -axes.reach), Math.min(high, axes.reach)]
  const band = svg`<rect class="band" x=${sx(from).toFixed(1)} y="0" width=${Math.max(0, sx(to) - sx(from)).toFixed(1)} height=${height}/>`
  const drawing = plot(
    {
      ...size,
      sx,
      sy,
      xs: roundTicksOf(words, -axes.reach, axes.reach, width < 26 * rem ? 5 : 9),
      ys: roundTicksOf(words, axes.lowest, axes.highest, 5),
      xLabels: false,
      lines: [
        { ...potentialOf(orbit, axes.reach), clothes: 'c-spring' },
        { x: Float64Array.of(from, to), y: Float64Array.of(energy, energy), clothes: 'c-exact' },
      ],
      levels: [energy],
      under: svg`${band}${turningLines(orbit, sx, height)}${marks(orbit, sx, sy)}`,
      labels: [{ x: width - 0.5 * rem, y: sy(energy) - 0.4 * rem, text: words.say.spring.energyLine, anchor: 'end' }],
    },
    [orbit, axes, words],
  )
  const y = sy(potential(force, Number.isNaN(now.u) ? u0 : now.u))
  if (!(Math.abs(now.u) <= axes.reach && y >= 0)) return drawing
  return html`${drawing}<b class="orbit-spot" style="left:${sx(now.u).toFixed(1)}px;top:${y.toFixed(1)}px"></b>`
}

/** A number as short as a step allows. */
const rounded = (value: number, grain: number): number => Number((grain * Math.round(value / grain)).toPrecision(12))

/** Shows a spring from a start. */
function begin({ store }: Live, u0: number, springVelocity0: number): void {
  if (!inRange('u0', u0) || !inRange('springVelocity0', springVelocity0)) return
  store.clock.pause()
  store.set({ u0, springVelocity0, t: 0 })
}

/** With even powers u = 0 is a place as any other. */
export function regimeWords({ words }: Live, { regime, even }: SpringOrbit): string {
  const { regimes, evenRegimes } = words.say.spring
  return even && (regime === 'libration' || regime === 'well') ? evenRegimes[regime] : regimes[regime]
}

function startWords(page: Live, orbit: SpringOrbit): string {
  const { words } = page
  const short = (value: number) => shortNumber(words, value)
  const { u0, velocity0 } = orbit
  const regime = regimeWords(page, orbit)
  return words.fill(words.say.spring.start, { u: short(u0), velocity: short(velocity0), regime })
}

function startCursor({ page, orbit, axes }: SpringView): Cursor {
  const { store, words, state } = page
  const { u0, springVelocity0 } = state
  const step = { u: grainOf(axes.reach / 50), velocity: grainOf(axes.fastest / 50) }
  // From the start as it is now: a second key may come before the page is drawn again.
  const move = (du: number, dv: number) => {
    const now = store.state
    begin(page, Number((now.u0 + du).toPrecision(12)), Number((now.springVelocity0 + dv).toPrecision(12)))
  }
  return {
    label: words.say.spring.cursor,
    least: -axes.reach,
    most: axes.reach,
    now: u0,
    text: plain(startWords(page, orbit)),
    key: (event) => {
      const small = event.shiftKey ? 0.1 : 1
      const steps: Readonly<Record<string, readonly [number, number]>> = {
        ArrowLeft: [-small, 0],
        ArrowRight: [small, 0],
        ArrowUp: [0, small],
        ArrowDown: [0, -small],
        PageUp: [0, 10],
        PageDown: [0, -10],
      }
      const by = steps[event.key]
      if (by) move(by[0] * step.u, by[1] * step.velocity)
      return by !== undefined
    },
    drag: {
      begin: () => store.setSession({ held: 'spring-start' }),
      at: (x, y, element) => {
        const { left, top, width, height } = element.getBoundingClientRect()
        const sx = axisOf(axes, width)
        const sy = linearScale([-axes.fastest, axes.fastest], [height, 0])
        const within = (value: number, most: number) => Math.min(most, Math.max(-most, value))
        const [du, dv] = [grainOf(sx.invert(1) - sx.invert(0)), grainOf(sy.invert(0) - sy.invert(1))]
        const u = within(sx.invert(x - left), axes.reach)
        begin(page, rounded(u, du), rounded(within(sy.invert(y - top), axes.fastest), dv))
      },
      end: (dropped) => {
        store.setSession({ held: null })
        if (dropped) begin(page, u0, springVelocity0)
        else if (!store.session.reduced && !matchMedia('(prefers-reduced-motion: reduce)').matches) store.play()
      },
    },
  }
}

function drawPortrait({ page, orbit, axes, now }: SpringView, size: PlotSize): TemplateResult {
  const { width, height, rem } = size
  const { words } = page
  const sx = axisOf(axes, width)
  const sy = linearScale([-axes.fastest, axes.fastest], [height, 0])
  const { faint, separatrix } = groundOf(orbit.force, axes, orbit)
  const path = (className: string) => (level: { x: Float64Array; y: Float64Array }) =>
    svg`<path class=${className} d=${pathOf(level, sx, sy)}/>`
  const under = svg`${turningLines(orbit, sx, height)}<g transform="scale(0.1)">${faint.map(path('faint'))}${separatrix.map(path('separatrix'))}</g>${marks(orbit, sx, () => sy(0))}`
  const drawing = plot(
    {
      ...size,
      sx,
      sy,
      xs: roundTicksOf(words, -axes.reach, axes.reach, width < 26 * rem ? 5 : 9),
      ys: roundTicksOf(words, -axes.fastest, axes.fastest, 7),
      xLabels: true,
      lines: curveOf(orbit, axes.reach).map((level) => ({ ...level, clothes: 'c-exact' })),
      under,
    },
    [orbit, axes, words],
  )
  const inside = Math.abs(now.u) <= axes.reach && Math.abs(now.velocity) <= axes.fastest
  return html`${drawing}${startRing(sx(orbit.u0), sy(orbit.velocity0), size)}${inside ? html`<b class="handle spot" style="left:${sx(now.u).toFixed(1)}px;top:${sy(now.velocity).toFixed(1)}px"></b>` : nothing}`
}

function tableOf({ page, orbit, axes }: SpringView): TableSpec {
  const { words } = page
  const { spring, table } = words.say
  const { x, y } = potentialOf(orbit, axes.reach)
  const speed = x.map((u) => orbit.speed(u, orbit.energy))
  return {
    caption: words.fill(table.caption, { plot: spring.tablePotential, unit: '1' }),
    file: 'spring',
    first: { title: '_u_', values: x, factor: 1, decimals: 4 },
    columns: [
      { title: '_V_', values: y, factor: 1, decimals: 4 },
      { title: spring.speed, values: speed, factor: 1, decimals: 4 },
    ],
  }
}

/** The motion's u in words: from, to, or without an end. */
export function rangeWords({ words }: Live, { low, high }: SpringOrbit): string {
  const { ranges } = words.say.spring
  const values = { low: shortNumber(words, low), high: shortNumber(words, high) }
  if (Number.isFinite(low)) return words.fill(Number.isFinite(high) ? ranges.both : ranges.above, values)
  return words.fill(Number.isFinite(high) ? ranges.below : ranges.all, values)
}

export function potentialChart(view: SpringView): TemplateResult {
  const { page, orbit, axes } = view
  const { words } = page
  const { spring } = words.say
  const number = (value: number) => shortNumber(words, value)
  const places = orbit.equilibria.map(({ u, stable }) =>
    words.fill(spring.captionPlace, { u: number(u), kind: stable ? spring.stable : spring.unstable }),
  )
  const caption = words.fill(spring.captionPotential, {
    from: number(-axes.reach),
    to: number(axes.reach),
    energy: number(orbit.energy),
    range: rangeWords(page, orbit),
  })
  return chart(page, {
    key: 'spring-potential',
    className: 'second-chart spring-potential',
    title: spring.potential,
    unit: spring.potentialUnit,
    name: spring.potential,
    height: 11,
    xLabels: false,
    draw: (size) => drawPotential(view, size),
    caption: `${caption} ${words.fill(spring.captionEquilibria, { list: places.join('; ') || spring.none })}`,
    table: () => tableOf(view),
  })
}

export function springPortrait(view: SpringView): TemplateResult {
  const { page, orbit } = view
  const { words } = page
  const { spring } = words.say
  return chart(page, {
    key: 'spring-portrait',
    className: 'first-chart phase-chart spring-portrait',
    title: spring.portrait,
    unit: spring.portraitUnit,
    name: spring.portrait,
    height: 17,
    xLabels: true,
    draw: (size) => drawPortrait(view, size),
    caption: words.fill(spring.captionPortrait, { start: startWords(page, orbit) }),
    cursor: startCursor(view),
    table: () => tableOf(view),
  })
}
