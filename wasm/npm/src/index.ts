/**
 * libration: the exact nonlinear pendulum and the elliptic functions it needs, right to the last digits.
 *
 * Call `await load()` once; everything else answers at once. Angles in rad, everything else in SI units. A number gives
 * a number, an array a Float64Array. Wrong arguments throw a DomainError that names argument, value and what is allowed.
 *
 * @packageDocumentation
 *
 * @example
 * import { load, Pendulum } from "libration";
 * await load();
 * console.log(new Pendulum({ theta0: 3 }).theta(5)); // -1.67599...
 */

export * as approx from "./approx/index.js";
export { DomainError, hasVectors, load, loadSecond, type Numbers, type Source, type Sources, usesVectors, version } from "./core.js";
export { DampedPendulum, type DampedOptions, type FrictionOptions, type TorqueOptions } from "./damped.js";
export * as elliptic from "./elliptic.js";
export { loadMotions } from "./motions.js";
export { type Energies, type Extremes, type Motion, Pendulum, type PendulumOptions, type Regime, type Turns } from "./pendulum.js";
export { CubicQuintic, type CubicQuinticOptions, Duffing, type DuffingOptions, type SpringMotion, type SpringRegime } from "./springs.js";
