// The springs u″ + p u + q u³ + s u⁵ = 0 in the terms of the page: motions of the core, and the potential beside them.
//
// The core has no potential and no list of equilibria: V(u) = p u²/2 + q u⁴/4 + s u⁶/6 and the roots of V′ are computed here, and
// tests/springs.test.ts holds them to the core's energies and motions.

import { CubicQuintic, Duffing, type SpringRegime } from 'libration'
import type { SpringKind } from '../state'

export type { SpringRegime } from 'libration'

/** The coefficients; that of u⁵ is nothing to a Duffing oscillator. */
export interface Force {
  readonly kind: SpringKind
  readonly p: number
  readonly q: number
  readonly s: number
}

interface Equilibrium {
  readonly u: number
  /** The potential there. */
  readonly height: number
  readonly stable: boolean
  /** √|V″|: of small oscillations, or how fast it is left. */
  readonly rate: number
}

/** V(u), 0 at u = 0. */
export function potential({ p, q, s }: Force, u: number): number {
  const w = u * u
  return w * (p / 2 + w * (q / 4 + (w * s) / 6))
}

/** u² > 0 where p + q u² + s u⁴ vanishes, rising. */
function squares({ p, q, s }: Force): number[] {
  if (s === 0) return q === 0 ? [] : [-p / q].filter((w) => w > 0)
  const square = q * q - 4 * p * s
  if (square < 0) return []
  // Without cancellation; the other root is their product over this one.
  const sum = -(q + (q < 0 ? -1 : 1) * Math.sqrt(square)) / 2
  const roots = sum === 0 ? [] : [sum / s, p / sum]
  return [...new Set(roots)].filter((w) => w > 0 && Number.isFinite(w)).sort((a, b) => a - b)
}

/** Where a start at rest stays, from left to right. */
export function equilibria(force: Force): Equilibrium[] {
  const { p, q, s } = force
  const at = (u: number): Equilibrium => {
    const w = u * u
    const bend = p + w * (3 * q + 5 * w * s)
    const stable = u === 0 && p === 0 ? q > 0 || (q === 0 && s > 0) : bend > 0
    return { u, height: potential(force, u), stable, rate: Math.sqrt(Math.abs(bend)) }
  }
  const right = squares(force).map((w) => Math.sqrt(w))
  return [...right.map((u) => -u).reverse(), 0, ...right].map(at)
}

interface SpringTrack {
  readonly u: Float64Array
  readonly velocity: Float64Array
}

/** What a spring is called: by the signs of its coefficients. */
type SpringName = 'hardening' | 'softening' | 'double' | 'repelling' | 'linear' | 'free' | 'quintic'

function nameOf({ kind, p, q, s }: Force): SpringName {
  if (kind === 'cubic-quintic' && s !== 0) return 'quintic'
  if (q === 0) return p === 0 ? 'free' : p > 0 ? 'linear' : 'repelling'
  if (p < 0) return q > 0 ? 'double' : 'repelling'
  return q > 0 ? 'hardening' : p > 0 ? 'softening' : 'repelling'
}

/** One motion. */
export class SpringOrbit {
  readonly #spring: Duffing | CubicQuintic
  readonly name: SpringName
  readonly regime: SpringRegime
  readonly period: number
  readonly low: number
  readonly high: number
  readonly energy: number
  readonly escapeTime: number
  readonly escapeTimeBackward: number
  readonly equilibria: readonly Equilibrium[]
  /** Energies of the unstable equilibria: those of the separatrices. */
  readonly barriers: readonly number[]
  /** A time in which something happens: 1 over the fastest rate of its equilibria and its start. */
  readonly scale: number

  constructor(
    readonly force: Force,
    readonly u0: number,
    readonly velocity0: number,
  ) {
    const { kind, p, q, s } = force
    const spring =
      kind === 'duffing' ? new Duffing({ u0, velocity0, p, q }) : new CubicQuintic({ u0, velocity0, p, q, s })
    this.#spring = spring
    this.name = nameOf(force)
    this.regime = spring.regime
    this.period = spring.period
    ;[this.low, this.high] = spring.range
    this.energy = spring.energy
    this.escapeTime = spring.escapeTime
    this.escapeTimeBackward = spring.escapeTimeBackward
    this.equilibria = equilibria(force)
    this.barriers = [...new Set(this.equilibria.filter(({ stable }) => !stable).map(({ height }) => height))]
    const w = u0 * u0
    const rates = [...this.equilibria.map(({ rate }) => rate), Math.sqrt(Math.abs(p + w * (q + w * s)))]
    this.scale = 1 / (Math.max(...rates) || 1)
  }

  sample(times: Float64Array): SpringTrack {
    return this.#spring.motion(times)
  }

  at(t: number): { readonly u: number; readonly velocity: number } {
    return this.#spring.motion(t)
  }

  /** +1 or −1: to which side it escapes. */
  get escapesTo(): number {
    return Math.sign(this.at(this.escapeTime * (1 - 1e-9)).u)
  }

  /** Speed on the level of an energy; NaN where it does not come. */
  speed(u: number, energy: number): number {
    return Math.sqrt(2 * (energy - potential(this.force, u)))
  }
}

/** The force without what its kind has not. */
export function forceOf(kind: SpringKind, p: number, q: number, s: number): Force {
  return { kind, p, q, s: kind === 'duffing' ? 0 : s }
}

interface SpringStart {
  readonly p: number
  readonly q: number
  readonly u0: number
  readonly springVelocity0: number
}

/** The Duffing oscillator that moves as tan(θ/2) of a pendulum; null where that is infinite. */
export function companionOf(theta0: number, velocity0: number, length: number, gravity: number): SpringStart | null {
  if (Math.abs(theta0) === Math.PI) return null
  const { u0, velocity0: springVelocity0, p, q } = Duffing.ofPendulum({ theta0, velocity0, length, gravity })
  return { u0, springVelocity0, p, q }
}
