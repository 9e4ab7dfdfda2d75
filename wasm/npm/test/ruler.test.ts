/** The ruler measures: what must be far is far, what must be near is near. */

import { strict as assert } from "node:assert";
import { test } from "node:test";
import { distance, eased, hex, promised, rows, same, summary, ulp } from "./ruler.js";

const { EPSILON, NaN: NAN, POSITIVE_INFINITY: INFINITY } = Number;

test("NaN is close to nothing", () => {
  assert.equal(distance(NAN, [1, 0], 1), INFINITY);
  assert.equal(distance(1, [NAN, 0], 1), INFINITY);
  assert.equal(distance(NAN, [NAN, NAN], 1), 0);
  assert.equal(distance(1, [2, 0], NAN), INFINITY);
});

test("signs and infinities measure", () => {
  assert.ok(distance(-1, [1, 0], ulp(1)) > 1e15);
  assert.ok(distance(1, [-1, 0], ulp(1)) > 1e15);
  assert.equal(distance(-1 - 3 * EPSILON, [-1, 0], ulp(-1)), 3);
  assert.equal(distance(INFINITY, [-INFINITY, 0], 1), INFINITY);
  assert.equal(distance(INFINITY, [INFINITY, 0], 1), 0);
  assert.equal(distance(1e308, [INFINITY, 0], 1), INFINITY);
  assert.equal(distance(INFINITY, [1e308, 0], 1), INFINITY);
});

test("fractions of an ulp are read, and the ease has an end", () => {
  assert.equal(distance(1, [1, 0.25 * EPSILON], ulp(1)), 0.25);
  assert.equal(ulp(1), EPSILON);
  assert.equal(ulp(0), 5e-324);
  assert.equal(ulp(-4), 4 * EPSILON);
  assert.equal(eased(1 + EPSILON, [1, 0], 0, 0, 1), 1);
  assert.ok(eased(1 + 1e-10, [1, 0], 0, INFINITY, 1) > 1e3);
});

test("hexadecimal doubles read exactly", () => {
  assert.equal(hex("0x1.8p+1"), 3);
  assert.equal(hex("-0x1.921fb54442d18p+1"), -Math.PI);
  assert.equal(hex("0x0.0000000000001p-1022"), 5e-324);
  assert.equal(hex("0x1.fffffffffffffp+1023"), Number.MAX_VALUE);
  assert.equal(hex("-inf"), -INFINITY);
  assert.ok(Object.is(hex("-0x0.0p+0"), -0) && Number.isNaN(hex("nan")));
  assert.throws(() => hex("1.5"));
  assert.deepEqual(summary([3, 1, 2]), { worst: 3, median: 2 });
  assert.ok(same(NAN, -NAN) && !same(0, -0));
});

test("a lost row and a lost promise are errors", () => {
  assert.throws(() => rows("jacobi_special.csv", 115), /lost or gained rows/);
  assert.throws(() => rows("no_such_file.csv", 1), /no such file/);
  assert.throws(() => promised("Pendulum.theta0", "error_max_ulp"), /has no error_max_ulp/);
  assert.throws(() => promised("nothing", "error_max_ulp"), /has no nothing/);
});
