// The pendulum with friction and torque in the terms of the page: its motion by the core, energies as parts of that at the top, and
// what happens in it.

import { DampedPendulum } from 'libration'
import type { FrictionAndTorque } from '../state'
import { type Setup, whereverStarted } from './motion'

export interface FrictionSetup extends Setup, FrictionAndTorque {}

/** A pendulum of the core. */
export function dampedOf(setup: FrictionSetup): DampedPendulum {
  const { theta0, velocity0, length, gravity, linear, quadratic, dry, torque, drive, driveFrequency } = setup
  return new DampedPendulum({
    theta0,
    velocity0,
    length,
    gravity,
    friction: { linear, quadratic, dry },
    torque: { constant: torque, amplitude: drive, frequency: driveFrequency },
  })
}

/** A time at which it turns back, and the angle. */
export interface Turning {
  readonly t: Float64Array
  readonly theta: Float64Array
}

/** What it comes to, of a motion without a torque that varies. */
type Outcome =
  | { readonly kind: 'exact' | 'still' }
  | { readonly kind: 'stops'; readonly t: number; readonly theta: number }
  | { readonly kind: 'halves'; readonly t: number }
  | { readonly kind: 'keeps'; readonly part: number }
  | { readonly kind: 'rotates'; readonly velocity: number }
  | { readonly kind: 'settles'; readonly theta: number }

/** Halvings that find a time. */
const HALVINGS = 60

export class DampedMotion {
  readonly #damped: DampedPendulum
  readonly #top: number
  /** How far it goes: shorter than asked for where it takes too many steps. */
  readonly reach: number
  /** Intervals over which dry friction holds it. */
  readonly rests: readonly (readonly [number, number])[]
  readonly turning: Turning

  constructor(
    readonly setup: FrictionSetup,
    until: number,
  ) {
    this.#damped = dampedOf(setup)
    this.#top = whereverStarted(setup.length, setup.gravity).top
    this.reach = this.#damped.reach(until)
    this.rests = this.#damped.rests(0, this.reach)
    const t = this.#damped.turningTimes(0, this.reach)
    this.turning = { t, theta: this.#damped.motion(t).theta }
  }

  /** Gives back what the core keeps of it. */
  free(): void {
    this.#damped.free()
  }

  sample(times: Float64Array): { readonly theta: Float64Array; readonly velocity: Float64Array } {
    return this.#damped.motion(times)
  }

  at(t: number): { readonly theta: number; readonly velocity: number } {
    return this.#damped.motion(t)
  }

  /** As a part of that at the top. */
  energyAt(t: number): number {
    return this.#damped.energy(t) / this.#top
  }

  /** How often it has gone over the top by the end, forwards less backwards. */
  get turnsOver(): number {
    return this.#damped.turns(this.reach).n - this.#damped.turns(0).n
  }

  /** Whether it has the energy to go over the top at the end. */
  get turnsStill(): boolean {
    return this.energyAt(this.reach) > 1
  }

  get driven(): boolean {
    return this.setup.drive !== 0
  }

  /** What a motion that is not driven comes to. */
  outcome(): Outcome {
    const { linear, quadratic, dry, torque } = this.setup
    const { reach } = this
    const last = this.rests.at(-1)
    if (last && last[1] === reach) {
      if (last[0] === 0) return { kind: 'still' }
      return { kind: 'stops', t: last[0], theta: this.at(reach).theta }
    }
    if (torque !== 0) return this.#underTorque()
    const first = this.energyAt(0)
    if (first === 0) return { kind: 'still' }
    if (linear === 0 && quadratic === 0 && dry === 0) return { kind: 'exact' }
    const end = this.energyAt(reach)
    if (end > first / 2) return { kind: 'keeps', part: end / first }
    // Friction only takes: the energy falls, and passes its half once.
    let [before, after] = [0, reach]
    for (let i = 0; i < HALVINGS; i++) {
      const middle = (before + after) / 2
      if (this.energyAt(middle) > first / 2) before = middle
      else after = middle
    }
    return { kind: 'halves', t: after }
  }

  /** Under a constant torque it goes round and round, or hangs aside. */
  #underTorque(): Outcome {
    const { reach } = this
    const [middle, end] = [this.at(reach / 2), this.at(reach)]
    const velocity = (end.theta - middle.theta) / (reach / 2)
    return Math.abs(end.theta - middle.theta) > 2 * Math.PI
      ? { kind: 'rotates', velocity }
      : { kind: 'settles', theta: end.theta - 2 * Math.PI * Math.round(end.theta / (2 * Math.PI)) }
  }
}
