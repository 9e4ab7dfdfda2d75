// The law of the mean loss of energy: what the turning angle is later, to first order of the friction. Beside the turning points it shows how
// good that order is. A point may take milliseconds, so they are computed one by one.

import type { DampedPendulum } from 'libration'
import { type DampedMotion, dampedOf } from './friction'

export class AveragedLaw {
  readonly t: Float64Array
  /** Highest and lowest angles, about the turn in which it swings. */
  readonly above: Float64Array
  readonly below: Float64Array
  count = 0
  readonly #damped: DampedPendulum
  readonly #thetaMax: number
  readonly #from: number
  readonly #middle: number

  /** From the first turning point on, to where dry friction stops it; none where it does not turn back: the law says nothing of torques. */
  constructor(motion: DampedMotion, points: number) {
    const { setup, turning, reach, rests } = motion
    const last = rests.at(-1)
    const end = last && last[1] === reach ? last[0] : reach
    this.#damped = dampedOf(setup)
    const theta = turning.theta[0] ?? Number.NaN
    this.#from = turning.t[0] ?? Number.NaN
    this.#middle = 2 * Math.PI * Math.round(theta / (2 * Math.PI))
    this.#thetaMax = Math.abs(theta - this.#middle)
    const many = setup.torque !== 0 || setup.drive !== 0 || Number.isNaN(theta) ? 0 : points
    this.t = Float64Array.from({ length: many }, (_, i) => this.#from + ((end - this.#from) * (i + 1)) / many)
    this.above = new Float64Array(many)
    this.below = new Float64Array(many)
    if (this.done) this.#damped.free()
  }

  get done(): boolean {
    return this.count === this.t.length
  }

  /** One point more. */
  advance(): void {
    const at = this.count++
    const later = Float64Array.of((this.t[at] as number) - this.#from)
    const [angle = Number.NaN] = this.#damped.averagedTurningAngle(this.#thetaMax, later)
    this.above[at] = this.#middle + angle
    this.below[at] = this.#middle - angle
    if (this.done) this.#damped.free()
  }
}
