// The phase portrait: velocity against angle, the separatrix between swinging and turning over, and several orbits at once.
//
// A click, a drag or the arrow keys start the chosen orbit elsewhere. A start within a pixel of the separatrix is on it.

import { html, type TemplateResult } from 'lit-html'
import type { TableSpec } from '../columns'
import { plot } from '../draw/plot'
import { grainOf, linearScale, type Scale } from '../draw/scale'
import { isLocked } from '../embedding'
import { remember } from '../memory'
import type { Model, Motion } from '../model'
import { DEGREES, degrees, radians } from '../number'
import { allOrbits, letterOf, placeOf } from '../orbits'
import { inRange, type Start, type State } from '../state'
import { evenTimes, POINTS, spanOf, windowOf } from '../study'
import { roundTicksOf } from './axis-ticks'
import { bench } from './bench'
import { chart } from './chart'
import type { Cursor, PlotSize } from './chart-spec'
import { orbitAngle } from './orbit-angle'
import { orbitList, orbitWords } from './orbit-list'
import type { Live } from './page'
import { player } from './player'
import { type Loop, levelCurves, portraitGround, withinTurn } from './portrait'

const others = remember((model: Model, length: number, gravity: number, orbits: State['orbits']) =>
  orbits.map(({ theta0, velocity0 }) => model.motion({ theta0, velocity0, length, gravity })),
)

/** The motions of all orbits in the order of their letters. */
export function motionsOf({ model, motion, state }: Live): readonly Motion[] {
  const rest = others(model, state.length, state.gravity, state.orbits)
  const place = placeOf(state)
  return [...rest.slice(0, place), motion, ...rest.slice(place)]
}

const loops = new WeakMap<Motion, Loop[]>()

/** The curve of an orbit; none of a motion that stays where it is. */
function loopsOf(motion: Motion): Loop[] {
  const before = loops.get(motion)
  if (before) return before
  const { regime, energyRatio, thetaMax } = motion
  const all = regime === 'rest' ? [] : levelCurves(motion, energyRatio, thetaMax)
  const one = motion.setup.velocity0 < 0 ? all.slice(1) : all.slice(0, 1)
  const made = regime === 'libration' ? all : one
  loops.set(motion, made)
  return made
}

/** Steps of the axis of velocity, each half as long again in energy. */
const ENERGIES = Array.from({ length: 60 }, (_, n) => 2 * 1.5 ** n)

/** Greatest velocity of the axis: the first step with room for every start, so that a start in the frame does not move the frame. */
export function reachOf(motion: Motion, starts: readonly Start[]): number {
  const fastest = Math.max(...starts.map(({ velocity0 }) => Math.abs(velocity0)))
  const bottom = Float64Array.of(0)
  const reaches = ENERGIES.map((energy) => 1.02 * (motion.levelVelocity(bottom, energy)[0] as number))
  return reaches.find((reach) => reach >= fastest) ?? 1.02 * fastest
}

function scales(page: Live, { width, height }: Pick<PlotSize, 'width' | 'height'>): { sx: Scale; sy: Scale } {
  const reach = reachOf(page.motion, allOrbits(page.state))
  return { sx: linearScale([-180, 180], [0, width]), sy: linearScale([-reach, reach], [height, 0]) }
}

const rounded = (value: number, grain: number): number => Number((grain * Math.round(value / grain)).toPrecision(12))

/** The start at a point of the plot, in pixels. */
export function startAt(motion: Motion, x: number, y: number, sx: Scale, sy: Scale): Start {
  const pixel = { x: Math.abs(sx.invert(1) - sx.invert(0)), y: Math.abs(sy.invert(1) - sy.invert(0)) }
  const angle = Math.min(180, Math.max(-180, rounded(sx.invert(x), grainOf(pixel.x))))
  const theta0 = radians(angle)
  const velocity = Math.min(sy.high, Math.max(sy.low, sy.invert(y)))
  const top = motion.separatrixVelocity(theta0)
  if (Math.abs(angle) < 180 && Math.abs(Math.abs(velocity) - top) < 0.8 * pixel.y) {
    return { theta0, velocity0: velocity < 0 ? -top : top }
  }
  const grain = grainOf(pixel.y)
  const near = rounded(velocity, grain)
  // Never beyond the frame, which has room for it as it is.
  const fine = Math.sign(velocity) * grain * 0.01 * Math.floor(Math.abs(velocity) / (grain * 0.01))
  return { theta0, velocity0: Math.abs(near) > sy.high ? Number(fine.toPrecision(12)) : near }
}

/** Shows an orbit from its start. */
function begin({ store }: Live, start: Start): void {
  if (!inRange('theta0', start.theta0) || !inRange('velocity0', start.velocity0)) return
  store.clock.pause()
  store.set({ ...start, t: 0 })
}

function startCursor(page: Live): Cursor {
  const { state, words, store, motion } = page
  const { theta0, velocity0 } = state
  const { phase } = words.say
  // From the start as it is now: a second key may come before the page is drawn again.
  const move = (byAngle: number, byVelocity: number) => {
    const now = store.state
    const angle = Math.min(180, Math.max(-180, Number((degrees(now.theta0) + byAngle).toPrecision(12))))
    begin(page, { theta0: radians(angle), velocity0: Number((now.velocity0 + byVelocity).toPrecision(12)) })
  }
  return {
    label: words.fill(phase.startOf, { letter: letterOf(placeOf(state)) }),
    least: -180,
    most: 180,
    now: degrees(theta0),
    text: `${orbitWords(page, state)}: ${phase.regimes[motion.regime]}`,
    key: (event) => {
      const small = event.shiftKey ? 0.1 : 1
      const steps: Readonly<Record<string, readonly [number, number]>> = {
        ArrowLeft: [-small, 0],
        ArrowRight: [small, 0],
        ArrowUp: [0, 0.1 * small],
        ArrowDown: [0, -0.1 * small],
        PageUp: [0, 1],
        PageDown: [0, -1],
        Home: [-360, 0],
        End: [360, 0],
      }
      const step = steps[event.key]
      if (step) move(...step)
      return step !== undefined
    },
    drag: {
      begin: () => store.setSession({ held: 'start' }),
      at: (x, y, element) => {
        const box = element.getBoundingClientRect()
        const { sx, sy } = scales(page, box)
        begin(page, startAt(motion, x - box.left, y - box.top, sx, sy))
      },
      end: (dropped) => {
        store.setSession({ held: null })
        if (dropped) begin(page, { theta0, velocity0 })
        else if (!store.session.reduced && !matchMedia('(prefers-reduced-motion: reduce)').matches) store.play()
      },
    },
  }
}

interface Spot {
  readonly x: number
  readonly y: number
}

/** A letter where its orbit starts; moved outwards while the moving point is there. */
function letters({ state }: Live, size: PlotSize, sx: Scale, sy: Scale, spots: readonly Spot[]): TemplateResult[] {
  const { width, height, rem } = size
  return allOrbits(state).map(({ theta0, velocity0 }, place) => {
    const start = { x: sx(theta0 * DEGREES), y: sy(velocity0) }
    const spot = spots[place] ?? start
    const away = { x: start.x - width / 2, y: start.y - height / 2 }
    const far = Math.hypot(away.x, away.y)
    const beside = Math.hypot(start.x - spot.x, start.y - spot.y) < 1.3 * rem ? 1.3 * rem : 0
    const x = start.x + (far > 1 ? (away.x * beside) / far : beside)
    const y = start.y + (far > 1 ? (away.y * beside) / far : 0)
    const left = Math.min(Math.max(x, 0.5 * rem), width - 0.5 * rem)
    const top = Math.min(Math.max(y, 0.625 * rem), height - 0.625 * rem)
    return html`<b class="letter-mark" aria-hidden="true" style="left:${left.toFixed(1)}px;top:${top.toFixed(1)}px">${letterOf(place)}</b>`
  })
}

function draw(page: Live, size: PlotSize): TemplateResult {
  const { motion, words, t, state } = page
  const { width, height, rem } = size
  const { sx, sy } = scales(page, size)
  const { phase } = words.say
  const motions = motionsOf(page)
  const chosen = placeOf(state)
  const narrow = width < 26 * rem
  const high = 0.8 * sy.high
  const beside = 100
  const labels = [
    { x: sx(-174), y: sy(high), text: narrow ? phase.over : phase.forwards, anchor: 'start' as const },
    { x: sx(-174), y: sy(-high) + 0.6 * rem, text: narrow ? phase.over : phase.backwards, anchor: 'start' as const },
    {
      // On a narrow plot it ends at the edge, however long the word is.
      x: narrow ? width - 0.25 * rem : sx(beside) + 0.25 * rem,
      y: sy(-motion.separatrixVelocity(radians(beside))) + 1.1 * rem,
      text: phase.separatrix,
      anchor: narrow ? ('end' as const) : ('start' as const),
    },
    ...(motions.some(({ regime, thetaMax }) => regime === 'libration' && thetaMax < 0.4)
      ? []
      : [{ x: width / 2, y: height / 2 + 0.3 * rem, text: phase.swings }]),
  ]
  const angles = narrow ? [-180, -90, 0, 90, 180] : [-180, -120, -60, 0, 60, 120, 180]
  const lines = motions.flatMap((each, place) =>
    loopsOf(each).map((loop) => ({ ...loop, clothes: place === chosen ? 'c-exact' : 'c-orbit', place })),
  )
  lines.sort((a, b) => Number(a.place === chosen) - Number(b.place === chosen))
  const drawing = plot(
    {
      ...size,
      sx,
      sy,
      xs: angles.map((value) => ({ value, text: `${words.typed(value)}°` })),
      ys: roundTicksOf(words, sy.low, sy.high, 7),
      xLabels: true,
      lines,
      labels,
      under: portraitGround(motion, sx, sy),
    },
    [motion, others, state.orbits, chosen, sy.key, words],
  )
  const spots = motions.map((each) => ({ x: sx(withinTurn(each.theta(t)) * DEGREES), y: sy(each.velocity(t)) }))
  return html`${drawing}${letters(page, size, sx, sy, spots)}
    ${spots.map((spot, place) => html`<b class=${place === chosen ? 'handle spot' : 'orbit-spot'} style="left:${spot.x.toFixed(1)}px;top:${spot.y.toFixed(1)}px"></b>`)}`
}

/** Velocity upwards at whole degrees, as it is drawn; downwards it is the same with the other sign. */
function tableOf(page: Live): TableSpec {
  const { words } = page
  const { phase, table, units } = words.say
  const theta = Float64Array.from({ length: 361 }, (_, i) => radians(i - 180))
  const column = (title: string, motion: Motion) => {
    const { regime, energyRatio, thetaMax, setup } = motion
    const sign = regime !== 'libration' && setup.velocity0 < 0 ? -1 : 1
    const velocity = motion.levelVelocity(theta, energyRatio)
    const values = velocity.map((value, i) => (Math.abs(theta[i] as number) > thetaMax ? Number.NaN : sign * value))
    return { title, values, factor: 1, decimals: 3 }
  }
  const motions = motionsOf(page)
  return {
    caption: words.fill(table.caption, { plot: phase.tableCaption, unit: units['rad/s'] }),
    file: 'phase',
    first: { title: '_θ_, °', values: theta, factor: DEGREES, decimals: 0 },
    columns: [
      ...motions.map((each, place) => column(letterOf(place), each)),
      {
        title: phase.separatrix,
        values: theta.map((angle) => page.motion.separatrixVelocity(angle)),
        factor: 1,
        decimals: 3,
      },
    ],
  }
}

function portrait(page: Live): TemplateResult {
  const { words, motion } = page
  const { phase } = words.say
  const orbits = allOrbits(page.state).map((start, place) =>
    words.fill(phase.captionOrbit, {
      letter: letterOf(place),
      start: orbitWords(page, start),
      regime: phase.regimes[(motionsOf(page)[place] as Motion).regime],
    }),
  )
  return chart(page, {
    key: 'phase',
    className: 'first-chart phase-chart',
    title: phase.title,
    unit: phase.unit,
    name: phase.title,
    height: 30,
    xLabels: true,
    draw: (size) => draw(page, size),
    caption: `${phase.caption} ${orbits.join('; ')}.`,
    ...(isLocked(page.state, 'theta0') || isLocked(page.state, 'velocity0') ? {} : { cursor: startCursor(page) }),
    table: () => tableOf(page),
    sound: () => {
      const span = spanOf({ span: 'T' }, motion)
      const values = motion.sample(evenTimes({ from: 0, to: span }, POINTS)).velocity
      const reach = reachOf(motion, allOrbits(page.state))
      return { values, low: -reach, high: reach }
    },
  })
}

export function phase(page: Live): TemplateResult {
  const { motion, t, words, state } = page
  const window = windowOf(spanOf({ span: 'T' }, motion), t)
  const endless = !Number.isFinite(motion.period)
  const letter = letterOf(placeOf(state))
  const last = html`<span class="soft option">${endless ? '' : words.fill(words.say.phase.onePeriod, { letter })}</span>`
  return html`<div class="columns phase-columns">${bench(page, [])}
    <div class="column middle">${portrait(page)}${player(page, window, [], last)}</div>
    <div class="column right">${orbitList(page, motionsOf(page))}${orbitAngle(page, motionsOf(page), window)}</div>
  </div>`
}

/** Where the chosen orbit lies, in one sentence. */
export function phaseSentence({ motion, state, words }: Live): string {
  const { phase } = words.say
  const letter = letterOf(placeOf(state))
  const { regime, energyRatio, energyRatioC, period, thetaMax } = motion
  const part = (value: number) => words.with(words.significant(100 * value, 2), '%')
  switch (regime) {
    case 'rest':
      return words.fill(motion.balanced ? phase.balance : phase.rest, { letter })
    case 'separatrix':
      return words.fill(phase.onIt, { letter })
    case 'rotation':
      return words.fill(state.velocity0 < 0 ? phase.outsideBack : phase.outside, {
        letter,
        period: words.with(words.fixed(period, 3), words.say.units.s),
        energy: part(energyRatio - 1),
      })
    default:
      return words.fill(phase.inside, {
        letter,
        top: words.angle(thetaMax, angleDecimals(thetaMax)),
        energy: part(energyRatioC),
      })
  }
}

/** As few decimals as tell the angle, at most two. */
function angleDecimals(theta: number): number {
  const value = theta * DEGREES
  return [0, 1].find((digits) => Math.abs(value - Number(value.toFixed(digits))) < 1e-6) ?? 2
}
