/** The springs u'' + p u + r u² + q u³ = c and u'' + p u + q u³ + s u⁵ = 0: exact from any start, in every regime. */

import { keep, type Numbers, pair } from "./core.js";
import { motions } from "./motions.js";

/** The seven kinds of motion of a spring. */
export type SpringRegime = "rest" | "linear" | "libration" | "well" | "homoclinic" | "heteroclinic" | "escape";

const REGIMES: readonly SpringRegime[] = ["rest", "linear", "libration", "well", "homoclinic", "heteroclinic", "escape"];

/** Displacement and velocity. */
export interface SpringMotion<T> {
  /** Displacement. */
  u: T;
  /** Velocity. */
  velocity: T;
}

/** What a spring of either kind answers. */
abstract class Spring {
  /** Kind of motion, decided without error for the doubles passed. */
  readonly regime: SpringRegime;
  /** Period of a libration, of a well and of a harmonic oscillator; at rest that of small oscillations; else infinite. Error: 4 ulp. */
  readonly period: number;
  /** Lowest and highest u over the whole motion; infinite where it escapes. Error: 4 ulp. */
  readonly range: readonly [lowest: number, highest: number];
  /** Energy u'²/2 + V(u). */
  readonly energy: number;
  /** When u becomes infinite: above 0, or infinite if it never does. Error: 1e-14 of it. */
  readonly escapeTime: number;
  /** When u came from infinity: below 0, or minus infinity if it never did. Error: 1e-14 of it. */
  readonly escapeTimeBackward: number;
  /** Displacement at t = 0. */
  readonly u0: number;
  /** Velocity at t = 0. */
  readonly velocity0: number;
  private readonly spring: number;

  /** @internal */
  constructor(made: number, u0: number, velocity0: number) {
    const of = motions();
    const { exports } = of;
    this.spring = keep(this, made, exports.spring_drop, of);
    this.regime = REGIMES[exports.spring_facts(this.spring)]!;
    const facts = of.column(0);
    this.period = facts[0]!;
    this.range = [facts[1]!, facts[2]!];
    this.energy = facts[3]!;
    this.escapeTime = facts[4]!;
    this.escapeTimeBackward = facts[5]!;
    this.u0 = u0;
    this.velocity0 = velocity0;
  }

  /**
   * Displacement and velocity at times t.
   *
   * @param t Time; NaN at and beyond an escape, and more than 2⁵³ half periods away.
   * @param out Where to put the results of an array.
   * @returns Each within 4 ulp of its largest in a bounded motion, else of max(|u|, |u0|).
   */
  motion(t: number): SpringMotion<number>;
  motion(t: Numbers, out?: SpringMotion<Float64Array>): SpringMotion<Float64Array>;
  motion(t: number | Numbers, out?: SpringMotion<Float64Array>): SpringMotion<number> | SpringMotion<Float64Array> {
    const of = motions();
    const work = (rows: number): void => of.exports.spring_motion(this.spring, rows);
    const [u, velocity] = pair(t, out && [out.u, out.velocity], work, of);
    return { u, velocity } as SpringMotion<number> | SpringMotion<Float64Array>;
  }
}

/** The start and the force of a Duffing oscillator. */
export interface DuffingOptions {
  /** Displacement at t = 0, finite. */
  u0: number;
  /** Velocity at t = 0, finite; 0 if not given. */
  velocity0?: number | undefined;
  /** Coefficient of u, finite, of any sign. */
  p: number;
  /** Coefficient of u³, finite, of any sign. */
  q: number;
  /** Coefficient of u², finite, of any sign; 0 if not given. */
  r?: number | undefined;
  /** Constant force, finite, of any sign; 0 if not given. */
  c?: number | undefined;
}

/**
 * One orbit of u'' + p u + r u² + q u³ = c.
 *
 * With r or c the regime does not ask about u = 0: a libration has one well around it, a well is one of two.
 *
 * Source: Salas 2019 (5); DLMF 22.13(iii); with r and c u'² is a quartic, DLMF 22, 23.
 *
 * @example
 * const spring = new Duffing({ u0: 1.2, p: 1, q: -1 });
 * console.log(spring.regime, spring.escapeTime.toFixed(6)); // escape 1.851457
 * console.log(new Duffing({ u0: 1, p: 1, q: 0.2, r: 0.5 }).range[0].toFixed(9)); // -1.401980262
 */
export class Duffing extends Spring {
  /** Coefficient of u. */
  readonly p: number;
  /** Coefficient of u³. */
  readonly q: number;
  /** Coefficient of u². */
  readonly r: number;
  /** Constant force. */
  readonly c: number;

  /**
   * Sets up an orbit.
   *
   * @param options Start and force.
   * @throws DomainError naming the argument, its value and what is allowed.
   */
  constructor({ u0, velocity0 = 0, p, q, r = 0, c = 0 }: DuffingOptions) {
    super(motions().exports.duffing_new(u0, velocity0, p, q, r, c), u0, velocity0);
    this.p = p;
    this.q = q;
    this.r = r;
    this.c = c;
  }

  /**
   * The oscillator of u = tan(θ/2) for a pendulum: a libration is a hardening spring, a rotation escapes at the top.
   *
   * Source: Salas 2019 (5), (8).
   *
   * @param pendulum Start in rad and rad/s, length in m, gravity in m/s².
   * @throws DomainError naming what is not finite.
   *
   * @example
   * Duffing.ofPendulum({ theta0: 1, length: 1, gravity: 1 }).p; // 0.540302...
   */
  static ofPendulum(pendulum: { theta0: number; velocity0?: number; length: number; gravity: number }): Duffing {
    const { theta0, velocity0 = 0, length, gravity } = pendulum;
    const of = motions();
    if (of.exports.duffing_of_pendulum(theta0, velocity0, length, gravity) === 0) throw of.refusal();
    const [u0, start, p, q] = of.column(0) as unknown as [number, number, number, number];
    return new Duffing({ u0, velocity0: start, p, q });
  }
}

/** The start and the force of a cubic–quintic oscillator. */
export interface CubicQuinticOptions {
  /** Displacement at t = 0, finite. */
  u0: number;
  /** Velocity at t = 0, finite; 0 if not given. */
  velocity0?: number | undefined;
  /** Coefficient of u, finite, of any sign. */
  p: number;
  /** Coefficient of u³, finite, of any sign. */
  q: number;
  /** Coefficient of u⁵, finite, of any sign. */
  s: number;
}

/**
 * One orbit of u'' + p u + q u³ + s u⁵ = 0.
 *
 * @example
 * const spring = new CubicQuintic({ u0: 1, p: 1, q: 1, s: 1 });
 * console.log(spring.period.toFixed(9)); // 4.123945209
 */
export class CubicQuintic extends Spring {
  /** Coefficient of u. */
  readonly p: number;
  /** Coefficient of u³. */
  readonly q: number;
  /** Coefficient of u⁵. */
  readonly s: number;

  /**
   * Sets up an orbit.
   *
   * @param options Start and force.
   * @throws DomainError naming the argument, its value and what is allowed.
   */
  constructor({ u0, velocity0 = 0, p, q, s }: CubicQuinticOptions) {
    super(motions().exports.cubic_quintic_new(u0, velocity0, p, q, s), u0, velocity0);
    this.p = p;
    this.q = q;
    this.s = s;
  }
}
