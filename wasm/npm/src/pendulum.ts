/** The class `Pendulum`: one orbit of θ'' + ω₀² sin θ = 0, set up once, exact in every regime. Landau & Lifshitz §11. */

import { type Core, core, DomainError, first, keep, type Numbers, pair } from "./core.js";

/** The four kinds of motion. */
export type Regime = "rest" | "libration" | "separatrix" | "rotation";

const REGIMES: readonly Regime[] = ["rest", "libration", "separatrix", "rotation"];

/** The initial state of a pendulum and its force: at most one of `omega0`, `omega2` and `length`; none means omega0 = 1. */
export interface PendulumOptions {
  /** Initial angle in rad, finite. */
  theta0: number;
  /** Initial angular velocity in rad/s, finite; 0 if not given. */
  velocity0?: number | undefined;
  /** Angular frequency of small swings in rad/s, finite and not negative; 0 is free rotation. */
  omega0?: number | undefined;
  /** Its square in 1/s², finite and of any sign: below 0 the pendulum hangs from the other side. */
  omega2?: number | undefined;
  /** Length in m, finite and positive; then omega0² = gravity/length, taken exactly. */
  length?: number | undefined;
  /** Acceleration of gravity in m/s², finite and of any sign; only with `length`, where it means 9.80665 if not given. */
  gravity?: number | undefined;
}

/** Angle and angular velocity. */
export interface Motion<T> {
  /** Angle in rad, continuous through whole turns. */
  theta: T;
  /** Angular velocity in rad/s. */
  velocity: T;
}

/** Whole turns and the rest of the angle: θ = 2πn + angle. */
export interface Turns<T> {
  /** Whole turns. */
  n: T;
  /** The rest in rad, in [−π, π). */
  angle: T;
}

/** Energies per unit inertia in rad²/s². */
export interface Energies<T> {
  /** Of the velocity. */
  kinetic: T;
  /** Of the angle. */
  potential: T;
}

/** Lowest and highest angle in rad. */
export interface Extremes {
  /** Minus infinity in rotation. */
  lowest: number;
  /** Infinity in rotation. */
  highest: number;
}

/**
 * One orbit of the pendulum θ'' + ω₀² sin θ = 0, exact in every regime.
 *
 * The angle is zero at the bottom and counts on through whole turns. With the energy ratio
 * κ² = sin²(θ₀/2) + (θ̇₀/2ω₀)² the motion is a libration below 1, the separatrix at 1 and a rotation above. The regime is
 * that of the doubles passed: `theta0: Math.PI` swings, with a long period, because Math.PI is less than π. For omega2 < 0 the
 * bottom is the stable equilibrium θ = π: energy, energy ratio and thetaMax are those of theta0 − π with |omega2|.
 *
 * Error promised: angle, velocity and period within 4 ulp, plus what the condition of the problem makes of 2⁻¹⁰⁰. Near a
 * zero the ulp of the angle is that of 2⁻³⁰ of its largest. The tests hold the module to it on the vectors of the native core.
 *
 * Source: Landau & Lifshitz, Mechanics, §11; DLMF 22.19(i).
 *
 * @example
 * import { load, Pendulum } from "libration";
 * await load();
 * const pendulum = new Pendulum({ theta0: 3, length: 1, gravity: 9.8 });
 * console.log(pendulum.regime, pendulum.period.toFixed(8)); // libration 5.16069775
 * console.log(pendulum.theta(1).toFixed(9)); // 1.604458520
 */
export class Pendulum {
  /** Initial angle in rad. */
  readonly theta0: number;
  /** Initial angular velocity in rad/s. */
  readonly velocity0: number;
  /** Length in m, if it was given. */
  readonly length: number | undefined;
  /** Acceleration of gravity in m/s², if a length was given. */
  readonly gravity: number | undefined;
  /** Kind of motion, decided without error for the doubles passed. */
  readonly regime: Regime;
  /** Angular frequency of small swings in rad/s. Error: 1 ulp. */
  readonly omega0: number;
  /** Its square in 1/s², with its sign. Error: 1 ulp. */
  readonly omega2: number;
  /** Period in s: 2π/ω₀ at rest, infinite on the separatrix, the time of one turn in rotation. Error: 4 ulp. */
  readonly period: number;
  /** Turning angle in rad, counted from the stable equilibrium; π on the separatrix, NaN in rotation. Error: 4 ulp. */
  readonly thetaMax: number;
  /** Energy over the energy at the top, κ². Error: 4 ulp. Salas (23), where it is m. */
  readonly energyRatio: number;
  /** Its complement 1 − κ², computed directly: all its digits next to the separatrix too. Error: 4 ulp. */
  readonly energyRatioC: number;
  /** Energy per unit inertia in rad²/s², θ̇²/2 + ω₀²(1 − cos θ); zero at the stable equilibrium. Error: 4 ulp. */
  readonly energy: number;
  /** Lowest and highest angle, in the turn of the orbit. Error: 4 ulp. */
  readonly extremes: Extremes;
  /** @internal The number of the orbit in the first module. */
  readonly orbit: number;
  private readonly force: readonly [number, number, number, number, number];

  /**
   * Sets up an orbit.
   *
   * @param options Initial state and force.
   * @throws DomainError naming the argument, its value and what is allowed.
   */
  constructor(options: PendulumOptions) {
    const { theta0, velocity0 = 0, omega0, omega2, length, gravity } = options;
    const { exports } = core();
    const force = [omega0, omega2, length, gravity] as const;
    const given = force.reduce<number>((bits, value, at) => bits | (value === undefined ? 0 : 1 << at), 0);
    const [w, w2, l, g] = force.map((value) => value ?? 0) as [number, number, number, number];
    this.force = [w, w2, l, g, given];
    this.orbit = keep(this, exports.orbit_new(theta0, velocity0, ...this.force), exports.orbit_drop);
    this.theta0 = theta0;
    this.velocity0 = velocity0;
    this.regime = REGIMES[exports.orbit_facts(this.orbit)]!;
    const facts = core().column(0);
    this.omega0 = facts[0]!;
    this.omega2 = facts[1]!;
    this.period = facts[2]!;
    this.thetaMax = facts[3]!;
    this.energyRatio = facts[4]!;
    this.energyRatioC = facts[5]!;
    this.energy = facts[6]!;
    this.extremes = { lowest: facts[7]!, highest: facts[8]! };
    this.length = length;
    this.gravity = length === undefined ? undefined : (gravity ?? facts[9]!);
  }

  /**
   * Angle at times t, continuous through whole turns.
   *
   * In libration sin(θ/2) = k sn(ω₀t + u₀ | k²) with k = κ; in rotation θ/2 = am(κω₀t + u₀ | 1/κ²), with its sign and the turns
   * already made. A single time and an array of any length give the same digits.
   *
   * @param t Time in s. NaN gives NaN, and so does a time more than 2⁵³ half periods away.
   * @param out Where to put the angles of an array; it may be the array of the times.
   * @returns Angle in rad. Error: 4 ulp.
   *
   * @example
   * new Pendulum({ theta0: 3 }).theta([0, 5]); // Float64Array [ 3, -1.67599... ]
   */
  theta(t: number): number;
  theta(t: Numbers, out?: Float64Array): Float64Array;
  theta(t: number | Numbers, out?: Float64Array): number | Float64Array {
    const { exports } = core();
    return first(t, out, (rows) => exports.orbit_theta(this.orbit, rows));
  }

  /**
   * Angular velocity at times t.
   *
   * In libration 2κω₀ cn(ω₀t + u₀ | κ²), in rotation 2κω₀ dn(κω₀t + u₀ | 1/κ²), with its sign.
   *
   * @param t Time in s; outside as for `theta`.
   * @param out Where to put the velocities of an array.
   * @returns Angular velocity in rad/s. Error: 4 ulp, with the floor at 2⁻³⁰ of the largest.
   *
   * @example
   * new Pendulum({ theta0: 0, velocity0: 1 }).velocity(1); // 0.568569...
   */
  velocity(t: number): number;
  velocity(t: Numbers, out?: Float64Array): Float64Array;
  velocity(t: number | Numbers, out?: Float64Array): number | Float64Array {
    const { exports } = core();
    return first(t, out, (rows) => {
      exports.orbit_motion(this.orbit, rows);
      core().column(1).set(core().column(2).subarray(0, rows));
    });
  }

  /**
   * Angle and angular velocity at times t, together, in the digits of `theta` and `velocity`.
   *
   * @param t Time in s; outside as for `theta`.
   * @param out Where to put the results of an array.
   *
   * @example
   * const { theta, velocity } = new Pendulum({ theta0: 1 }).motion(2); // -0.306201..., -0.909046...
   */
  motion(t: number): Motion<number>;
  motion(t: Numbers, out?: Motion<Float64Array>): Motion<Float64Array>;
  motion(t: number | Numbers, out?: Motion<Float64Array>): Motion<number> | Motion<Float64Array> {
    const { exports } = core();
    const [theta, velocity] = pair(t, out && [out.theta, out.velocity], (rows) => exports.orbit_motion(this.orbit, rows));
    return { theta, velocity } as Motion<number> | Motion<Float64Array>;
  }

  /**
   * Whole turns and the rest of the angle at times t: θ = 2πn + angle with −π ≤ angle < π and the true π.
   *
   * After many turns the angle keeps the digits that θ itself has no room for.
   *
   * @param t Time in s. Where θ is NaN, and where the number of turns is beyond 2⁶³, n is 0 and the angle NaN.
   *
   * @example
   * const { n, angle } = new Pendulum({ theta0: 0, velocity0: 3 }).turns(10); // 4, 1.025388...
   */
  turns(t: number): Turns<number>;
  turns(t: Numbers): Turns<Float64Array>;
  turns(t: number | Numbers): Turns<number> | Turns<Float64Array> {
    const { exports } = core();
    const [n, angle] = pair(t, undefined, (rows) => exports.orbit_turns(this.orbit, rows));
    return { n, angle } as Turns<number> | Turns<Float64Array>;
  }

  /**
   * All times from start to stop, both included, at which the angle is theta; rising.
   *
   * In libration modulo 2π. In rotation and on the separatrix the angle is the unwrapped one, passed once at most. A turning
   * angle, also as `thetaMax` and `extremes` round it, is passed once a swing. Empty at rest.
   *
   * @param theta Angle in rad, finite.
   * @param start First time in s.
   * @param stop Last time in s.
   * @throws DomainError for NaN, start after stop, and more than ten million passages.
   *
   * @example
   * new Pendulum({ theta0: 1 }).times(0.5, 0, 7); // Float64Array [ 1.126844..., 5.573131... ]
   */
  times(theta: number, start: number, stop: number): Float64Array {
    return core().list(core().exports.orbit_times(this.orbit, theta, start, stop));
  }

  /**
   * All times from start to stop, both included, at which the pendulum turns back; none outside libration.
   *
   * @throws DomainError as `times`.
   *
   * @example
   * new Pendulum({ theta0: 1 }).turningTimes(0, 10); // Float64Array [ 0, 3.349988..., 6.699975... ]
   */
  turningTimes(start: number, stop: number): Float64Array {
    return core().list(core().exports.orbit_turning_times(this.orbit, start, stop));
  }

  /**
   * The first time from `after` on, that instant included, at which the angle is theta; NaN if there is none.
   *
   * @param theta Angle in rad, as for `times`.
   * @param after In s.
   *
   * @example
   * new Pendulum({ theta0: 1 }).nextCrossing(0.5, 2); // 5.573131...
   */
  nextCrossing(theta: number, after: number): number {
    return core().list(core().exports.orbit_next_time(this.orbit, theta, after))[0] ?? Number.NaN;
  }

  /**
   * Speed on the separatrix at an angle, 2ω₀|cos(θ/2)| about the stable equilibrium: the border between swings and turns.
   *
   * @param theta Angle in rad.
   * @returns Angular velocity in rad/s, not negative; the lower branch is its negative. Error: 2 ulp.
   *
   * @example
   * new Pendulum({ theta0: 1 }).separatrixVelocity([0, Math.PI / 2]); // Float64Array [ 2, 1.414213... ]
   */
  separatrixVelocity(theta: number): number;
  separatrixVelocity(theta: Numbers, out?: Float64Array): Float64Array;
  separatrixVelocity(theta: number | Numbers, out?: Float64Array): number | Float64Array {
    const { exports } = core();
    return first(theta, out, (rows) => exports.orbit_separatrix_velocity(this.orbit, rows));
  }

  /**
   * Kinetic and potential energy per unit inertia of a state in the force of this pendulum, in rad²/s²: θ̇²/2 and
   * ω₀²(1 − cos θ), zero at rest at the stable equilibrium. Also of states that are not its own, as of a numerical solution.
   *
   * @param state Angle in rad and velocity in rad/s: two numbers or two arrays of one length.
   * @param out Where to put the energies of arrays.
   * @returns Each within 1 ulp, of the state as it was given.
   *
   * @example
   * const pendulum = new Pendulum({ theta0: 1 });
   * const { kinetic, potential } = pendulum.energies(pendulum.motion(2));
   * kinetic + potential; // pendulum.energy, 0.459697...
   */
  energies(state: Motion<number>): Energies<number>;
  energies(state: Motion<Numbers>, out?: Energies<Float64Array>): Energies<Float64Array>;
  energies(
    { theta, velocity }: Motion<number | Numbers>,
    out?: Energies<Float64Array>,
  ): Energies<number> | Energies<Float64Array> {
    const { exports } = core();
    const work = (rows: number): void => exports.orbit_energies(this.orbit, rows);
    if (typeof theta === "number" || typeof velocity === "number") {
      const [kinetic, potential] = this.energiesOf([theta as number], [velocity as number], work);
      return { kinetic: kinetic[0]!, potential: potential[0]! };
    }
    if (theta.length !== velocity.length) {
      throw new DomainError("velocity", `${velocity.length} numbers`, `as many as theta, ${theta.length}`);
    }
    const results = out && ([out.kinetic, out.potential] as [Float64Array, Float64Array]);
    const [kinetic, potential] = this.energiesOf(theta, velocity, work, results);
    return { kinetic, potential };
  }

  /** @internal Asks the orbit in one of the modules. */
  within<T>(of: Core, question: (orbit: number) => T): T {
    if (of === core()) return question(this.orbit);
    const orbit = of.exports.orbit_new(this.theta0, this.velocity0, ...this.force);
    try {
      return question(orbit);
    } finally {
      of.exports.orbit_drop(orbit);
    }
  }

  private energiesOf(
    theta: Numbers,
    velocity: Numbers,
    work: (rows: number) => void,
    results: [Float64Array, Float64Array] = [new Float64Array(theta.length), new Float64Array(theta.length)],
  ): [Float64Array, Float64Array] {
    core().through(theta, results, work, velocity);
    return results;
  }

  /** The arguments it was made of, as text. */
  toString(): string {
    const { theta0, velocity0, length, gravity, omega2 } = this;
    const force = length === undefined ? `omega2: ${omega2}` : `length: ${length}, gravity: ${gravity}`;
    return `Pendulum { theta0: ${theta0}, velocity0: ${velocity0}, ${force} }`;
  }
}
