/**
 * The ruler of every accuracy test: distances from a truth stored as hi + lo, in ulps and in the unit that the condition of
 * the problem allows; the vectors, which refuse to lose a row; and the bounds, which are those of functions.toml.
 */

import { strict as assert } from "node:assert";
import { readFileSync } from "node:fs";

/** The repository. */
export const ROOT = new URL("../../../../", import.meta.url);

const bits = new DataView(new ArrayBuffer(8));

/** Size of the last place of a double (the spacing above it), the smallest subnormal at and near zero. */
export function ulp(value: number): number {
  const size = Math.abs(value);
  if (size === Number.POSITIVE_INFINITY) return size;
  bits.setFloat64(0, size);
  bits.setBigUint64(0, bits.getBigUint64(0) + 1n);
  return bits.getFloat64(0) - size;
}

/** Whether two doubles are the same, bit for bit; any NaN is one NaN. */
export function same(a: number, b: number): boolean {
  return Object.is(a, b);
}

/** A truth: the nearest double, and what is missing. */
export type Truth = readonly [hi: number, lo: number];

/** |got − (hi + lo)| in units of `unit`: infinite for NaN, for a wrong infinity, for a unit of nothing. */
export function distance(got: number, [hi, lo]: Truth, unit: number): number {
  if (Number.isNaN(hi)) return Number.isNaN(got) ? 0 : Number.POSITIVE_INFINITY;
  if (Number.isNaN(got) || Number.isNaN(unit)) return Number.POSITIVE_INFINITY;
  if (!Number.isFinite(hi) || !Number.isFinite(got)) return got === hi ? 0 : Number.POSITIVE_INFINITY;
  const error = Math.abs(got - hi - lo);
  return error === 0 ? 0 : error / unit;
}

/** Ulps of max(|truth|, floor), eased by 2⁻¹⁰⁰ of the condition, at most 2⁻⁴⁴ of the scale. */
export function eased(got: number, truth: Truth, floor: number, condition: number, scale: number): number {
  // Free rotation has no scale of its velocity, 2 ω₀ κ with κ infinite: it sets no limit and no floor.
  const known = (limit: number, without: number): number => (Number.isNaN(limit) ? without : limit);
  const ease = Math.min(condition * 2 ** -100, known(scale * 2 ** -44, Number.POSITIVE_INFINITY));
  return distance(got, truth, ulp(Math.max(Math.abs(truth[0]), known(floor, 0))) + ease);
}

/** Largest and median of a list that is not empty. */
export function summary(errors: number[]): { worst: number; median: number } {
  assert.ok(errors.length > 0);
  const rising = [...errors].sort((a, b) => a - b);
  return { worst: rising[rising.length - 1]!, median: rising[Math.floor(rising.length / 2)]! };
}

/** C99 hexadecimal double, exactly. */
export function hex(text: string): number {
  const negative = text.startsWith("-");
  const body = negative ? text.slice(1) : text;
  const sign = negative ? -1 : 1;
  if (body === "inf") return sign * Number.POSITIVE_INFINITY;
  if (body === "nan") return Number.NaN;
  const parts = /^0x([01])\.([0-9a-f]*)p([+-]\d+)$/.exec(body);
  assert.ok(parts, `not a hexadecimal double: ${text}`);
  const [, whole = "", fraction = "", power = ""] = parts;
  let value = Number(BigInt(`0x${whole}${fraction}`));
  let left = Number(power) - 4 * fraction.length;
  // In steps, so that nothing is rounded twice or lost on the way.
  for (; left < 0 && value !== 0; left -= Math.max(left, -500)) value *= 2 ** Math.max(left, -500);
  return sign * value * 2 ** Math.max(left, 0);
}

/** One row of a vectors file, by column name. */
export class Row {
  private readonly cells: ReadonlyMap<string, string>;

  constructor(cells: ReadonlyMap<string, string>) {
    this.cells = cells;
  }

  /** The text of a cell. */
  text(column: string): string {
    const cell = this.cells.get(column);
    assert.ok(cell !== undefined, `no column ${column}`);
    return cell;
  }

  /** A hexadecimal double. */
  hex(column: string): number {
    return hex(this.text(column));
  }

  /** hi + lo. */
  truth(name: string): Truth {
    return [this.hex(`${name}_hi`), this.hex(`${name}_lo`)];
  }

  /** A decimal, infinite or zero where it leaves the range of doubles. */
  decimal(column: string): number {
    const value = Number(this.text(column).replace("inf", "Infinity"));
    assert.ok(!Number.isNaN(value), `${column} is not a decimal`);
    return value;
  }
}

/** All rows of a file of reference/vectors; an error if the count is not the expected one. */
export function rows(file: string, count: number): Row[] {
  const text = readFileSync(new URL(`reference/vectors/${file}`, ROOT), "utf8");
  const [header = "", ...lines] = text.split("\n").filter((line) => line !== "" && !line.startsWith("#"));
  const names = header.split(",");
  const found = lines.map((line) => {
    const cells = line.split(",");
    assert.equal(cells.length, names.length, line);
    return new Row(new Map(names.map((name, i) => [name, cells[i]!])));
  });
  assert.equal(found.length, count, "the vectors have lost or gained rows");
  return found;
}

const PROMISES = readFileSync(new URL("functions.toml", ROOT), "utf8").split("\n");

/** A number that functions.toml promises of a member. */
export function promised(member: string, field: "error_max_ulp" | "error_median_ulp"): number {
  const head = [`[${member}]`, `["${member}"]`];
  const start = PROMISES.findIndex((line) => head.includes(line));
  assert.ok(start >= 0, `functions.toml has no ${member}`);
  for (const line of PROMISES.slice(start + 1)) {
    if (line.startsWith("[")) break;
    const [name, value] = line.split(" = ");
    if (name === field) return Number(value);
  }
  return assert.fail(`functions.toml: ${member} has no ${field}`);
}
