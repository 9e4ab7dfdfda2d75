// What the charts of Friction are drawn from: the damped motion, the one without friction, and the section, which is computed in slices
// so that the page never waits for it.

import { remember } from '../memory'
import type { Motion } from '../model'
import { DampedMotion, type FrictionSetup } from '../model/friction'
import { Section } from '../model/section'
import type { State } from '../state'
import type { Store } from '../store'
import { evenTimes, within } from '../study'
import type { Live } from './page'

export interface FrictionView {
  /** The page at the time within what is shown: at the end it begins again. */
  readonly page: Live
  readonly damped: DampedMotion
  readonly tracks: Tracks
  /** Of a driven pendulum. */
  readonly section: Section | null
}

/** Both motions over the time shown. */
export interface Tracks {
  readonly times: Float64Array
  readonly theta: Float64Array
  readonly velocity: Float64Array
  /** Parts of the energy at the top. */
  readonly energy: Float64Array
  readonly free: Float64Array
}

export function setupOf(state: State): FrictionSetup {
  const { theta0, velocity0, length, gravity, linear, quadratic, dry, torque, drive, driveFrequency } = state
  return { theta0, velocity0, length, gravity, linear, quadratic, dry, torque, drive, driveFrequency }
}

const setupBy = remember((text: string): FrictionSetup => JSON.parse(text))

/** The same object while the numbers are the same. */
const setupNow = (state: State): FrictionSetup => setupBy(JSON.stringify(setupOf(state)))

let last: DampedMotion | null = null
const motionBy = remember((setup: FrictionSetup, until: number) => {
  // A long motion is megabytes: the one before is not left to the collector.
  last?.free()
  last = new DampedMotion(setup, until)
  return last
})

export const dampedOf = (state: State): DampedMotion => motionBy(setupNow(state), state.until)

/** Points of a curve: some for every swing. */
function pointsOf(until: number, motion: Motion): number {
  const rate = Math.max(motion.omega0, Math.abs(motion.setup.velocity0))
  return Math.min(12_000, Math.max(1200, Math.ceil(5 * rate * until)))
}

const tracksOf = remember((damped: DampedMotion, motion: Motion, until: number): Tracks => {
  const times = evenTimes({ from: 0, to: until }, pointsOf(until, motion))
  const { theta, velocity } = damped.sample(times)
  return { times, theta, velocity, energy: damped.energy(times), free: motion.sample(times).theta }
})

/** Points of the section, and periods before the first. */
const MOST = 2000
const SKIP = 100
/** How long a slice works, in ms: half a frame. */
const SLICE = 8

let running: { readonly section: Section; timer: ReturnType<typeof setTimeout> | null } | null = null

function work(store: Store, section: Section): void {
  if (running?.section !== section) return
  running.timer = null
  // Begun again when the view is.
  if (store.state.view !== 'friction') return
  const end = performance.now() + SLICE
  do section.advance()
  while (!section.done && performance.now() < end)
  if (!section.done) running.timer = setTimeout(() => work(store, section), 0)
  store.changed()
}

/** The section of what drives it now: another one is begun when anything changes, and the one before is left. */
export function sectionOf({ store, state }: Live): Section | null {
  if (state.drive === 0) return null
  const setup = setupNow(state)
  if (running?.section.setup !== setup) {
    if (running?.timer) clearTimeout(running.timer)
    running = { section: new Section(setup, MOST, SKIP), timer: null }
  }
  const { section } = running
  if (!section.done && running.timer === null) running.timer = setTimeout(() => work(store, section), 0)
  return section
}

export function frictionView(page: Live): FrictionView {
  const { state, motion } = page
  const damped = dampedOf(state)
  return {
    page: { ...page, t: within(page.t, state.until) },
    damped,
    tracks: tracksOf(damped, motion, state.until),
    section: sectionOf(page),
  }
}
