// The springs in the terms of the page: motions of the core, with what the force says beside them.

import { CubicQuintic, Duffing, type SpringRegime } from 'libration'
import { type Equilibrium, equilibria, type Force, isEven, potential } from './spring-force'

export type { SpringRegime } from 'libration'

interface SpringTrack {
  readonly u: Float64Array
  readonly velocity: Float64Array
}

/** What a spring is called: by the signs of its coefficients. */
type SpringName = 'hardening' | 'softening' | 'double' | 'repelling' | 'linear' | 'free' | 'even' | 'quintic'

function nameOf(force: Force): SpringName {
  const { p, q, s } = force
  if (isEven(force)) return 'even'
  if (s !== 0) return 'quintic'
  if (q === 0) return p === 0 ? 'free' : p > 0 ? 'linear' : 'repelling'
  if (p < 0) return q > 0 ? 'double' : 'repelling'
  return q > 0 ? 'hardening' : p > 0 ? 'softening' : 'repelling'
}

/** One motion. */
export class SpringOrbit {
  readonly #spring: Duffing | CubicQuintic
  readonly name: SpringName
  /** Whether the force has even powers. */
  readonly even: boolean
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
    const { kind, p, r, q, c, s } = force
    const quintic = kind === 'cubic-quintic'
    const spring = quintic ? new CubicQuintic({ u0, velocity0, p, q, s }) : new Duffing({ u0, velocity0, p, q, r, c })
    this.#spring = spring
    this.name = nameOf(force)
    this.even = isEven(force)
    this.regime = spring.regime
    this.period = spring.period
    ;[this.low, this.high] = spring.range
    this.energy = spring.energy
    this.escapeTime = spring.escapeTime
    this.escapeTimeBackward = spring.escapeTimeBackward
    this.equilibria = equilibria(force)
    this.barriers = [...new Set(this.equilibria.filter(({ stable }) => !stable).map(({ height }) => height))]
    const w = u0 * u0
    const rates = [...this.equilibria.map(({ rate }) => rate), Math.sqrt(Math.abs(p + r * u0 + w * (q + w * s)))]
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
