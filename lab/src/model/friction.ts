// The pendulum with friction and torque in the terms of the page: its motion by the core, energies as parts of that at the top, and
// what happens in it.

import { DampedPendulum } from 'libration'
import type { FrictionAndTorque } from '../state'
import { type Setup, whereverStarted } from './motion'
import { pieceOf } from './piece'

export interface FrictionSetup extends Setup, FrictionAndTorque {}

/** A pendulum of the core, with the phase of the drive at its start. */
export function dampedOf(setup: FrictionSetup, phase = 0): DampedPendulum {
  const { theta0, velocity0, length, gravity, linear, quadratic, dry, torque, drive, driveFrequency } = setup
  return new DampedPendulum({
    theta0,
    velocity0,
    length,
    gravity,
    friction: { linear, quadratic, dry },
    torque: { constant: torque, amplitude: drive, frequency: driveFrequency, phase },
  })
}

/** A time at which it turns back, and the angle. */
export interface Turning {
  readonly t: Float64Array
  readonly theta: Float64Array
}

/** What it comes to, of a motion without a torque that varies. */
type Outcome =
  | { readonly kind: 'exact' | 'still' }
  | { readonly kind: 'stops'; readonly t: number; readonly theta: number }
  | { readonly kind: 'halves'; readonly t: number }
  | { readonly kind: 'keeps'; readonly part: number }
  | { readonly kind: 'rotates'; readonly velocity: number }
  | { readonly kind: 'settles'; readonly theta: number }

/** Halvings that find a time. */
const HALVINGS = 60
/** Most pieces: half a minute of work. */
const MOST_PIECES = 1000
/** Pieces whose pendulums are kept: those of the start or the end, and of the time shown. */
const KEPT = 2

/** Where a piece begins. */
interface Start {
  readonly t: number
  /** Whole turns until then; the angle is within one. */
  readonly turns: number
  readonly theta: number
  readonly velocity: number
  /** As a part of that at the top. */
  readonly energy: number
}

/** A state, with its energy as a part of that at the top. */
type Moment = Pick<Start, 'theta' | 'velocity' | 'energy'>

/** Arrays as one. */
function joined(parts: readonly Float64Array[]): Float64Array {
  const out = new Float64Array(parts.reduce((sum, { length }) => sum + length, 0))
  let at = 0
  for (const part of parts) {
    out.set(part, at)
    at += part.length
  }
  return out
}

/**
 * A motion until a time, computed in pieces of some milliseconds (piece.ts). Nearly every motion is one piece, computed at once: the core's
 * own. Each piece more begins where the one before ended, with the state rounded to doubles, as a start is. Of pieces only their starts are
 * kept, so that a long motion is small; one in which a state is asked for is computed again.
 */
export class DampedMotion {
  /** Angles and velocities at the times that were given; NaN where it does not reach them. */
  readonly track: { readonly theta: Float64Array; readonly velocity: Float64Array }
  readonly #top: number
  readonly #pieces: Start[] = []
  #kept: { readonly piece: Start; readonly damped: DampedPendulum }[] = []
  readonly #rests: (readonly [number, number])[] = []
  readonly #turned: { readonly t: Float64Array[]; readonly theta: Float64Array[] } = { t: [], theta: [] }
  #turning: Turning | null = null
  #outcome: Outcome | null = null
  #sampled = 0
  #reach = 0
  /** Whole turns at the start and at the end. */
  readonly #turnsFirst: number
  #turns = 0
  #end: Moment
  #ended = false

  /** The times rise. */
  constructor(
    readonly setup: FrictionSetup,
    readonly until: number,
    readonly times: Float64Array = new Float64Array(),
  ) {
    const { theta0: theta, velocity0: velocity, length, gravity } = setup
    this.#top = whereverStarted(length, gravity).top
    this.track = { theta: new Float64Array(times.length), velocity: new Float64Array(times.length) }
    for (const values of Object.values(this.track)) values.fill(Number.NaN)
    const first = dampedOf(setup)
    const energy = first.energy(0) / this.#top
    this.#end = { theta, velocity, energy }
    this.#turnsFirst = first.turns(0).n
    const start = { t: 0, turns: 0, theta, velocity, energy }
    this.#pieces.push(start)
    this.#kept.push({ piece: start, damped: first })
    if (pieceOf(setup, velocity, until) === until) this.advance()
  }

  /** Whether all of it is there that will be. */
  get done(): boolean {
    return this.#ended || this.#reach === this.until
  }

  /** How far it goes: shorter than asked for where it was ended, or takes too many steps. */
  get reach(): number {
    return this.#reach
  }

  /** Intervals over which dry friction holds it. */
  get rests(): readonly (readonly [number, number])[] {
    return this.#rests
  }

  /** Once it is done. */
  get turning(): Turning {
    this.#turning ??= { t: joined(this.#turned.t), theta: joined(this.#turned.theta) }
    return this.#turning
  }

  /** No more of it. */
  end(): void {
    this.#ended = true
  }

  /** Gives back what the core keeps of it. */
  free(): void {
    for (const { damped } of this.#kept) damped.free()
    this.#kept = []
  }

  /** One piece more. */
  advance(): void {
    const piece = this.#pieces.at(-1) as Start
    const left = this.until - piece.t
    const asked = pieceOf(this.setup, piece.velocity, left)
    const damped = this.#pendulum(piece)
    const reach = damped.reach(asked)
    this.#keep(piece, damped, reach)
    this.#ended = reach < asked || this.#pieces.length === MOST_PIECES
    this.#reach = reach === left ? this.until : piece.t + reach
    const { n, angle } = damped.turns(reach)
    const { theta, velocity } = damped.motion(reach)
    const energy = damped.energy(reach) / this.#top
    this.#turns = piece.turns + n
    this.#end = { theta: absolute(piece, theta), velocity, energy }
    if (!this.done) this.#pieces.push({ t: this.#reach, turns: this.#turns, theta: angle, velocity, energy })
  }

  /** Rests, turning points and samples of a piece. */
  #keep(piece: Start, damped: DampedPendulum, reach: number): void {
    const { times, track } = this
    for (const [from, to] of damped.rests(0, reach)) {
      const before = this.#rests.at(-1)
      // A rest that goes on after the end of a piece is one.
      const goesOn = before && from === 0 && before[1] === piece.t
      if (goesOn) this.#rests.pop()
      this.#rests.push([goesOn ? before[0] : piece.t + from, piece.t + to])
    }
    const turned = damped.turningTimes(0, reach)
    this.#turned.t.push(turned.map((t) => piece.t + t))
    this.#turned.theta.push(damped.motion(turned).theta.map((theta) => absolute(piece, theta)))
    const from = this.#sampled
    while (this.#sampled < times.length && (times[this.#sampled] as number) <= piece.t + reach) this.#sampled++
    const inside = times.subarray(from, this.#sampled).map((t) => Math.min(t - piece.t, reach))
    const { theta, velocity } = damped.motion(inside)
    track.theta.set(
      theta.map((each) => absolute(piece, each)),
      from,
    )
    track.velocity.set(velocity, from)
  }

  /** That of a piece, from its start on. */
  #pendulum(piece: Start): DampedPendulum {
    const known = this.#kept.find((each) => each.piece === piece)
    if (known) return known.damped
    const { theta: theta0, velocity: velocity0, t } = piece
    const phase = (this.setup.driveFrequency * t) % (2 * Math.PI)
    const damped = dampedOf({ ...this.setup, theta0, velocity0 }, phase)
    this.#kept.unshift({ piece, damped })
    for (const { damped: old } of this.#kept.splice(KEPT)) old.free()
    return damped
  }

  /** The piece that holds a time. */
  #pieceAt(t: number): Start {
    let [low, high] = [0, this.#pieces.length]
    while (high - low > 1) {
      const middle = (low + high) >> 1
      if ((this.#pieces[middle] as Start).t <= t) low = middle
      else high = middle
    }
    return this.#pieces[low] as Start
  }

  /** NaN where it does not reach a time. */
  at(t: number): Moment {
    if (t === this.#reach) return this.#end
    if (!(t < this.#reach)) return { theta: Number.NaN, velocity: Number.NaN, energy: Number.NaN }
    const piece = this.#pieceAt(t)
    const damped = this.#pendulum(piece)
    const { theta, velocity } = damped.motion(t - piece.t)
    return { theta: absolute(piece, theta), velocity, energy: damped.energy(t - piece.t) / this.#top }
  }

  /** As a part of that at the top. */
  energyAt(t: number): number {
    return this.at(t).energy
  }

  /** How often it has gone over the top by the end, forwards less backwards. */
  get turnsOver(): number {
    return this.#turns - this.#turnsFirst
  }

  /** Whether it has the energy to go over the top at the end. */
  get turnsStill(): boolean {
    return this.#end.energy > 1
  }

  get driven(): boolean {
    return this.setup.drive !== 0
  }

  /** What a motion that is not driven comes to; once it is done. */
  outcome(): Outcome {
    this.#outcome ??= this.#found()
    return this.#outcome
  }

  #found(): Outcome {
    const { linear, quadratic, dry, torque } = this.setup
    const { reach } = this
    const last = this.rests.at(-1)
    if (last && last[1] === reach) {
      if (last[0] === 0) return { kind: 'still' }
      return { kind: 'stops', t: last[0], theta: this.#end.theta }
    }
    if (torque !== 0) return this.#underTorque()
    const first = (this.#pieces[0] as Start).energy
    if (first === 0) return { kind: 'still' }
    if (linear === 0 && quadratic === 0 && dry === 0) return { kind: 'exact' }
    if (this.#end.energy > first / 2) return { kind: 'keeps', part: this.#end.energy / first }
    // Friction only takes: the energy falls, and passes its half once. First between two starts of pieces, then within one.
    const next = this.#pieces.findIndex(({ energy }) => energy <= first / 2)
    const end = next < 0 ? this.#pieces.length : next
    let [before, after] = [(this.#pieces[end - 1] as Start).t, this.#pieces[end]?.t ?? reach]
    for (let i = 0; i < HALVINGS; i++) {
      const middle = (before + after) / 2
      if (this.energyAt(middle) > first / 2) before = middle
      else after = middle
    }
    return { kind: 'halves', t: after }
  }

  /** Under a constant torque it goes round and round, or hangs aside. */
  #underTorque(): Outcome {
    const { reach } = this
    const [middle, end] = [this.at(reach / 2), this.#end]
    const velocity = (end.theta - middle.theta) / (reach / 2)
    return Math.abs(end.theta - middle.theta) > 2 * Math.PI
      ? { kind: 'rotates', velocity }
      : { kind: 'settles', theta: end.theta - 2 * Math.PI * Math.round(end.theta / (2 * Math.PI)) }
  }
}

/** The angle with the whole turns before a piece. */
function absolute({ turns }: Start, theta: number): number {
  return turns === 0 ? theta : 2 * Math.PI * turns + theta
}
