/**
 * Numerical solutions by name: what a first program, or SciPy as it comes, makes of a pendulum.
 *
 * `euler:H`, `euler-cromer:H`, `verlet:H` and `rk4:H` take steps of H s; `rk45` is scipy.integrate.solve_ivp at its
 * defaults, rtol = 1e-3 and atol = 1e-6, step by step.
 */

import { core, DomainError, first, keep, type Numbers, pair } from "../core.js";
import type { Motion, Pendulum } from "../pendulum.js";
import { type Entry, entryOf, type Registry, registry } from "./registry.js";

/** The ends of all steps, the start first. */
export interface NumericalSteps {
  /** Times in s. */
  t: Float64Array;
  /** Angles in rad. */
  theta: Float64Array;
  /** Angular velocities in rad/s. */
  velocity: Float64Array;
}

/** A numerical scheme; from `approx.numerical(name)`. */
export class NumericalFormula {
  /** Its name with its step: `rk4:0.025`, `rk45`. */
  readonly name: string;
  /** What is known of it. */
  readonly entry: Entry;
  /** The step in s; NaN where the scheme chooses its own. */
  readonly step: number;

  /** @throws DomainError naming the nearest names, or what the step may be. */
  constructor(name: string) {
    const [scheme = "", step] = name.split(":");
    this.step = step === undefined ? Number.NaN : Number(step);
    if (step !== undefined && (step.trim() === "" || Number.isNaN(this.step))) {
      throw new DomainError("step", JSON.stringify(step), "a number in s, as in rk4:0.025");
    }
    core().say(scheme);
    if (core().exports.numerical_named(this.step) === 0) throw core().refusal();
    this.name = name;
    this.entry = entryOf(numerical.entries, scheme);
  }

  /**
   * The solution for one pendulum from t = 0 on.
   *
   * @param pendulum The motion to solve for.
   * @param until The end in s, finite and not negative. As in SciPy the last step of `rk45` ends there.
   * @throws DomainError for another end, and for more than five million steps.
   *
   * @example
   * const horsley = new Pendulum({ theta0: 3, length: 1, gravity: 9.8 });
   * approx.numerical("rk45").of(horsley, 10).overTheTop; // 9.47...: the exact motion never goes over the top
   */
  of(pendulum: Pendulum, until: number): NumericalSolution {
    return new NumericalSolution(this, pendulum, until);
  }
}

/** What a scheme makes of one pendulum from 0 to an end; from `NumericalFormula.of`. */
export class NumericalSolution {
  /** The scheme. */
  readonly formula: NumericalFormula;
  /** The motion that it solves for. */
  readonly pendulum: Pendulum;
  /** The end in s. */
  readonly until: number;
  /**
   * When a swing is carried over the top, in s: the first time at which the angle is more than π from the middle of the
   * exact motion. NaN where it is not, and in rotation.
   */
  readonly overTheTop: number;
  private readonly solution: number;

  /** @throws DomainError as `NumericalFormula.of`. */
  constructor(formula: NumericalFormula, pendulum: Pendulum, until: number) {
    const { exports } = core();
    core().say(formula.entry.name);
    const number = exports.numerical_new(pendulum.orbit, formula.step, until);
    this.solution = keep(this, number, exports.numerical_drop);
    this.formula = formula;
    this.pendulum = pendulum;
    this.until = until;
    this.overTheTop = exports.numerical_over_the_top(number);
  }

  /**
   * Angle at times t; between fixed steps the cubic through both states, in a step of `rk45` its own interpolant.
   *
   * @param t Time in s; NaN outside of [0, until].
   * @param out Where to put the angles of an array.
   */
  theta(t: number): number;
  theta(t: Numbers, out?: Float64Array): Float64Array;
  theta(t: number | Numbers, out?: Float64Array): number | Float64Array {
    return first(t, out, (rows) => core().exports.numerical_motion(this.solution, rows));
  }

  /**
   * Angle and velocity at times t.
   *
   * @param t Time in s; NaN outside of [0, until].
   * @param out Where to put the results of an array.
   */
  motion(t: number): Motion<number>;
  motion(t: Numbers, out?: Motion<Float64Array>): Motion<Float64Array>;
  motion(t: number | Numbers, out?: Motion<Float64Array>): Motion<number> | Motion<Float64Array> {
    const work = (rows: number): void => core().exports.numerical_motion(this.solution, rows);
    const [theta, velocity] = pair(t, out && [out.theta, out.velocity], work);
    return { theta, velocity } as Motion<number> | Motion<Float64Array>;
  }

  /** The ends of all steps, the start first. */
  steps(): NumericalSteps {
    const ends = core().list(core().exports.numerical_steps(this.solution));
    const part = (at: number): Float64Array => Float64Array.from({ length: ends.length / 3 }, (_, i) => ends[3 * i + at]!);
    return { t: part(0), theta: part(1), velocity: part(2) };
  }
}

/**
 * The numerical schemes by name.
 *
 * @example
 * numerical.names; // ["euler:H", "euler-cromer:H", "verlet:H", "rk4:H", "rk45"]
 */
export const numerical: Registry<NumericalFormula> = registry("numerical", (name) => new NumericalFormula(name));
