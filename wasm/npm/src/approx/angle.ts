/** Approximations of the angle over time by name, each set up once for a pendulum: `linear`, `fourier:4`, `taylor:8` ... */

import { type Core, core, coreOf, coreWith, first, keep, type Numbers } from "../core.js";
import type { Pendulum } from "../pendulum.js";
import { type Entry, entryOf, type Interval, intervals, type Registry, registry } from "./registry.js";

/** The largest error of an approximation over some periods. */
export interface AngleError {
  /** Largest size of approximate minus exact in rad; infinite where the approximation escapes to infinity. */
  difference: number;
  /** The same over the turning angle; NaN in rotation, which has none. */
  relative: number;
  /** The first time at which it is as large, in s. */
  t: number;
  /** The first time at which the approximation has no value, in s; NaN if it always has one. */
  undefinedFrom: number;
}

/** A formula for the angle over time; from `approx.angle(name)`. */
export class AngleFormula {
  /** Its name, with N where it takes one. */
  readonly name: string;
  /** What is known of it. */
  readonly entry: Entry;

  /** @throws DomainError naming the nearest names, or what N may be. */
  constructor(name: string) {
    core().say(name);
    if (core().exports.angle_named() === 0) throw core().refusal();
    this.name = name;
    this.entry = entryOf(angle.entries, name);
  }

  /**
   * The formula for one pendulum.
   *
   * A formula for a release from rest runs on the exact phase, from the last turning point on. `harmonic`, `fourier:N`,
   * `trigonometric` and `small-m-bounded` are for librations, `fourier-theta:N` for librations and rotations, the others for
   * every motion. All but `harmonic`, both series and `taylor:N` swing about θ = 0 and need omega2 >= 0.
   *
   * @throws DomainError where the formula is not written for this motion; its message says why.
   *
   * @example
   * approx.angle("trigonometric").of(new Pendulum({ theta0: 1.5 })).theta(2); // -0.238115...
   */
  of(pendulum: Pendulum): AngleApproximation {
    return new AngleApproximation(this, pendulum);
  }

  /**
   * The turning angles for which the largest error of a release from rest stays within a share of them. Where it has no
   * value counts as beyond.
   *
   * @param bound Largest error over the turning angle, above 0.
   * @param periods For so many exact periods, above 0 and at most 10,000.
   * @throws DomainError for a bound or a number of periods out of range.
   *
   * @example
   * approx.angle("harmonic").ranges(0.01); // [[0, 1.0770...]], up to 61.71 degrees
   */
  ranges(bound: number, periods = 1): Interval[] {
    const of = coreWith("angle_ranges", "ranges");
    of.say(this.name);
    return intervals(of.list(of.exports.angle_ranges(bound, periods)));
  }
}

/** A formula for the angle set up for one pendulum; from `AngleFormula.of`. */
export class AngleApproximation {
  /** The formula. */
  readonly formula: AngleFormula;
  /** The motion that it approximates. */
  readonly pendulum: Pendulum;
  /** Period in s of the approximation itself; NaN where it does not repeat. */
  readonly period: number;
  private readonly approximation: number;
  private readonly core: Core;

  /** @throws DomainError where the formula is not written for this motion; Error for one of the second module before it. */
  constructor(formula: AngleFormula, pendulum: Pendulum) {
    this.core = coreOf(formula.entry.name);
    const { exports } = this.core;
    this.core.say(formula.name);
    const made = pendulum.within(this.core, (orbit) => exports.angle_new(orbit));
    this.approximation = keep(this, made, exports.angle_drop, this.core);
    this.formula = formula;
    this.pendulum = pendulum;
    this.period = exports.angle_period(this.approximation);
  }

  /**
   * Approximate angle at times t.
   *
   * @param t Time in s.
   * @param out Where to put the angles of an array.
   * @returns Angle in rad; NaN where the formula has no value: `formula.entry.undefinedWhere` says where,
   *   `error().undefinedFrom` since when.
   *
   * @example
   * approx.angle("fourier:2").of(new Pendulum({ theta0: 1 })).theta(2); // -0.305938...
   */
  theta(t: number): number;
  theta(t: Numbers, out?: Float64Array): Float64Array;
  theta(t: number | Numbers, out?: Float64Array): number | Float64Array {
    const { exports } = this.core;
    return first(t, out, (rows) => exports.angle_theta(this.approximation, rows), this.core);
  }

  /**
   * Approximate minus exact angle at times t.
   *
   * For `harmonic` and both Fourier series it is formed from the terms they leave out: 1e-10 of itself, however small.
   *
   * @param t Time in s.
   * @param out Where to put the differences of an array.
   * @returns Difference in rad, NaN where `theta` is.
   *
   * @example
   * approx.angle("fourier:2").of(new Pendulum({ theta0: 1 })).difference(2); // 2.61...e-4
   */
  difference(t: number): number;
  difference(t: Numbers, out?: Float64Array): Float64Array;
  difference(t: number | Numbers, out?: Float64Array): number | Float64Array {
    const { exports } = this.core;
    return first(t, out, (rows) => exports.angle_difference(this.approximation, rows), this.core);
  }

  /**
   * The largest error from t = 0 on: Lima's figures are `100 * error().relative`.
   *
   * @param periods For so many exact periods (turns of a rotation), above 0 and at most 10,000.
   * @throws DomainError for a number out of range; on the separatrix, which has no period.
   *
   * @example
   * approx.angle("fourier:2").of(new Pendulum({ theta0: 1 })).error().relative; // 2.86...e-4
   */
  error(periods = 1): AngleError {
    if (this.core.exports.angle_largest_error(this.approximation, periods) === 0) throw this.core.refusal();
    const facts = this.core.column(0);
    const [difference, t, undefinedFrom] = [facts[0]!, facts[1]!, facts[2]!];
    const { thetaMax } = this.pendulum;
    return { difference, relative: thetaMax === 0 ? 0 : difference / thetaMax, t, undefinedFrom };
  }
}

/**
 * The approximations of the angle by name.
 *
 * @example
 * angle.names; // ["linear", "harmonic", "fourier:N", ...]
 * angle("fourier:4").entry.source; // "Lima 2019 (20)-(22)"
 */
export const angle: Registry<AngleFormula> = registry("angle", (name) => new AngleFormula(name));
