// The only file that knows the core: exact motions, curves and functions in the terms of the page. No formula of its own.
//
// Three things the core does not have: the upright balance, which the double nearest to π is not; the separatrix, on which
// almost no pair of doubles lies; and the velocity of a formula for the angle, which is the slope of what it draws.

import { approx, DomainError, elliptic, load, loadSecond, Pendulum, type Regime } from 'libration'
import { type Curve, curveKey, kindOf } from './curves'

export type { Regime } from 'libration'

export interface Setup {
  readonly theta0: number
  readonly velocity0: number
  readonly length: number
  readonly gravity: number
}

export interface Track {
  readonly theta: Float64Array
  readonly velocity: Float64Array
}

/** A curve beside the exact motion, and how far it is from it, in rad. */
export interface Compared extends Track {
  readonly error: Float64Array
}

/** Parts of the energy at the top. */
export interface Energy {
  readonly kinetic: Float64Array
  readonly potential: Float64Array
  readonly total: Float64Array
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

/** Formulas of the angle in the second module of the core, which has those of the period and the elliptic functions too. */
const SECOND: readonly string[] = ['small-m', 'small-m-bounded', 'cubic', 'cubic-quintic']
let secondLoaded = false

/** A curve beside the exact motion. */
export interface Solution {
  readonly curve: Curve
  theta(t: number): number
  velocity(t: number): number
  /** At the times of the exact motion. The error is without cancellation, or a plain difference where it must be quick. */
  compared(times: Float64Array, exact: Track, quick: boolean): Compared
  /** Over so many periods from the start, where the core searches for it; else null. */
  largest(periods: number): Largest | null
  /** Time in s at which it goes over the top though the exact motion does not; NaN if it does not. */
  readonly overTop: number
}

/** Most steps of a numerical solution: a tenth of a second of work. */
export const MOST_STEPS = 1_000_000

/** Times to either side at which the slope of a formula is taken, in s at a small-swing period of 2π s. */
const SLOPE = 1e-5

/** Angle and velocity of an exact motion. */
interface Exact {
  theta(t: number): number
  velocity(t: number): number
  motion(times: Float64Array): Track
}

function still(theta: number): Exact {
  return {
    theta: () => theta,
    velocity: () => 0,
    motion: (times) => ({ theta: times.map(() => theta), velocity: times.map(() => 0) }),
  }
}

/** How near to the velocity of the separatrix a start is taken to mean it: what rounding does to that velocity. */
const ROUNDING = 4 * Number.EPSILON
/** Longer than a unit pendulum takes between any two doubles of the angle, to either side. */
const LONG = 50

/**
 * The separatrix through a start whose velocity is that of the separatrix as a double has it. The unit pendulum with velocity 2
 * at the bottom is on it exactly; this one is the same motion in another unit of time, begun when it passes the start.
 */
function separatrix(pendulum: Pendulum): Exact | null {
  const { theta0, velocity0, omega0 } = pendulum
  const there = pendulum.separatrixVelocity(theta0)
  if (velocity0 === 0 || !(Math.abs(Math.abs(velocity0) - there) <= ROUNDING * there)) return null
  const unit = new Pendulum({ theta0: 0, velocity0: 2 * Math.sign(velocity0) })
  const [start] = unit.times(theta0, -LONG, LONG)
  if (start === undefined) return null
  return {
    theta: (t) => unit.theta(start + omega0 * t),
    velocity: (t) => omega0 * unit.velocity(start + omega0 * t),
    motion: (times) => {
      const { theta, velocity } = unit.motion(times.map((t) => start + omega0 * t))
      return { theta, velocity: velocity.map((value) => omega0 * value) }
    },
  }
}

export class Motion {
  readonly #pendulum: Pendulum
  readonly #exact: Exact
  /** Whether the motion shown is that of the core for the doubles of the start: neither balance nor rounded separatrix. */
  readonly asGiven: boolean
  /** At rest on the top: π is between two doubles, so the core cannot be asked for it. */
  readonly balanced: boolean
  readonly regime: Regime
  readonly omega0: number
  readonly period: number
  readonly smallPeriod: number
  /** π where it turns over. */
  readonly thetaMax: number
  /** Energy over the energy at the top: the parameter m of the elliptic functions. */
  readonly energyRatio: number
  /** 1 − energyRatio, with all its digits. */
  readonly energyRatioC: number
  readonly #top: number

  constructor(readonly setup: Setup) {
    const { theta0, velocity0, length, gravity } = setup
    this.balanced = Math.abs(theta0) === Math.PI && velocity0 === 0
    const pendulum = new Pendulum(setup)
    this.#pendulum = pendulum
    const limit = this.balanced ? still(theta0) : separatrix(pendulum)
    this.#exact = limit ?? pendulum
    this.asGiven = limit === null
    this.regime = this.balanced ? 'rest' : limit ? 'separatrix' : pendulum.regime
    this.omega0 = pendulum.omega0
    this.period = limit ? Number.POSITIVE_INFINITY : pendulum.period
    this.smallPeriod = new Pendulum({ theta0: 0, length, gravity }).period
    this.thetaMax = limit || this.regime === 'rotation' || this.regime === 'separatrix' ? Math.PI : pendulum.thetaMax
    this.energyRatio = limit ? 1 : pendulum.energyRatio
    this.energyRatioC = limit ? 0 : pendulum.energyRatioC
    this.#top = pendulum.energies({ theta: Math.PI, velocity: 0 }).potential
  }

  theta(t: number): number {
    return this.#exact.theta(t)
  }

  velocity(t: number): number {
    return this.#exact.velocity(t)
  }

  sample(times: Float64Array): Track {
    return this.#exact.motion(times)
  }

  energy({ theta, velocity }: Track): Energy {
    const { kinetic, potential } = this.#pendulum.energies({ theta, velocity })
    const total = new Float64Array(kinetic.length)
    for (let i = 0; i < total.length; i++) {
      total[i] = ((kinetic[i] as number) + (potential[i] as number)) / this.#top
      kinetic[i] = (kinetic[i] as number) / this.#top
      potential[i] = (potential[i] as number) / this.#top
    }
    return { kinetic, potential, total }
  }

  energyAt(theta: number, velocity: number): { readonly kinetic: number; readonly potential: number } {
    const { kinetic, potential } = this.#pendulum.energies({ theta, velocity })
    return { kinetic: kinetic / this.#top, potential: potential / this.#top }
  }

  /** Velocity with which it would just reach the top from an angle. */
  separatrixVelocity(theta: number): number {
    return this.#pendulum.separatrixVelocity(theta)
  }

  /** Velocity upwards at each angle on the level of an energy, as a part of that at the top; 0 beyond its turning angle. */
  levelVelocity(theta: Float64Array, energyRatio: number): Float64Array {
    const { potential } = this.#pendulum.energies({ theta, velocity: new Float64Array(theta.length) })
    return potential.map((at) => Math.sqrt(Math.max(0, 2 * (energyRatio * this.#top - at))))
  }

  /** The last time up to the start at which it turned back on the right; 0 at rest, NaN where it does not turn back. */
  get turned(): number {
    if (this.regime === 'rest') return 0
    if (this.regime !== 'libration') return Number.NaN
    return this.#pendulum.times(this.thetaMax, -this.period, 0).at(-1) ?? Number.NaN
  }

  /** The same pendulum started elsewhere. */
  from(theta0: number, velocity0: number): Motion {
    return new Motion({ ...this.setup, theta0, velocity0 })
  }

  /** Whole turns, and the angle left in [−π, π). */
  turns(t: number): { readonly n: number; readonly angle: number } {
    return this.#pendulum.turns(t)
  }

  solution(curve: Curve, until: number): Solution | { readonly refused: Refusal } {
    const step = curve.argument ?? 0
    if (kindOf(curve.name).numerical) {
      if (step > 0 && until / step > MOST_STEPS) return { refused: 'steps' }
      return new Stepped(this, this.#pendulum, curve, until)
    }
    if (SECOND.includes(curve.name) && !secondLoaded) return { refused: 'loading' }
    try {
      // Asked of a motion that is the separatrix beyond doubt, so that what needs a period says so.
      if (this.regime === 'separatrix') approx.angle(curveKey(curve)).of(new Pendulum({ theta0: 0, velocity0: 2 }))
      return new Formula(this, this.#pendulum, curve)
    } catch (error) {
      if (!(error instanceof DomainError)) throw error
      return {
        refused: this.regime === 'separatrix' ? 'separatrix' : error.argument === 'regime' ? 'rotation' : 'start',
      }
    }
  }
}

/** a + factor b. */
function combined(a: Float64Array, b: Float64Array, factor: 1 | -1): Float64Array {
  const out = new Float64Array(a.length)
  for (let i = 0; i < out.length; i++) out[i] = (a[i] as number) + factor * (b[i] as number)
  return out
}

class Formula implements Solution {
  readonly overTop = Number.NaN
  readonly #of: approx.AngleApproximation
  readonly #slope: number

  constructor(
    private readonly exact: Motion,
    pendulum: Pendulum,
    readonly curve: Curve,
  ) {
    this.#of = approx.angle(curveKey(curve)).of(pendulum)
    this.#slope = SLOPE / exact.omega0
  }

  theta(t: number): number {
    return this.#of.theta(t)
  }

  velocity(t: number): number {
    const h = this.#slope
    return (this.#of.theta(t + h) - this.#of.theta(t - h)) / (2 * h)
  }

  compared(times: Float64Array, exact: Track, quick: boolean): Compared {
    const approximation = this.#of
    const h = this.#slope
    let velocity: Float64Array | null = null
    return {
      ...this.#both(times, exact.theta, quick || !this.exact.asGiven),
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
  #both(times: Float64Array, exact: Float64Array, plain: boolean): { theta: Float64Array; error: Float64Array } {
    if (plain) {
      const theta = this.#of.theta(times)
      return { theta, error: combined(theta, exact, -1) }
    }
    const error = this.#of.difference(times)
    return { theta: combined(error, exact, 1), error }
  }

  largest(periods: number): Largest | null {
    if (!this.exact.asGiven) return null
    const { difference, t, undefinedFrom } = this.#of.error(periods)
    return { value: difference, t, gone: undefinedFrom }
  }
}

class Stepped implements Solution {
  readonly #of: approx.NumericalSolution

  constructor(
    private readonly exact: Motion,
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

  compared(times: Float64Array, exact: Track): Compared {
    const { theta, velocity } = this.#of.motion(times)
    return { theta, velocity, error: combined(theta, exact.theta, -1) }
  }

  largest(): null {
    return null
  }
}

/** What is known of a formula before it is asked anything. */
export interface Known {
  readonly name: string
  readonly formula: string
  readonly source: string
  readonly stated: string
  /** In rad; null where its author states none. */
  readonly statedRange: readonly [number, number] | null
  readonly orders: { readonly least: number; readonly most: number; readonly step: number } | null
}

function known(entries: readonly approx.Entry[]): Known[] {
  return entries.map((entry) => ({
    name: entry.name,
    formula: entry.formula,
    source: entry.source,
    stated: entry.stated,
    statedRange: entry.statedRange ?? null,
    orders: entry.orders ?? null,
  }))
}

/** The parameter of the elliptic functions and its complement 1 − m. */
export interface Parameter {
  readonly m: number
  readonly mc: number
}

const smaller = ({ m, mc }: Parameter): { m: number } | { mc: number } => (mc < m ? { mc } : { m })

export class Model {
  /** Whether formulas of the period and elliptic functions are there. */
  readonly complete = secondLoaded

  /** Formulas of the angle and, once complete, of the period, in the order of the registry. */
  readonly angles: readonly Known[] = known(approx.angle.entries)
  readonly periods: readonly Known[] = secondLoaded ? known(approx.period.entries) : []

  motion(setup: Setup): Motion {
    return new Motion(setup)
  }

  /** Largest angle for which the author offers the formula; null if none is stated. */
  statedMost(name: string): number | null {
    return this.angles.find((each) => each.name === name)?.statedRange?.[1] ?? null
  }

  readonly #ends = new Map<string, number>()

  /** Turning angle in rad from which a formula has no value somewhere in a swing, to 1e-6; found by halving, once. */
  undefinedAbove(curve: Curve): number {
    const key = curveKey(curve)
    const before = this.#ends.get(key)
    if (before !== undefined) return before
    const formula = approx.angle(key)
    let [low, high] = [0, Math.PI]
    while (high - low > 1e-6) {
      const middle = (low + high) / 2
      const { undefinedFrom } = formula.of(new Pendulum({ theta0: middle })).error(1)
      if (Number.isNaN(undefinedFrom)) low = middle
      else high = middle
    }
    this.#ends.set(key, high)
    return high
  }

  /** T/T₀ by a formula of the period, at turning angles in rad. */
  periodRatio(name: string, thetaMax: Float64Array): Float64Array {
    return approx.period(name).ratio({ thetaMax })
  }

  /** Its relative error, without cancellation. */
  periodError(name: string, thetaMax: Float64Array): Float64Array {
    return approx.period(name).error({ thetaMax })
  }

  jacobi(
    u: Float64Array,
    parameter: Parameter,
  ): { readonly sn: Float64Array; readonly cn: Float64Array; readonly dn: Float64Array; readonly am: Float64Array } {
    return elliptic.jacobi(u, smaller(parameter))
  }

  completeK(parameter: Parameter): number {
    return elliptic.completeK(smaller(parameter))
  }
}

/** Loads the core: the module with vectors where the browser has them, else the scalar one. */
export async function openModel(sources?: Parameters<typeof load>[0]): Promise<Model> {
  await load(sources)
  return new Model()
}

/** The model with all that is in the second module. */
export async function completedModel(source?: Parameters<typeof loadSecond>[0]): Promise<Model> {
  await loadSecond(source)
  secondLoaded = true
  return new Model()
}
