// Quantities of the derivation by another route than the core's, so that an equality has two sides: Legendre's integral by Carlson's
// duplication (DLMF 19.36.1, 19.25.5), Gauss's mean (DLMF 19.8.1), and slopes by central differences of order 8.

import type { Parameter } from '../model'

/** R_F(x, y, z) of numbers that are not negative, at most one of them 0. The series is cut where its next terms are below 1e-17. */
export function carlsonF(x: number, y: number, z: number): number {
  const mean = (x + y + z) / 3
  // |A − x|/A falls by 4 in each step, and the first terms that are left out are of its sixth power.
  let far = 700 * Math.max(Math.abs(mean - x), Math.abs(mean - y), Math.abs(mean - z))
  let [a, p, q, r] = [mean, x, y, z]
  while (far > a) {
    const [root, second, third] = [Math.sqrt(p), Math.sqrt(q), Math.sqrt(r)]
    const lambda = root * second + root * third + second * third
    a = (a + lambda) / 4
    p = (p + lambda) / 4
    q = (q + lambda) / 4
    r = (r + lambda) / 4
    far /= 4
  }
  const [u, v] = [1 - p / a, 1 - q / a]
  const w = -u - v
  const [e2, e3] = [u * v - w * w, u * v * w]
  return (1 - e2 / 10 + e3 / 14 + (e2 * e2) / 24 - (3 * e2 * e3) / 44) / Math.sqrt(a)
}

/** K by Carlson's integral. */
export const quarterOf = ({ mc }: Parameter): number => carlsonF(0, mc, 1)

/** F of the angle in (−π, π] whose sine and cosine are given: near a turning point a double has no room for the angle. */
export function legendreF(sin: number, cos: number, parameter: Parameter): number {
  const { mc } = parameter
  const [c, d] = [cos * cos, cos * cos + mc * sin * sin]
  const within = sin * carlsonF(c, d, c + sin * sin)
  return cos >= 0 ? within : (sin < 0 ? -2 : 2) * quarterOf(parameter) - within
}

/** Gauss's mean of two positive numbers. */
export function mean(a: number, b: number): number {
  let [one, other] = [a, b]
  // Each step doubles the digits that agree.
  while (Math.abs(one - other) > 1e-14 * one) [one, other] = [(one + other) / 2, Math.sqrt(one * other)]
  return (one + other) / 2
}

const WEIGHTS = [4 / 5, -1 / 5, 4 / 105, -1 / 280]
/** Places to either side of the middle. */
const REACH = WEIGHTS.length

/** Slope in the middle of values at even distances; 2 REACH + 1 of them. */
export function slope(values: ArrayLike<number>, distance: number): number {
  let sum = 0
  WEIGHTS.forEach((weight, i) => {
    sum += weight * ((values[REACH + i + 1] as number) - (values[REACH - i - 1] as number))
  })
  return sum / distance
}

/** A distance that a double adds without an error: a power of two below what is asked for. */
export const evenDistance = (about: number): number => 2 ** Math.floor(Math.log2(about))

/** Places for a slope. */
export function around(middle: number, distance: number): Float64Array {
  return Float64Array.from({ length: 2 * REACH + 1 }, (_, i) => middle + (i - REACH) * distance)
}
