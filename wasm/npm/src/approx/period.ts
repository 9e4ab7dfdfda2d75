/** Formulas for the period of a swing by name: from Bernoulli's two terms to the arithmetic-geometric mean. */

import { type Core, coreWith, DomainError, first, type Numbers } from "../core.js";
import type { Pendulum } from "../pendulum.js";
import { type Entry, entryOf, type Interval, intervals, type Registry, registry } from "./registry.js";

/** A swing by its turning angle in rad, its parameter m = sin²(thetaMax/2), or the complement mc = 1 − m. */
export type Swing<T = number> =
  | { thetaMax: T; m?: never; mc?: never }
  | { thetaMax?: never; m: T; mc?: never }
  | { thetaMax?: never; m?: never; mc: T };

const NAMES = ["thetaMax", "m", "mc"] as const;

/** A formula for the period of a swing; from `approx.period(name)`. */
export class PeriodFormula {
  /** Its name, with N where it takes one. */
  readonly name: string;
  /** What is known of it. */
  readonly entry: Entry;
  private readonly core: Core;

  /** @throws DomainError naming the nearest names, or what N may be; Error before the second module is loaded. */
  constructor(name: string) {
    this.core = coreWith("period_values", "approx.period");
    this.core.say(name);
    if (this.core.exports.period_values(0, 0) === 0) throw this.core.refusal();
    this.name = name;
    this.entry = entryOf(period.entries, name);
  }

  /**
   * Period over the period of small swings, for a release from rest.
   *
   * @param swing `{thetaMax}` in [0, π], or `{m}` or `{mc}`, a number or an array.
   * @returns T/T₀ within 1 ulp; NaN where the formula has no value.
   *
   * @example
   * approx.period("agm:2").ratio({ thetaMax: 1.5 }); // 1.161957...
   */
  ratio(swing: Swing): number;
  ratio(swing: Swing<Numbers>): Float64Array;
  ratio(swing: Swing<number | Numbers>): number | Float64Array {
    return this.values(swing, 1);
  }

  /**
   * The formula over the exact ratio 2K/π, minus 1.
   *
   * @param swing As for `ratio`.
   * @returns The relative error, right to its own last digits; −1 where only the exact one is infinite.
   *
   * @example
   * approx.period("agm:2").error({ thetaMax: 1.5 }); // -9.23...e-6
   */
  error(swing: Swing): number;
  error(swing: Swing<Numbers>): Float64Array;
  error(swing: Swing<number | Numbers>): number | Float64Array {
    return this.values(swing, 2);
  }

  /**
   * The period that the formula gives a pendulum, in s; NaN in rotation. Error: 4 ulp.
   *
   * @example
   * approx.period("bernoulli").period(new Pendulum({ theta0: 1, length: 1, gravity: 9.8 })); // 2.132536...
   */
  period(pendulum: Pendulum): number {
    this.core.say(this.name);
    return pendulum.within(this.core, (orbit) => this.core.exports.period_of(orbit));
  }

  /**
   * The turning angles in [0, π] for which the error stays within a bound, to the last double.
   *
   * @param bound At least 1e-30, finite.
   * @throws DomainError for another bound.
   *
   * @example
   * approx.period("cromer").ranges(1e-3); // [[2.98..., 3.14...]]
   */
  ranges(bound: number): Interval[] {
    this.core.say(this.name);
    return intervals(this.core.list(this.core.exports.period_ranges(bound)));
  }

  private values(swing: Swing<number | Numbers>, column: number): number | Float64Array {
    const found = NAMES.flatMap((name, at) => (swing[name] === undefined ? [] : [{ at, value: swing[name] }]));
    const [only] = found;
    if (found.length !== 1 || !only) {
      const names = found.map(({ at }) => NAMES[at]).join(", ");
      throw new DomainError("swing", names || "none", "given as one of thetaMax, m and mc");
    }
    const of = this.core;
    const work = (rows: number): void => {
      of.say(this.name);
      of.exports.period_values(only.at, rows);
      if (column > 1) of.column(1).set(of.column(column).subarray(0, rows));
    };
    return first(only.value, undefined, work, of);
  }
}

/**
 * The formulas of the period by name, `exact` among them.
 *
 * @example
 * period.entries.map((entry) => [entry.pattern, entry.source]);
 * period("lima-arun").ratio({ thetaMax: Math.PI / 2 }); // 1.183283...
 */
export const period: Registry<PeriodFormula> = registry("period", (name) => new PeriodFormula(name));
