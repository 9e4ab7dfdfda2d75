/** Jacobi's functions and the complete integrals against the truth, at the bounds of the native core. */

import { strict as assert } from "node:assert";
import { test } from "node:test";
import { DomainError, elliptic } from "./loaded.js";
import { distance, promised, type Row, rows, same, ulp } from "./ruler.js";

const NAMES = ["sn", "cn", "dn", "am"] as const;
type Four = Record<(typeof NAMES)[number], number>;

const MOST = promised("jacobi", "error_max_ulp");

function parameter(row: Row): elliptic.Parameter {
  const value = row.hex("parameter");
  const given = row.text("given");
  if (given === "m") return { m: value };
  if (given === "mc") return { mc: value };
  assert.equal(given, "k");
  return { k: value };
}

const four = (row: Row): Four => elliptic.jacobi(row.hex("u"), parameter(row));

/** Worst error of sn, cn, dn, am over all rows, eased by 2⁻¹⁰⁰ of the condition in u. */
function worstOfJacobi(values: (row: Row) => Four): number {
  return rows("jacobi.csv", 2823).reduce((worst, row) => {
    const got = values(row);
    return NAMES.reduce((most, name) => {
      const truth = row.truth(name);
      const unit = ulp(truth[0]) + row.decimal(`cond_${name}`) * 2 ** -100;
      return Math.max(most, distance(got[name], truth, unit));
    }, worst);
  }, 0);
}

/** Worst error of K, E and the nome. */
function worstOfComplete(values: (row: Row) => [number, number, number]): number {
  return rows("complete.csv", 697).reduce((worst, row) => {
    const got = values(row);
    return ["complete_k", "complete_e", "nome"].reduce((most, name, i) => {
      const truth = row.truth(name);
      return Math.max(most, distance(got[i]!, truth, ulp(truth[0])));
    }, worst);
  }, 0);
}

const three = (row: Row): [number, number, number] => {
  const p = parameter(row);
  return [elliptic.completeK(p), elliptic.completeE(p), elliptic.nome(p)];
};

test("every row of jacobi.csv", () => {
  const worst = worstOfJacobi(four);
  assert.ok(worst <= MOST, String(worst));
});

test("every row of complete.csv", () => {
  const bounds = ["complete_k", "complete_e", "nome"].map((name) => promised(name, "error_max_ulp"));
  const worst = worstOfComplete(three);
  assert.ok(worst <= Math.min(...bounds), String(worst));
});

test("the limits of jacobi_special.csv, bit for bit", () => {
  for (const row of rows("jacobi_special.csv", 116)) {
    const got = four(row);
    for (const name of NAMES) assert.ok(same(got[name], row.hex(name)), `${name} ${got[name]} ${row.text("u")}`);
  }
});

test("spoiled siblings are found", () => {
  const spoiled = (change: (values: Four) => Partial<Four>): number =>
    worstOfJacobi((row) => {
      const values = four(row);
      return { ...values, ...change(values) };
    });
  assert.ok(spoiled(({ sn }) => ({ sn: sn * (1 + 4 * Number.EPSILON) })) > MOST);
  assert.ok(spoiled(({ cn }) => ({ cn: Math.abs(cn) })) > MOST);
  assert.ok(spoiled(({ am }) => ({ am: am % (2 * Math.PI) })) > MOST);
  assert.ok(spoiled(({ dn }) => ({ dn: dn === 1 ? Number.NaN : dn })) > MOST);
  assert.ok(worstOfComplete((row) => [three(row)[0], three(row)[1], three(row)[2] * (1 - 4 * Number.EPSILON)]) > MOST);
});

test("arrays are their numbers, and one function is a part of all four", () => {
  const u = [-3, 0, 0.5, 1e3, Number.NaN];
  const all = elliptic.jacobi(u, { m: 0.7 });
  for (const name of NAMES) {
    const alone = elliptic[name](u, { m: 0.7 });
    u.forEach((each, i) => {
      assert.ok(same(all[name][i]!, elliptic[name](each, { m: 0.7 })) && same(all[name][i]!, alone[i]!));
    });
  }
  const many = Array.from({ length: 5000 }, (_, i) => i / 5000);
  const k = elliptic.completeK({ mc: many });
  assert.ok(many.every((mc, i) => same(k[i]!, elliptic.completeK({ mc }))));
});

test("exactly one of m, mc and k", () => {
  const both = { m: 0.5, k: 0.5 } as unknown as elliptic.Parameter;
  assert.throws(() => elliptic.sn(1, both), new DomainError("parameter", "m = 0.5, k = 0.5", "given as one of m, mc and k"));
  assert.throws(() => elliptic.completeK({} as elliptic.Parameter), DomainError);
});
