// The axes of the three charts of a spring, in round steps: a start that moves within them does not move them.

import { roundUp } from '../draw/scale'
import type { SpringOrbit } from '../model/spring'

export interface SpringAxes {
  /** u goes from −reach to reach. */
  readonly reach: number
  readonly fastest: number
  readonly lowest: number
  readonly highest: number
  /** u in the plot over time. */
  readonly times: readonly [number, number]
  /** Time shown from 0 on. */
  readonly span: number
}

/** Two periods; to a little beyond the escape; or as long as an endless motion takes to show what it does. */
export function springSpan({ period, escapeTime, regime, scale }: SpringOrbit): number {
  if (Number.isFinite(escapeTime)) return 1.25 * escapeTime
  if (regime === 'rest' || !Number.isFinite(period)) return 10 * scale
  return 2 * period
}

const POINTS = 200

/** A range below has no scale in doubles: it is drawn as nothing beside another one. */
const LEAST = 1e-290
const wide = (range: number, other: number): number => (range > LEAST ? range : other)

/** What the plot over time shows: the whole of a bounded motion; of an escape four times what lies inside, and its own side. */
function timeAxis(orbit: SpringOrbit, inner: number, farthest: number): readonly [number, number] {
  const { escapeTime, u0 } = orbit
  if (!Number.isFinite(escapeTime)) {
    const most = roundUp(wide(1.08 * Math.max(farthest, Math.abs(u0)), 1))
    return [-most, most]
  }
  const most = roundUp(wide(4 * inner, 1))
  const side = orbit.escapesTo
  // It turns once at most on its way.
  const far = Math.min(
    side * u0,
    Number.isFinite(orbit.low) ? orbit.low : Number.isFinite(orbit.high) ? -orbit.high : -most,
  )
  const other = far < -most / 5 ? -most : -most / 4
  return side > 0 ? [other, most] : [-most, -other]
}

export function springAxes(orbit: SpringOrbit): SpringAxes {
  const { u0, velocity0, low, high, energy, equilibria, barriers, scale } = orbit
  const outer = Math.max(0, ...equilibria.map(({ u }) => Math.abs(u)))
  const bounded = Number.isFinite(low) && Number.isFinite(high)
  const farthest = bounded ? Math.max(-low, high) : 0
  const reach = roundUp(wide(Math.max(1.08 * farthest, (bounded ? 1.05 : 1.5) * Math.abs(u0), 1.4 * outer), 1))
  const inner = bounded ? Math.max(farthest, outer) : 1.2 * Math.max(Math.abs(u0), outer)
  const inside = Array.from({ length: POINTS + 1 }, (_, i) => inner * ((2 * i) / POINTS - 1))
  const top = Math.max(energy, ...barriers)
  const speeds = inside.map((u) => orbit.speed(u, top)).filter((speed) => !Number.isNaN(speed))
  const fastest = roundUp(
    wide(Math.max(1.08 * Math.max(0, ...speeds), 1.15 * Math.abs(velocity0)), wide(reach / scale, 1)),
  )
  const heights = equilibria.map(({ height }) => height)
  const lowest = Math.min(energy, ...heights)
  const rise = wide(Math.max(energy, ...heights) - lowest, wide(fastest ** 2 / 2, 1))
  return {
    reach,
    fastest,
    lowest: lowest - 0.12 * rise,
    highest: lowest + 1.3 * rise,
    times: timeAxis(orbit, inner, farthest),
    span: springSpan(orbit),
  }
}
