// Jacobi's functions as lengths: on x² + (1 − m) y² = 1 the point at the polar angle φ = am(u) has sn = y/r, cn = x/r, dn = 1/r.
//
// u is the integral of r dφ. Since x = cn/dn = cd(u) = sn(u + K), the chord of a pendulum released from rest is 2L sin(θ/2) = 2L k x.

import { remember } from './memory'
import type { Model, Motion, Parameter } from './model'
import { evenTimes, type Window } from './study'

/** Points of a graph in a window. */
const POINTS = 480

export interface Place {
  readonly x: number
  readonly y: number
  readonly r: number
}

/** The point of the ellipse in a direction: r = 1/√(1 − m sin²φ), written without a difference. */
export function placeAt(cos: number, sin: number, { mc }: Parameter): Place {
  const r = 1 / Math.sqrt(cos * cos + mc * sin * sin)
  return { x: r * cos, y: r * sin, r }
}

/** Half its height; half its width is 1. */
export function heightOf({ mc }: Parameter): number {
  return 1 / Math.sqrt(mc)
}

/** Tallest ellipse that is drawn with equal axes, which is that of 155°. */
const TALLEST = 4.6

/** By how much y is shortened in the drawing: 1, 2, 5, 10 … */
export function shorteningOf(parameter: Parameter): number {
  const wanted = heightOf(parameter) / TALLEST
  if (wanted <= 1) return 1
  const power = 10 ** Math.floor(Math.log10(wanted))
  return ([1, 2, 5, 10].find((each) => each * power >= wanted) ?? 10) * power
}

/** Turning angle in rad of a modulus k. */
export function amplitudeOfModulus(k: number): number {
  return 2 * Math.asin(k)
}

/** Turning angle in rad of a parameter m: from the smaller of m and 1 − m. */
export function amplitudeOfParameter(m: number): number {
  return 2 * Math.atan2(Math.sqrt(m), Math.sqrt(1 - m))
}

/** What the view needs of a swing, the time apart. */
export interface Swing {
  readonly motion: Motion
  readonly parameter: Parameter
  /** Modulus. */
  readonly k: number
  /** Quarter period in u. */
  readonly quarter: number
  /** Time at which u is 0: the pendulum turns back on the right. */
  readonly turned: number
}

/** Null where the motion does not swing. */
export const swingOf = remember((model: Model, motion: Motion): Swing | null => {
  const { regime, balanced, energyRatio, energyRatioC } = motion
  if (balanced || regime === 'rotation' || regime === 'separatrix') return null
  const parameter = { m: energyRatio, mc: energyRatioC }
  return { motion, parameter, k: Math.sqrt(energyRatio), quarter: model.completeK(parameter), turned: motion.turned }
})

export const argumentAt = ({ motion, turned }: Swing, t: number): number => motion.omega0 * (t - turned)

export interface Instant {
  readonly u: number
  readonly phi: number
  readonly place: Place
  /** The core's own functions at u. */
  readonly sn: number
  readonly cn: number
  readonly dn: number
  /** Largest difference of the lengths, and of cos φ and sin φ, from them. */
  readonly difference: number
  readonly theta: number
  /** From the lowest point to the bob, in m, with its sign. */
  readonly chord: number
  /** 2 L k x, in m. */
  readonly projection: number
}

export function instantAt(model: Model, swing: Swing, t: number): Instant {
  const { parameter, motion, k } = swing
  const u = argumentAt(swing, t)
  const values = model.jacobi(Float64Array.of(u), parameter)
  const [sn = 0, cn = 0, dn = 0, phi = 0] = [values.sn[0], values.cn[0], values.dn[0], values.am[0]]
  // The direction by cn and sn: near φ = 90° of a tall ellipse a double has no room for its cosine.
  const place = placeAt(cn, sn, parameter)
  const { x, y, r } = place
  const angle = Math.max(Math.abs(Math.cos(phi) - cn), Math.abs(Math.sin(phi) - sn))
  const difference = Math.max(angle, Math.abs(y / r - sn), Math.abs(x / r - cn), Math.abs(1 / r - dn))
  const theta = motion.theta(t)
  const { length } = motion.setup
  return {
    u,
    phi,
    place,
    sn,
    cn,
    dn,
    difference,
    theta,
    chord: 2 * length * Math.sin(theta / 2),
    projection: 2 * length * k * x,
  }
}

export interface Graph {
  readonly times: Float64Array
  readonly u: Float64Array
  readonly sn: Float64Array
  readonly cn: Float64Array
  readonly dn: Float64Array
  readonly am: Float64Array
  /** x of the ellipse, cd(u). */
  readonly x: Float64Array
  /** The cosine of the same period. */
  readonly cosine: Float64Array
}

export const graphOf = remember((model: Model, swing: Swing, from: number, to: number): Graph => {
  const times = evenTimes({ from, to } satisfies Window, POINTS)
  const u = times.map((t) => argumentAt(swing, t))
  const { sn, cn, dn, am } = model.jacobi(u, swing.parameter)
  const x = cn.map((value, i) => value / (dn[i] as number))
  const cosine = u.map((value) => Math.cos((Math.PI * value) / (2 * swing.quarter)))
  return { times, u, sn, cn, dn, am, x, cosine }
})

/** The time in the window of a graph at which the ellipse's point is seen at a polar angle: am rises by 2π. */
export function timeAtAngle({ times, am }: Graph, phi: number): number {
  const first = am[0] as number
  const turn = 2 * Math.PI
  const wanted = first + ((((phi - first) % turn) + turn) % turn)
  const after = am.findIndex((value) => value >= wanted)
  if (after < 0) return times.at(-1) as number
  if (after === 0) return times[0] as number
  const [a, b] = [am[after - 1] as number, am[after] as number]
  const [from, to] = [times[after - 1] as number, times[after] as number]
  return from + ((to - from) * (wanted - a)) / (b - a)
}
