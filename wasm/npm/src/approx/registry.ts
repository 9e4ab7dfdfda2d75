/** What is known of named formulas before they are asked anything: the tables of the core, and how they are listed. */

import { core, coreWith } from "../core.js";

/** What N may be: from the least to the most in steps. */
export interface Orders {
  least: number;
  most: number;
  /** 1, or 2 where all are even or all odd. */
  step: number;
}

/** An entry of a registry. */
export interface Entry {
  /** How it is asked for: `name`, `name:N`, or `name:H` with a step of H s. */
  readonly pattern: string;
  /** Its name, without `:N`. */
  readonly name: string;
  /** What N may be, if it takes one. */
  readonly orders: Orders | undefined;
  /** The formula, in one line. */
  readonly formula: string;
  /** Author, year and equation. */
  readonly source: string;
  /** The range that the author offers it for, in words; empty where none is stated. */
  readonly stated: string;
  /** The same as turning angles in rad. */
  readonly statedRange: readonly [number, number] | undefined;
  /** Where it has no value; empty where it always has one. */
  readonly undefinedWhere: string;
}

/** Turning angles from the first to the second, in rad. */
export type Interval = readonly [number, number];

/** A registry: called with a name it gives the formula, and it lists what there is. */
export interface Registry<Formula> {
  /**
   * The formula of a name.
   *
   * @throws DomainError naming the nearest names.
   */
  (name: string): Formula;
  /** Everything there is, in the order of the core. */
  readonly entries: readonly Entry[];
  /** The patterns of all. */
  readonly names: readonly string[];
}

/** The numbers of the registries in the core. */
export const KINDS = { angle: 0, period: 1, numerical: 2 } as const;

/** A registry of the core; its entries are read when they are first asked for. */
export function registry<Formula>(kind: keyof typeof KINDS, make: (name: string) => Formula): Registry<Formula> {
  let entries: readonly Entry[] | undefined;
  const read = (): readonly Entry[] => (entries ??= list(KINDS[kind]));
  const find = (name: string): Formula => make(name);
  return Object.defineProperties(find, {
    entries: { get: read },
    names: { get: () => read().map((entry) => entry.pattern) },
  }) as Registry<Formula>;
}

/** The entry of `name` or `name:N`. */
export function entryOf(entries: readonly Entry[], name: string): Entry {
  const base = name.split(":")[0];
  const found = entries.find((entry) => entry.name === base);
  if (!found) throw core().refusal();
  return found;
}

/** The ends of a list as intervals. */
export function intervals(ends: Float64Array): Interval[] {
  return Array.from({ length: ends.length / 2 }, (_, i) => [ends[2 * i]!, ends[2 * i + 1]!] as const);
}

function list(kind: number): readonly Entry[] {
  const of = kind === KINDS.period ? coreWith("period_values", "approx.period") : core();
  of.exports.registry(kind);
  const [low, high, least, most, step] = [0, 1, 2, 3, 4].map((i) => of.column(i));
  return of
    .text()
    .split("\n")
    .map((line, i) => {
      const [name = "", formula = "", source = "", stated = "", undefinedWhere = ""] = line.split("\t");
      const pattern = kind === KINDS.numerical && least![i]! > 0 ? `${name}:H` : name;
      return {
        pattern,
        name: pattern.split(":")[0]!,
        orders: most![i]! > 0 ? { least: least![i]!, most: most![i]!, step: step![i]! } : undefined,
        formula,
        source,
        stated,
        statedRange: Number.isNaN(low![i]!) ? undefined : ([low![i]!, high![i]!] as const),
        undefinedWhere,
      };
    });
}
