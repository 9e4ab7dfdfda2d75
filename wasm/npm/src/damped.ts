/** The pendulum with friction and torque: θ'' + 2γθ' + β|θ'|θ' + μ z + ω₀² sin θ = τ(t), integrated by Taylor series. */

import { first, keep, type Numbers, pair, release } from "./core.js";
import { motions } from "./motions.js";
import type { Motion, PendulumOptions, Turns } from "./pendulum.js";

/** Friction per unit inertia; what is not given is 0. */
export interface FrictionOptions {
  /** γ in 1/s, of the term 2γθ'. Below 0 it drives the motion. */
  linear?: number | undefined;
  /** β in 1/rad, of the term β|θ'|θ'. Below 0 it drives the motion. */
  quadratic?: number | undefined;
  /** μ in rad/s², not negative. */
  dry?: number | undefined;
  /** Angle in rad over which dry friction changes its sign after a turn, 0 or from 1e-10 on. */
  presliding?: number | undefined;
}

/** Torque per unit inertia, constant + amplitude cos(frequency t + phase); what is not given is 0. */
export interface TorqueOptions {
  /** In rad/s². */
  constant?: number | undefined;
  /** In rad/s². */
  amplitude?: number | undefined;
  /** In rad/s. */
  frequency?: number | undefined;
  /** In rad. */
  phase?: number | undefined;
}

/** A pendulum, its friction and the torque that drives it. */
export interface DampedOptions extends PendulumOptions {
  /** Friction; none if not given. */
  friction?: FrictionOptions | undefined;
  /** Torque; none if not given. */
  torque?: TorqueOptions | undefined;
}

/**
 * The motion of a pendulum with friction and torque, from t = 0 as far as it is asked for.
 *
 * Without friction and torque it is the exact motion of `Pendulum`. Error promised: angle and velocity within 2 ulp of the largest up to
 * the time, plus 2⁻⁵⁷ of the condition. Where a motion takes more than a million steps, or grows without bound, it ends: later
 * times give NaN.
 *
 * @example
 * const friction = { linear: 0.01, quadratic: 0.02, dry: 0.003 };
 * const pendulum = new DampedPendulum({ theta0: 2, omega0: 3, friction });
 * console.log(pendulum.motion(10).theta.toFixed(9)); // 1.094168838
 */
export class DampedPendulum {
  /** 0 once it is given back: no object. */
  private damped: number;

  /**
   * Sets up a motion; nothing is integrated yet.
   *
   * @param options Start, force, friction and torque.
   * @throws DomainError naming the argument, its value and what is allowed.
   */
  constructor(options: DampedOptions) {
    const { theta0, velocity0 = 0, omega0, omega2, length, gravity, friction = {}, torque = {} } = options;
    const { linear = 0, quadratic = 0, dry = 0, presliding = 0 } = friction;
    const { constant = 0, amplitude = 0, frequency = 0, phase = 0 } = torque;
    const force = [omega0, omega2, length, gravity] as const;
    const given = force.reduce<number>((bits, value, at) => bits | (value === undefined ? 0 : 1 << at), 0);
    const [w, w2, l, g] = force.map((value) => value ?? 0) as [number, number, number, number];
    const of = motions();
    // One line for each kind of argument.
    const made = of.exports.damped_new(
      ...[theta0, velocity0, w, w2, l, g, given] as const,
      ...[linear, quadratic, dry, presliding] as const,
      ...[constant, amplitude, frequency, phase] as const,
    );
    this.damped = keep(this, made, of.exports.damped_drop, of);
  }

  /**
   * Gives back the memory of the motion, which grows with its length; it answers no more. What is forgotten gives it back too, but at a
   * time of the engine's choice.
   */
  free(): void {
    release(this, this.damped, motions().exports.damped_drop);
    this.damped = 0;
  }

  /** How far the motion goes that is asked for until a time: to it, or to where it ends. */
  reach(until: number): number {
    return motions().exports.damped_reach(this.damped, until);
  }

  /**
   * Angle and angular velocity at times t, continuous through whole turns.
   *
   * @param t Time in s; before 0 too, but with presliding.
   * @param out Where to put the results of an array.
   */
  motion(t: number): Motion<number>;
  motion(t: Numbers, out?: Motion<Float64Array>): Motion<Float64Array>;
  motion(t: number | Numbers, out?: Motion<Float64Array>): Motion<number> | Motion<Float64Array> {
    const of = motions();
    const work = (rows: number): void => of.exports.damped_motion(this.damped, rows);
    const [theta, velocity] = pair(t, out && [out.theta, out.velocity], work, of);
    return { theta, velocity } as Motion<number> | Motion<Float64Array>;
  }

  /** Energy per unit inertia at times t in rad²/s²: 0 at rest at the stable equilibrium. */
  energy(t: number): number;
  energy(t: Numbers, out?: Float64Array): Float64Array;
  energy(t: number | Numbers, out?: Float64Array): number | Float64Array {
    const of = motions();
    return first(t, out, (rows) => of.exports.damped_energy(this.damped, rows), of);
  }

  /** Whole turns, and the angle left in [−π, π). */
  turns(t: number): Turns<number>;
  turns(t: Numbers): Turns<Float64Array>;
  turns(t: number | Numbers): Turns<number> | Turns<Float64Array> {
    const of = motions();
    const [n, angle] = pair(t, undefined, (rows) => of.exports.damped_turns(this.damped, rows), of);
    return { n, angle } as Turns<number> | Turns<Float64Array>;
  }

  /**
   * All times from start to stop, both included, at which the velocity changes its sign; 0 where it starts from rest.
   *
   * @throws DomainError where the motion does not reach them.
   */
  turningTimes(start: number, stop: number): Float64Array {
    const of = motions();
    return of.list(of.exports.damped_turning_times(this.damped, start, stop));
  }

  /**
   * The intervals between two times over which dry friction holds the pendulum.
   *
   * @throws DomainError where the motion does not reach them.
   */
  rests(start: number, stop: number): [from: number, to: number][] {
    const of = motions();
    const ends = of.list(of.exports.damped_rests(this.damped, start, stop));
    return Array.from({ length: ends.length / 2 }, (_, i) => [ends[2 * i]!, ends[2 * i + 1]!]);
  }

  /**
   * The turning angle at times t by the law of the mean loss of energy, from a turning angle at t = 0: what an envelope is, to first
   * order of the friction. NaN where the pendulum turns over, and beside a torque it means nothing.
   *
   * @param thetaMax Turning angle at t = 0 in rad, in [0, π).
   * @param t Time in s.
   */
  averagedTurningAngle(thetaMax: number, t: Numbers, out?: Float64Array): Float64Array {
    const of = motions();
    const work = (rows: number): void => of.exports.damped_averaged(this.damped, thetaMax, rows);
    return first(t, out, work, of) as Float64Array;
  }
}
