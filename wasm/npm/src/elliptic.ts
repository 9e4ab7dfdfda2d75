/**
 * Jacobi's elliptic functions and the complete integrals, of exactly one of `{m}`, `{mc}` and `{k}`. DLMF 19, 22.
 *
 * m = k² is the parameter, mc = 1 − m its complement, which keeps its digits where m is next to 1, and k the modulus. No
 * * function takes a bare number for it, so k cannot be passed for m. All are in the second module: `await loadSecond()` first.
 */

import { coreWith, DomainError, first, type Numbers } from "./core.js";

/** Exactly one of the parameter m, its complement mc = 1 − m, and the modulus k. */
export type Parameter<T = number> =
  | { m: T; mc?: never; k?: never }
  | { m?: never; mc: T; k?: never }
  | { m?: never; mc?: never; k: T };

/** sn, cn, dn and am at one argument, or at each of many. */
export interface JacobiValues<T> {
  /** sn(u | m) */
  sn: T;
  /** cn(u | m) */
  cn: T;
  /** dn(u | m) */
  dn: T;
  /** The amplitude am(u | m), not wrapped, in rad. */
  am: T;
}

const NAMES = ["m", "mc", "k"] as const;

/** Which of the three is given, and its value. */
function given<T>(parameter: Parameter<T>): [number, T] {
  const found = NAMES.flatMap((name, at) => {
    const value = parameter[name] as T | undefined;
    return value === undefined ? [] : [[at, value] as [number, T]];
  });
  if (found.length !== 1) {
    const names = found.map(([at, value]) => `${NAMES[at]} = ${String(value)}`).join(", ");
    throw new DomainError("parameter", names || "none", "given as one of m, mc and k");
  }
  return found[0]!;
}

function values(u: number, parameter: Parameter): JacobiValues<number>;
function values(u: Numbers, parameter: Parameter): JacobiValues<Float64Array>;
function values(u: number | Numbers, parameter: Parameter): JacobiValues<number> | JacobiValues<Float64Array> {
  const [which, value] = given(parameter);
  const of = coreWith("jacobi", "elliptic");
  const work = (rows: number): void => of.exports.jacobi(which, value, rows);
  if (typeof u === "number") {
    of.once(u, work);
    const [sn, cn, dn, am] = [1, 2, 3, 4].map((at) => of.column(at)[0]!) as [number, number, number, number];
    return { sn, cn, dn, am };
  }
  const make = (): Float64Array => new Float64Array(u.length);
  const [sn, cn, dn, am] = [make(), make(), make(), make()];
  of.through(u, [sn, cn, dn, am], work);
  return { sn, cn, dn, am };
}

/**
 * sn, cn, dn and am together.
 *
 * @param u Argument: a number or an array.
 * @param parameter One of `{m}`, `{mc}`, `{k}`; any real m.
 * @returns Each within 3 ulp, plus 2⁻¹⁰⁰ of its condition in u. NaN for infinite u, but for the limits at m = 1.
 *
 * @example
 * jacobi(1, { m: 0.5 }).sn; // 0.803001824896...
 */
export function jacobi(u: number, parameter: Parameter): JacobiValues<number>;
export function jacobi(u: Numbers, parameter: Parameter): JacobiValues<Float64Array>;
export function jacobi(u: number | Numbers, parameter: Parameter): JacobiValues<number> | JacobiValues<Float64Array> {
  return values(u as number, parameter);
}

/**
 * sn(u | m), DLMF 22.2.4; error as `jacobi`.
 *
 * @example
 * sn(1, { k: Math.SQRT1_2 }); // 0.803001824896...
 */
export function sn(u: number, parameter: Parameter): number;
export function sn(u: Numbers, parameter: Parameter): Float64Array;
export function sn(u: number | Numbers, parameter: Parameter): number | Float64Array {
  return values(u as number, parameter).sn;
}

/**
 * cn(u | m), DLMF 22.2.5; error as `jacobi`.
 *
 * @example
 * cn(1, { m: 0.5 }); // 0.595976567672...
 */
export function cn(u: number, parameter: Parameter): number;
export function cn(u: Numbers, parameter: Parameter): Float64Array;
export function cn(u: number | Numbers, parameter: Parameter): number | Float64Array {
  return values(u as number, parameter).cn;
}

/**
 * dn(u | m), DLMF 22.2.6; error as `jacobi`.
 *
 * @example
 * dn(1, { m: 0.5 }); // 0.823161001631...
 */
export function dn(u: number, parameter: Parameter): number;
export function dn(u: Numbers, parameter: Parameter): Float64Array;
export function dn(u: number | Numbers, parameter: Parameter): number | Float64Array {
  return values(u as number, parameter).dn;
}

/**
 * The amplitude am(u | m) = ∫₀ᵘ dn, not wrapped, in rad: DLMF 22.16.1; error as `jacobi`.
 *
 * @example
 * am(1, { m: 0.5 }); // 0.932315079883...
 */
export function am(u: number, parameter: Parameter): number;
export function am(u: Numbers, parameter: Parameter): Float64Array;
export function am(u: number | Numbers, parameter: Parameter): number | Float64Array {
  return values(u as number, parameter).am;
}

/** One of the columns that the core fills for parameters. */
function complete(parameter: Parameter<number | Numbers>, column: number): number | Float64Array {
  const [which, value] = given(parameter);
  const of = coreWith("complete", "elliptic");
  const work = (rows: number): void => {
    of.exports.complete(which, rows);
    if (column > 1) of.column(1).set(of.column(column).subarray(0, rows));
  };
  return first(value, undefined, work, of);
}

/**
 * Complete integral of the first kind K(m), the quarter period: DLMF 19.2.8.
 *
 * @param parameter One of `{m}`, `{mc}`, `{k}`, a number or an array.
 * @returns Within 3 ulp; infinite at m = 1, NaN above.
 *
 * @example
 * completeK({ m: 0.5 }); // 1.854074677301...
 */
export function completeK(parameter: Parameter): number;
export function completeK(parameter: Parameter<Numbers>): Float64Array;
export function completeK(parameter: Parameter<number | Numbers>): number | Float64Array {
  return complete(parameter, 1);
}

/**
 * Complete integral of the second kind E(m): DLMF 19.2.8.
 *
 * @param parameter One of `{m}`, `{mc}`, `{k}`, a number or an array.
 * @returns Within 3 ulp; 1 at m = 1, NaN above.
 *
 * @example
 * completeE({ mc: 0.5 }); // 1.350643881047...
 */
export function completeE(parameter: Parameter): number;
export function completeE(parameter: Parameter<Numbers>): Float64Array;
export function completeE(parameter: Parameter<number | Numbers>): number | Float64Array {
  return complete(parameter, 2);
}

/**
 * Nome q = exp(−πK′/K): DLMF 22.2.1.
 *
 * @param parameter One of `{m}`, `{mc}`, `{k}`, a number or an array.
 * @returns Within 3 ulp; 1 at m = 1, NaN above.
 *
 * @example
 * nome({ m: 0.5 }); // 0.043213918263...
 */
export function nome(parameter: Parameter): number;
export function nome(parameter: Parameter<Numbers>): Float64Array;
export function nome(parameter: Parameter<number | Numbers>): number | Float64Array {
  return complete(parameter, 3);
}
