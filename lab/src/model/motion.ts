// Exact motions in the terms of the page.
//
// Two things the core does not have: the upright balance, which the double nearest to π is not; and the separatrix, on which almost
// no pair of doubles lies.

import { approx, DomainError, Pendulum, type Regime } from 'libration'
import { type Curve, curveKey, kindOf } from '../curves'
import { remember } from '../memory'
import { newArrays } from './arrays'
import { needsSecond, secondLoaded } from './second'
import { Formula, type Refusal, type Solution, Stepped, type Track } from './solution'

export interface Setup {
  readonly theta0: number
  readonly velocity0: number
  readonly length: number
  readonly gravity: number
}

/** Parts of the energy at the top. */
export interface Energy {
  readonly kinetic: Float64Array
  readonly potential: Float64Array
  readonly total: Float64Array
}

/** Most steps of all numerical solutions that are computed for a frame: less than a tenth of a second of work. */
export const MOST_STEPS = 500_000

/** Angle and velocity of an exact motion. */
interface Exact {
  theta(t: number): number
  velocity(t: number): number
  motion(times: Float64Array, out?: Track): Track
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

/** What is the same wherever it starts: the period of small swings and the energy at the top. */
export const whereverStarted = remember((length: number, gravity: number) => {
  const pendulum = new Pendulum({ theta0: 0, length, gravity })
  return { smallPeriod: pendulum.period, top: pendulum.energies({ theta: Math.PI, velocity: 0 }).potential }
})

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
    const { smallPeriod, top } = whereverStarted(length, gravity)
    this.smallPeriod = smallPeriod
    this.#top = top
    this.thetaMax = limit || this.regime === 'rotation' || this.regime === 'separatrix' ? Math.PI : pendulum.thetaMax
    this.energyRatio = limit ? 1 : pendulum.energyRatio
    this.energyRatioC = limit ? 0 : pendulum.energyRatioC
  }

  theta(t: number): number {
    return this.#exact.theta(t)
  }

  velocity(t: number): number {
    return this.#exact.velocity(t)
  }

  sample(times: Float64Array, arrays = newArrays): Track {
    return this.#exact.motion(times, { theta: arrays.next(times.length), velocity: arrays.next(times.length) })
  }

  energy({ theta, velocity }: Track, arrays = newArrays): Energy {
    const { length } = theta
    const out = { kinetic: arrays.next(length), potential: arrays.next(length) }
    const { kinetic, potential } = this.#pendulum.energies({ theta, velocity }, out)
    const total = arrays.next(length)
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

  /** How many steps a numerical solution takes: RK45 one or two in the time of a radian, each as much work as four of the others. */
  #steps({ argument }: Curve, until: number): number {
    return argument === undefined ? 6 * until * (this.omega0 + Math.abs(this.setup.velocity0)) : until / argument
  }

  /** Until a time; where it is numerical, in no more than so many steps. */
  solution(curve: Curve, until: number, most = MOST_STEPS): Solution | { readonly refused: Refusal } {
    if (kindOf(curve.name).numerical) {
      if (this.#steps(curve, until) > most) return { refused: 'steps' }
      return new Stepped(this, this.#pendulum, curve, until)
    }
    if (needsSecond(curve.name) && !secondLoaded()) return { refused: 'loading' }
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
