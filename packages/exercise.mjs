// Tries the npm package that is installed beside this file: every module, every door once, and the periods of the truth.
//     node exercise.mjs CHECKOUT/reference/vectors/pendulum.csv

import { strict as assert } from "node:assert";
import { readFileSync } from "node:fs";
import { approx, Duffing, elliptic, load, loadMotions, loadSecond, Pendulum, usesVectors } from "libration";

await load();
await loadSecond();
await loadMotions();

const pendulum = new Pendulum({ theta0: 3, length: 1, gravity: 9.8 });
assert.equal(pendulum.regime, "libration");
assert.equal(pendulum.period.toFixed(12), "5.160697749978");
assert.equal(pendulum.theta(1e9).toFixed(12), "1.992957289696");
assert.equal(elliptic.sn(1, { m: 0 }).toFixed(15), Math.sin(1).toFixed(15));
const { relative } = approx.angle("fourier:4").of(new Pendulum({ theta0: 2 })).error();
assert.ok(relative > 0 && relative < 1e-4, `${relative}`);
assert.equal(new Duffing({ u0: 1, p: 1, q: 1 }).period.toFixed(6), "4.768022");
assert.throws(() => new Pendulum({ theta0: Number.NaN }), { name: "DomainError" });

/** A double in C99's hexadecimal; the mantissa has fewer digits than a double holds. */
function double(text) {
  const [, sign, mantissa, power] = /^(-?)0x([\d.a-f]+)p([+-]\d+)$/.exec(text) ?? [];
  if (mantissa === undefined) return Number(text.replace("inf", "Infinity"));
  const [whole, fraction = ""] = mantissa.split(".");
  const shift = Number(power) - 4 * fraction.length;
  const half = Math.trunc(shift / 2);
  return (sign ? -1 : 1) * Number.parseInt(whole + fraction, 16) * 2 ** half * 2 ** (shift - half);
}

const [head, ...rows] = readFileSync(process.argv[2], "utf8").trim().split("\n").map((line) => line.split(","));
let worst = 0;
for (const cells of rows) {
  const row = Object.fromEntries(head.map((name, i) => [name, cells[i]]));
  const [theta0, velocity0, omega2, hi, lo] = ["theta0", "velocity0", "omega2", "period_hi", "period_lo"].map((name) => double(row[name]));
  const got = new Pendulum({ theta0, velocity0, omega2 }).period;
  if (!Number.isFinite(hi)) assert.equal(got, hi, row.id);
  else {
    const unit = 2 ** (Math.floor(Math.log2(hi)) - 52) + Number(row.cond_period) * 2 ** -100;
    worst = Math.max(worst, Math.abs(got - hi - lo) / unit);
  }
}
assert.ok(rows.length >= 1998 && worst <= 4, `${rows.length} rows, ${worst} ulp`);
console.log(`Node ${process.versions.node}: ${rows.length} periods of the truth within ${worst.toFixed(2)} ulp, ${usesVectors() ? "with" : "without"} vectors`);
