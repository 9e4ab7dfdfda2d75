// The Poincaré section of a driven pendulum: angle and velocity once in every period of the drive.
//
// After a whole number of periods the drive is as at the start, so the motion is cut there: each piece begins where the one before ended,
// with the angle within one turn. That rounds the state to doubles once in a piece, as a start is, and keeps memory and angles small. A
// period in which the pendulum is too fast for one piece (piece.ts) is cut as well.

import type { DampedPendulum } from 'libration'
import { dampedOf, type FrictionSetup } from './friction'
import { pieceOf } from './piece'

/** Periods of a piece at most. */
const PERIODS = 16
/** Longest period after which a motion is found to repeat, in periods of the drive, and how near it has to come back. */
export const LONGEST = 16
const NEAR = 1e-6
/** As often it has to. */
const TIMES = 3

export class Section {
  /** Angles in [−π, π) and velocities; as many as `count` hold. */
  readonly angles: Float64Array
  readonly velocities: Float64Array
  count = 0
  /** Whether the core gave up: within a period it takes more steps than it keeps. */
  stopped = false
  #skipped = 0
  #state: readonly [number, number]
  /** Time since a period began, where one takes several pieces. */
  #within = 0

  /** The first `skip` periods are left out: what the start makes of it dies away. */
  constructor(
    readonly setup: FrictionSetup,
    readonly most: number,
    readonly skip: number,
  ) {
    this.angles = new Float64Array(most)
    this.velocities = new Float64Array(most)
    this.#state = [setup.theta0, setup.velocity0]
  }

  get done(): boolean {
    return this.stopped || this.count === this.most
  }

  /** One piece more. */
  advance(): void {
    const [theta0, velocity0] = this.#state
    const frequency = this.setup.driveFrequency
    const period = (2 * Math.PI) / frequency
    const damped = dampedOf({ ...this.setup, theta0, velocity0 }, frequency * this.#within)
    const left = period - this.#within
    const whole = (time: number) => pieceOf(this.setup, velocity0, time) === time
    if (whole(left)) {
      let periods = this.#within === 0 ? PERIODS : 1
      while (periods > 1 && !whole(periods * period)) periods /= 2
      this.#state = this.#points(damped, left, period, periods)
      this.#within = 0
    } else {
      const time = pieceOf(this.setup, velocity0, left)
      this.stopped = damped.reach(time) < time
      this.#state = this.stopped ? this.#state : [damped.turns(time).angle, damped.motion(time).velocity]
      this.#within += time
    }
    damped.free()
  }

  /** The points at the ends of some periods, the first after a time; the state at the last. */
  #points(damped: DampedPendulum, first: number, period: number, periods: number): readonly [number, number] {
    const end = first + period * (periods - 1)
    const reach = damped.reach(end)
    const reached = reach < end ? Math.max(0, Math.floor((reach - first) / period + 1)) : periods
    this.stopped = reached < periods
    const times = Float64Array.from({ length: reached }, (_, i) => first + period * i)
    const { velocity } = damped.motion(times)
    const { angle } = damped.turns(times)
    for (let i = 0; i < reached && this.count < this.most; i++) {
      if (this.#skipped < this.skip) this.#skipped++
      else {
        this.angles[this.count] = angle[i] as number
        this.velocities[this.count] = velocity[i] as number
        this.count++
      }
    }
    return this.stopped ? this.#state : [angle[periods - 1] as number, velocity[periods - 1] as number]
  }

  /** Periods of the drive after which the motion repeats at its end; null where it does not, or too few are known. */
  get repeats(): number | null {
    const { angles, velocities, count } = this
    const near = (i: number, j: number) => {
      const turn = Math.abs((angles[i] as number) - (angles[j] as number))
      const apart = Math.min(turn, 2 * Math.PI - turn)
      const scale = 1 + Math.abs(velocities[i] as number)
      return apart < NEAR && Math.abs((velocities[i] as number) - (velocities[j] as number)) < NEAR * scale
    }
    for (let k = 1; k <= LONGEST; k++) {
      const last = TIMES * k
      if (count <= last + k) return null
      if (Array.from({ length: last }, (_, i) => count - 1 - i).every((i) => near(i, i - k))) return k
    }
    return null
  }
}
