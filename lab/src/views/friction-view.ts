// What the charts of Friction are drawn from: the damped motion, the one without friction, and the section. What takes long is computed in
// slices, so that the page never waits for it.

import { remember } from '../memory'
import type { Motion } from '../model'
import { AveragedLaw } from '../model/averaged'
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
  /** Of one that is not. */
  readonly averaged: AveragedLaw | null
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

function setupOf(state: State): FrictionSetup {
  const { theta0, velocity0, length, gravity, linear, quadratic, dry, torque, drive, driveFrequency } = state
  return { theta0, velocity0, length, gravity, linear, quadratic, dry, torque, drive, driveFrequency }
}

const setupBy = remember((text: string): FrictionSetup => JSON.parse(text))

/** The same object while the numbers are the same. */
const setupNow = (state: State): FrictionSetup => setupBy(JSON.stringify(setupOf(state)))

/** Points of a curve: some for every swing. */
function pointsOf(until: number, motion: Motion): number {
  const rate = Math.max(motion.omega0, Math.abs(motion.setup.velocity0))
  return Math.min(12_000, Math.max(1200, Math.ceil(5 * rate * until)))
}

let last: DampedMotion | null = null
const motionBy = remember((setup: FrictionSetup, until: number, points: number) => {
  // A long motion is megabytes: the one before is not left to the collector.
  last?.free()
  last = new DampedMotion(setup, until, evenTimes({ from: 0, to: until }, points))
  return last
})

/** The motion now. One that takes long is not done yet: it goes on beside the page. */
export function dampedOf({ store, state, motion }: Live): DampedMotion {
  const damped = motionBy(setupNow(state), state.until, pointsOf(state.until, motion))
  return damped.done ? damped : slowly(store, damped, () => damped)
}

const tracksOf = remember((damped: DampedMotion, motion: Motion): Tracks => {
  const { times, track } = damped
  return { times, ...track, energy: motion.energy(track).total, free: motion.sample(times).theta }
})

/** Points of the section, and periods before the first. */
const MOST = 2000
const SKIP = 100
/** Points of the averaged law. */
const AVERAGED = 24
/** How long a slice works, in ms: half a frame. */
const SLICE = 8

/** What is computed beside the page: a long motion, then the section of what is driven, the averaged law of what is not. */
type Slow = DampedMotion | Section | AveragedLaw

interface Running {
  readonly slow: Slow
  /** What it belongs to. */
  readonly of: unknown
  timer: ReturnType<typeof setTimeout> | null
}

let running: Running | null = null

function work(store: Store, slow: Slow): void {
  if (running?.slow !== slow) return
  running.timer = null
  // Begun again when the view is.
  if (store.state.view !== 'friction') return
  const end = performance.now() + SLICE
  do slow.advance()
  while (!slow.done && performance.now() < end)
  if (!slow.done) running.timer = setTimeout(() => work(store, slow), 0)
  store.changed()
}

/** Goes on with what belongs to something; another one is begun when that is another, and the one before is left. */
function slowly<S extends Slow>(store: Store, of: unknown, make: () => S): S {
  const before = running
  const now: Running = before && before.of === of ? before : { slow: make(), of, timer: null }
  if (now !== before && before?.timer) clearTimeout(before.timer)
  running = now
  const { slow } = now
  if (!slow.done && now.timer === null) now.timer = setTimeout(() => work(store, slow), 0)
  return slow as S
}

/** The section of what drives it now. */
export function sectionOf({ store, state }: Live): Section | null {
  if (state.drive === 0) return null
  const setup = setupNow(state)
  return slowly(store, setup, () => new Section(setup, MOST, SKIP))
}

/** Of a motion that is done. */
export function frictionView(page: Live): FrictionView {
  const { state, motion } = page
  const damped = dampedOf(page)
  return {
    page: { ...page, t: within(page.t, state.until) },
    damped,
    tracks: tracksOf(damped, motion),
    section: sectionOf(page),
    averaged: state.drive === 0 ? slowly(page.store, damped, () => new AveragedLaw(damped, AVERAGED)) : null,
  }
}
