// The pendulum of the reader at one time, with all that the equalities of the derivation speak of. Exact values come from the model;
// start phase and integral by the second route. One moment a frame: what is slow is made when it is first asked for.

import { type Curve, curveKey } from '../curves'
import type { Model, Motion, Parameter, Solution } from '../model'
import { around, evenDistance, legendreF, quarterOf, slope } from './second-route'

/** How far a slope looks to either side, in units of 1/ω₀ or of the argument: truncation and rounding are then both below 1e-12. */
const DISTANCE = 0.02

/** sin, cos of half an angle and velocity/2ω₀: the place of a state in the energy circle. */
export interface Half {
  readonly s: number
  readonly c: number
  readonly x: number
}

/** The elliptic functions of a motion that swings or turns. */
interface Elliptic {
  readonly parameter: Parameter
  readonly k: number
  readonly quarter: number
  /** Argument per second. */
  readonly rate: number
  /** ±1, the direction of a turn; 1 for a swing. */
  readonly sign: number
  readonly u0: number
  readonly u: number
  readonly sn: number
  readonly cn: number
  readonly dn: number
  readonly am: number
  /** sin φ and cos φ by the motion itself, not by the functions. */
  readonly sinPhi: number
  readonly cosPhi: number
  /** √(1 − k² sin²φ) of the motion, without a difference. */
  readonly delta: number
  /** F(φ), φ counted on, by the second route. */
  readonly integral: number
  readonly slopeOfPhi: number
}

const FORMULAS = new WeakMap<Motion, Map<string, Solution | null>>()

/** What was asked of a motion before. */
function formulasOf(motion: Motion): Map<string, Solution | null> {
  let made = FORMULAS.get(motion)
  if (!made) {
    made = new Map()
    FORMULAS.set(motion, made)
  }
  return made
}

const sum = (a: number, b: number): number => Math.sqrt(a * a + b * b)

export class Moment {
  readonly omega0: number
  readonly theta: number
  readonly velocity: number
  readonly start: Half
  readonly now: Half
  /** κ² and 1 − κ². */
  readonly m: number
  readonly mc: number
  readonly kappa: number
  /** Distance in time at which slopes are taken. */
  readonly #distance: number

  constructor(
    readonly model: Model,
    readonly motion: Motion,
    readonly t: number,
  ) {
    const { theta0, velocity0 } = motion.setup
    this.omega0 = motion.omega0
    this.theta = motion.theta(t)
    this.velocity = motion.velocity(t)
    this.m = motion.energyRatio
    this.mc = motion.energyRatioC
    this.start = this.half(theta0, velocity0)
    this.now = this.half(this.theta, this.velocity)
    this.kappa = Math.sqrt(this.m)
    this.#distance = evenDistance(DISTANCE / (this.omega0 * Math.max(1, this.kappa)))
  }

  half(theta: number, velocity: number): Half {
    return { s: Math.sin(theta / 2), c: Math.cos(theta / 2), x: velocity / (2 * this.omega0) }
  }

  get regime() {
    return this.motion.regime
  }

  #times: Float64Array | null = null
  #track: ReturnType<Motion['sample']> | null = null
  /** The motion at the places of a slope. */
  get track() {
    this.#times ??= around(this.t, this.#distance)
    this.#track ??= this.motion.sample(this.#times)
    return this.#track
  }

  /** Slope at the time of a quantity given at the places of a slope. */
  slope(values: ArrayLike<number>): number {
    return slope(values, this.#distance)
  }

  #acceleration: number | null = null
  /** θ̈ as the slope of the velocity. */
  get acceleration(): number {
    this.#acceleration ??= this.slope(this.track.velocity)
    return this.#acceleration
  }

  /** The weight, its parts along the arc and along the rod, and the pull of the rod, in N for each kilogram: mg cos θ + mLθ̇². */
  get forces(): {
    readonly weight: number
    readonly along: number
    readonly across: number
    readonly pull: number
  } {
    const { gravity, length } = this.motion.setup
    const across = gravity * Math.cos(this.theta)
    const pull = across + length * this.velocity ** 2
    return { weight: gravity, along: -gravity * Math.sin(this.theta), across, pull }
  }

  /** What an acceleration is measured against: its largest, or where it turns over the square of the velocity that it changes. */
  get strongest(): number {
    return this.omega0 ** 2 * this.kappa * Math.max(1, this.kappa)
  }

  /** Jacobi's functions at one argument. */
  jacobi(u: number, parameter: Parameter) {
    const values = this.model.jacobi(Float64Array.of(u), parameter)
    const [sn = 0, cn = 0, dn = 0, am = 0] = [values.sn[0], values.cn[0], values.dn[0], values.am[0]]
    return { sn, cn, dn, am }
  }

  /** Slope of a combination of Jacobi's functions by its argument. */
  slopeOfJacobi(of: (sn: number, cn: number, dn: number) => number): number {
    const { u, parameter } = this.elliptic
    const distance = evenDistance(DISTANCE)
    const { sn, cn, dn } = this.model.jacobi(around(u, distance), parameter)
    const values = sn.map((each, i) => of(each, cn[i] as number, dn[i] as number))
    return slope(values, distance)
  }

  #elliptic: Elliptic | null = null
  /** Asked for only where the pendulum swings or turns over. */
  get elliptic(): Elliptic {
    this.#elliptic ??= this.regime === 'rotation' ? this.#turn() : this.#swing()
    return this.#elliptic
  }

  #swing(): Elliptic {
    const { m, mc, start, now, omega0 } = this
    const k = sum(start.s, start.x)
    const direction = ({ s, x }: Half) => [s / k, x / k] as const
    return this.#functions({ m, mc }, k, omega0, 1, direction(start), direction(now))
  }

  #turn(): Elliptic {
    const { m, mc, start, now, omega0, kappa } = this
    const sign = start.x < 0 ? -1 : 1
    const direction = ({ s, c }: Half) => [sign * s, c] as const
    const parameter = { m: 1 / m, mc: -mc / m }
    return this.#functions(parameter, 1 / kappa, omega0 * kappa, sign, direction(start), direction(now))
  }

  #functions(
    parameter: Parameter,
    k: number,
    rate: number,
    sign: number,
    before: readonly [number, number],
    now: readonly [number, number],
  ): Elliptic {
    const quarter = this.model.completeK(parameter)
    const u0 = legendreF(...before, parameter)
    const u = rate * this.t + u0
    const functions = this.jacobi(u, parameter)
    // Half turns of φ are counted by the functions, where in its half turn it is by the motion.
    const halfTurns = Math.round(functions.am / Math.PI)
    const odd = halfTurns % 2 === 0 ? 1 : -1
    const [sinPhi, cosPhi] = now
    const integral = 2 * halfTurns * quarterOf(parameter) + legendreF(odd * sinPhi, odd * cosPhi, parameter)
    const { theta, velocity } = this.track
    // φ at the places of a slope, from that in the middle on.
    const phi = theta.map((each, i) => {
      const { s, c, x } = this.half(each, velocity[i] as number)
      const [sin, cos] = this.regime === 'rotation' ? [sign * s, c] : [s / k, x / k]
      return Math.atan2(sin * cosPhi - cos * sinPhi, cos * cosPhi + sin * sinPhi)
    })
    return {
      parameter,
      k,
      quarter,
      rate,
      sign,
      u0,
      u,
      ...functions,
      sinPhi,
      cosPhi,
      delta: Math.sqrt(cosPhi * cosPhi + parameter.mc * sinPhi * sinPhi),
      integral,
      slopeOfPhi: this.slope(phi),
    }
  }

  /** A formula of the angle by the core; NaN where it is not written for this motion. */
  approximation(curve: Curve): Solution | null {
    const made = formulasOf(this.motion)
    const key = curveKey(curve)
    let found = made.get(key)
    if (found === undefined) {
      const solution = this.motion.solution(curve, 0)
      found = 'refused' in solution ? null : solution
      made.set(key, found)
    }
    return found
  }

  approximate(curve: Curve, t = this.t): number {
    return this.approximation(curve)?.theta(t) ?? Number.NaN
  }

  /** The right turning point that was last passed before the start, and the last turning point on either side. */
  get turned(): { readonly right: number; readonly last: number; readonly side: 1 | -1 } {
    const { turned, period } = this.motion
    const left = turned + period / 2
    return left <= 0 ? { right: turned, last: left, side: -1 } : { right: turned, last: turned, side: 1 }
  }
}
