// Curves beside the exact motion: formulas of the angle and numerical solutions, and how far they are from it.
//
// The velocity of a formula for the angle is one thing that the core does not have: it is the slope of what is drawn.

import { approx, type Pendulum, type Regime } from 'libration'
import { type Curve, curveKey } from '../curves'
import { type Arrays, newArrays } from './arrays'

export interface Track {
  readonly theta: Float64Array
  readonly velocity: Float64Array
}

/** A curve beside the exact motion, and how far it is from it, in rad. */
export interface Compared extends Track {
  readonly error: Float64Array
}

/** Largest error over some periods from the start, in rad. */
export interface Largest {
  readonly value: number
  readonly t: number
  /** First time without a value; NaN if there is always one. */
  readonly gone: number
}

/** Why a curve is not drawn for a motion. */
export type Refusal = 'rotation' | 'separatrix' | 'start' | 'steps' | 'loading'

/** A curve beside the exact motion. */
export interface Solution {
  readonly curve: Curve
  theta(t: number): number
  velocity(t: number): number
  /** At the times of the exact motion. The error is without cancellation, or a plain difference where it must be quick. */
  compared(times: Float64Array, exact: Track, quick: boolean, arrays?: Arrays): Compared
  /** Over so many periods from the start, where the core searches for it; else null. */
  largest(periods: number): Largest | null
  /** Time in s at which it goes over the top though the exact motion does not; NaN if it does not. */
  readonly overTop: number
}

/** What a solution must know of the motion that it is compared with. */
interface Reference {
  readonly omega0: number
  readonly asGiven: boolean
  readonly balanced: boolean
  readonly regime: Regime
}

/** Times to either side at which the slope of a formula is taken, in s at a small-swing period of 2π s. */
const SLOPE = 1e-5

/** a + factor b. */
function combined(a: Float64Array, b: Float64Array, factor: 1 | -1, arrays: Arrays): Float64Array {
  const out = arrays.next(a.length)
  for (let i = 0; i < out.length; i++) out[i] = (a[i] as number) + factor * (b[i] as number)
  return out
}

const formulas = new Map<string, approx.AngleFormula>()

/** A formula by its name, which is read once. */
function formulaOf(key: string): approx.AngleFormula {
  const before = formulas.get(key)
  if (before) return before
  const made = approx.angle(key)
  formulas.set(key, made)
  return made
}

export class Formula implements Solution {
  readonly overTop = Number.NaN
  readonly #of: approx.AngleApproximation
  readonly #slope: number

  constructor(
    private readonly exact: Reference,
    pendulum: Pendulum,
    readonly curve: Curve,
  ) {
    this.#of = formulaOf(curveKey(curve)).of(pendulum)
    this.#slope = SLOPE / exact.omega0
  }

  theta(t: number): number {
    return this.#of.theta(t)
  }

  velocity(t: number): number {
    const h = this.#slope
    return (this.#of.theta(t + h) - this.#of.theta(t - h)) / (2 * h)
  }

  compared(times: Float64Array, exact: Track, quick: boolean, arrays = newArrays): Compared {
    const approximation = this.#of
    const h = this.#slope
    let velocity: Float64Array | null = null
    return {
      ...this.#both(times, exact.theta, quick || !this.exact.asGiven, arrays),
      // Asked for only where velocities are drawn.
      get velocity() {
        if (velocity) return velocity
        const after = approximation.theta(times.map((t) => t + h))
        const before = approximation.theta(times.map((t) => t - h))
        velocity = after.map((theta, i) => (theta - (before[i] as number)) / (2 * h))
        return velocity
      },
    }
  }

  /** Angle and error by one evaluation of the formula. */
  #both(
    times: Float64Array,
    exact: Float64Array,
    plain: boolean,
    arrays: Arrays,
  ): { theta: Float64Array; error: Float64Array } {
    const out = arrays.next(times.length)
    if (plain) {
      const theta = this.#of.theta(times, out)
      return { theta, error: combined(theta, exact, -1, arrays) }
    }
    const error = this.#of.difference(times, out)
    return { theta: combined(error, exact, 1, arrays), error }
  }

  largest(periods: number): Largest | null {
    if (!this.exact.asGiven) return null
    const { difference, t, undefinedFrom } = this.#of.error(periods)
    return { value: difference, t, gone: undefinedFrom }
  }
}

export class Stepped implements Solution {
  readonly #of: approx.NumericalSolution

  constructor(
    private readonly exact: Reference,
    pendulum: Pendulum,
    readonly curve: Curve,
    until: number,
  ) {
    this.#of = approx.numerical(curveKey(curve)).of(pendulum, until)
  }

  get overTop(): number {
    return this.exact.regime === 'libration' || this.exact.balanced ? this.#of.overTheTop : Number.NaN
  }

  theta(t: number): number {
    return this.#of.theta(t)
  }

  velocity(t: number): number {
    return this.#of.motion(t).velocity
  }

  compared(times: Float64Array, exact: Track, _quick: boolean, arrays = newArrays): Compared {
    const out = { theta: arrays.next(times.length), velocity: arrays.next(times.length) }
    const { theta, velocity } = this.#of.motion(times, out)
    return { theta, velocity, error: combined(theta, exact.theta, -1, arrays) }
  }

  largest(): null {
    return null
  }
}
