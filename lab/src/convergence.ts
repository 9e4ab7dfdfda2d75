// How the error of each scheme of a fixed step falls with its step: the largest over one small-swing period, for steps that are
// halved again and again. The slope on axes of logarithms is the order of the scheme.
//
// The error is the larger of those of the angle and of the velocity over ω0: started at the bottom, Euler–Cromer has an angle of
// second order and a velocity of first.

import type { Curve, CurveName } from './curves'
import { remember } from './memory'
import type { Motion } from './model'

/** Steps to a small-swing period: a wide one to begin with, halved so many times. */
const FEWEST = 16
const HALVINGS = 8
/** The slopes that theory gives. */
export const ORDERS = { euler: 1, 'euler-cromer': 1, verlet: 2, rk4: 4 } as const satisfies Partial<
  Record<CurveName, number>
>
export const SCHEMES = Object.keys(ORDERS) as (keyof typeof ORDERS)[]
/** In rad: below, an error is the rounding of some thousand steps as well. */
const ROUNDING = 1e-10

export interface Convergence {
  /** Steps in s, falling. */
  readonly steps: Float64Array
  readonly schemes: readonly {
    readonly name: keyof typeof ORDERS
    /** In rad, for each step. */
    readonly errors: Float64Array
    /** Between the two smallest steps whose error is more than rounding; NaN where there are none. */
    readonly slope: number
  }[]
}

function largest(motion: Motion, curve: Curve, times: Float64Array): number {
  const solution = motion.solution(curve, times.at(-1) as number)
  if ('refused' in solution) return Number.NaN
  const exact = motion.sample(times)
  const { error, velocity } = solution.compared(times, exact, true)
  let most = 0
  for (let i = 0; i < times.length; i++) {
    const late = ((velocity[i] as number) - (exact.velocity[i] as number)) / motion.omega0
    most = Math.max(most, Math.abs(error[i] as number), Math.abs(late))
  }
  return most
}

/** Slope of a falling row of errors. */
export function slopeOf(steps: Float64Array, errors: Float64Array): number {
  let last = errors.length - 1
  while (last > 0 && !((errors[last] as number) > ROUNDING)) last--
  if (last < 1) return Number.NaN
  return (
    Math.log((errors[last - 1] as number) / (errors[last] as number)) /
    Math.log((steps[last - 1] as number) / (steps[last] as number))
  )
}

export const convergence = remember((motion: Motion): Convergence => {
  const counts = Array.from({ length: HALVINGS + 1 }, (_, i) => FEWEST * 2 ** i)
  const steps = Float64Array.from(counts, (count) => motion.smallPeriod / count)
  const schemes = SCHEMES.map((name) => {
    const errors = Float64Array.from(counts, (count, i) => {
      const step = steps[i] as number
      // Their ends, where a scheme says what it is; the last one within the solution whatever its rounding.
      const times = Float64Array.from({ length: count }, (_, k) => k * step)
      return largest(motion, { name, argument: step, on: true }, times)
    })
    return { name, errors, slope: slopeOf(steps, errors) }
  })
  return { steps, schemes }
})
