// Curves of one energy in the phase plane of a spring: found between the places where the speed vanishes.

import type { SpringOrbit } from './spring'
import { type Force, potential } from './spring-force'

interface Level {
  readonly x: Float64Array
  readonly y: Float64Array
}

/** Steps in which a change of sign is looked for, and halvings that find it. */
const STEPS = 400
const HALVINGS = 40
/** Points of a stretch. */
const POINTS = 121

/** Stretches of u within ±reach whose potential is below an energy; the places of `parted` are ends of stretches. */
function stretches(force: Force, energy: number, reach: number, parted: readonly number[]): [number, number][] {
  // What an unstable equilibrium itself lacks of its own energy is rounding.
  const slack = 4 * Number.EPSILON * Math.max(Math.abs(energy), Math.abs(potential(force, reach)) * 1e-3)
  const above = (u: number) => energy - potential(force, u) >= -slack
  const even = Array.from({ length: STEPS + 1 }, (_, i) => -reach + (2 * reach * i) / STEPS)
  const places = [...even, ...parted.filter((u) => Math.abs(u) < reach)].sort((a, b) => a - b)
  const out: [number, number][] = []
  let from: number | null = above(-reach) ? -reach : null
  for (let i = 1; i < places.length; i++) {
    const [a, b] = [places[i - 1] as number, places[i] as number]
    if (above(a) !== above(b)) {
      let [inside, outside] = above(a) ? [a, b] : [b, a]
      for (let k = 0; k < HALVINGS; k++) {
        const middle = (inside + outside) / 2
        if (above(middle)) inside = middle
        else outside = middle
      }
      if (from === null) from = inside
      else {
        out.push([from, inside])
        from = null
      }
    }
    if (from !== null && from !== b && parted.includes(b)) {
      out.push([from, b])
      from = b
    }
  }
  if (from !== null && from < reach) out.push([from, reach])
  return out
}

/** The curves of an energy within ±reach: closed where both ends are turning points, else an upper and a lower one. */
export function levelCurves(force: Force, energy: number, reach: number, parted: readonly number[] = []): Level[] {
  return stretches(force, energy, reach, parted).flatMap(([from, to]) => {
    // Close together at the ends, where the curve bends.
    const x = Float64Array.from({ length: POINTS }, (_, i) => {
      return (from + to) / 2 - ((to - from) / 2) * Math.cos((Math.PI * i) / (POINTS - 1))
    })
    const up = x.map((u) => Math.sqrt(Math.max(0, 2 * (energy - potential(force, u)))))
    const down = up.map((speed) => -speed)
    if (from > -reach && to < reach)
      return [{ x: Float64Array.from([...x, ...x.toReversed()]), y: Float64Array.from([...up, ...down.toReversed()]) }]
    return [
      { x, y: up },
      { x, y: down },
    ]
  })
}

/** The curve of an orbit. Where neither end is a turning point its two halves are motions of their own: that of the start is taken. */
export function levelThrough(orbit: SpringOrbit, reach: number): Level[] {
  const { force, energy, regime, u0, velocity0 } = orbit
  if (regime === 'rest') return []
  const limit = regime === 'homoclinic' || regime === 'heteroclinic'
  const parted = limit ? orbit.equilibria.filter(({ stable }) => !stable).map(({ u }) => u) : []
  const slack = 1e-9 * reach
  const own = levelCurves(force, energy, reach, parted).filter(({ x }) => {
    return u0 >= (x[0] as number) - slack && u0 <= (x[POINTS - 1] as number) + slack
  })
  const passed = (u: number) => Math.abs(u) === reach || parted.includes(u)
  const halves = own.every(({ x }) => passed(x[0] as number) && passed(x[POINTS - 1] as number))
  if (!halves || velocity0 === 0) return own
  return own.flatMap(({ x, y }) => {
    const [up, down] = [y.slice(0, POINTS), y.slice(0, POINTS).map((speed) => -Math.abs(speed))]
    const half = x.slice(0, POINTS)
    return y.length > POINTS
      ? [{ x: half, y: velocity0 > 0 ? up : down }]
      : (y[POINTS >> 1] as number) * velocity0 > 0
        ? [{ x, y }]
        : []
  })
}
