/** Springs and friction against the truth, at the bounds of the native core; spoiled siblings must go red. */

import { strict as assert } from "node:assert";
import { test } from "node:test";
import { CubicQuintic, DampedPendulum, DomainError, Duffing, loadMotions, type Motion, Pendulum, type SpringMotion } from "./loaded.js";
import { distance, type Row, rows, ulp } from "./ruler.js";

await loadMotions();

const DUFFING = rows("duffing.csv", 987);
const EVEN_POWERS = rows("helmholtz_duffing.csv", 1929);
const CUBIC_QUINTIC = rows("cubic_quintic.csv", 784);
const DAMPED = rows("damped.csv", 350);

type Spring = Duffing | CubicQuintic;
const start = (row: Row): { u0: number; velocity0: number } => ({ u0: row.hex("u0"), velocity0: row.hex("velocity0") });
const duffing = (row: Row): Spring => new Duffing({ ...start(row), p: row.hex("p"), q: row.hex("q") });
const evenPowers = (row: Row): Spring =>
  new Duffing({ ...start(row), p: row.hex("p"), q: row.hex("q"), r: row.hex("r"), c: row.hex("c") });
const cubicQuintic = (row: Row): Spring =>
  new CubicQuintic({ ...start(row), p: row.hex("alpha"), q: row.hex("beta"), s: row.hex("gamma") });

/** Worst error of each quantity in units of what is promised, and how many regimes are wrong. */
function springs(table: Row[], made: (row: Row) => Spring, answer: (spring: Spring, t: number) => SpringMotion<number>): Record<string, number> {
  const worst: Record<string, number> = { regimes: 0 };
  for (const row of table) {
    const spring = made(row);
    if (spring.regime !== row.text("regime")) worst["regimes"]! += 1;
    const { u, velocity } = answer(spring, row.hex("t"));
    const eased = (name: string): number => row.decimal(`cond_${name}`) * 2 ** -100;
    // The other files have no conditions of these.
    const ofEven = (name: string): number => (table === EVEN_POWERS ? eased(name) : 0);
    const found: Record<string, [got: number, unit: number]> = {
      u: [u, ulp(row.decimal("scale_u")) + eased("u")],
      velocity: [velocity, ulp(row.decimal("scale_velocity")) + eased("velocity")],
      period: [spring.period, ulp(row.truth("period")[0]) + eased("period")],
      low: [spring.range[0], ulp(row.truth("low")[0]) + ofEven("low")],
      high: [spring.range[1], ulp(row.truth("high")[0]) + ofEven("high")],
      energy: [spring.energy, ulp(row.truth("energy")[0]) + ofEven("energy")],
      escape: [spring.escapeTime, 2.5e-15 * Math.abs(row.truth("escape")[0]) + eased("escape")],
      escape_backward: [spring.escapeTimeBackward, 2.5e-15 * Math.abs(row.truth("escape_backward")[0]) + eased("escape_backward")],
    };
    for (const [name, [got, unit]] of Object.entries(found)) {
      const truth = row.truth(name);
      // Of a row that has no value there is no scale either.
      const error = Number.isNaN(truth[0]) || !Number.isFinite(truth[0]) ? distance(got, truth, 1) : distance(got, truth, unit);
      worst[name] = Math.max(worst[name] ?? 0, error);
    }
  }
  return worst;
}

const plain = (spring: Spring, t: number): SpringMotion<number> => spring.motion(t);
const holds = (worst: Record<string, number>): boolean => worst["regimes"] === 0 && Object.values(worst).every((each) => each <= 4);

for (const [name, table, made] of [
  ["duffing.csv", DUFFING, duffing],
  ["helmholtz_duffing.csv", EVEN_POWERS, evenPowers],
  ["cubic_quintic.csv", CUBIC_QUINTIC, cubicQuintic],
] as const) {
  test(`springs of ${name} keep their last digits`, () => {
    const worst = springs(table, made, plain);
    assert.ok(holds(worst), JSON.stringify(worst));
  });

  test(`spoiled springs of ${name} are found`, () => {
    const late = springs(table, made, (spring, t) => spring.motion(t * (1 + 1e-13)));
    const turned = springs(table, made, (spring, t) => ({ ...spring.motion(t), velocity: -spring.motion(t).velocity }));
    assert.ok(!holds(late) && !holds(turned));
  });
}

/** Worst error of the rows with a torque of the four numbers, in units of what is promised. */
function damped(answer: (pendulum: DampedPendulum, t: number) => Motion<number>): number {
  let worst = 0;
  let count = 0;
  for (const row of DAMPED) {
    if (row.text("samples") !== "") continue;
    count += 1;
    const of = (...names: string[]): Record<string, number> => Object.fromEntries(names.map((name) => [name, row.hex(name)]));
    const pendulum = new DampedPendulum({
      theta0: row.hex("theta0"),
      ...of("velocity0", "omega2"),
      friction: of("linear", "quadratic", "dry", "presliding"),
      torque: of("constant", "amplitude", "frequency", "phase"),
    });
    const { theta, velocity } = answer(pendulum, row.hex("t"));
    for (const [name, got] of [
      ["theta", theta],
      ["velocity", velocity],
    ] as const) {
      const unit = ulp(row.decimal(`scale_${name}`)) + row.decimal(`cond_${name}`) * 2 ** -57;
      worst = Math.max(worst, distance(got, row.truth(name), unit));
    }
  }
  assert.ok(count > 250, String(count));
  return worst;
}

test("motions with friction and torque keep their digits; spoiled ones are found", () => {
  const worst = damped((pendulum, t) => pendulum.motion(t));
  assert.ok(worst <= 2, String(worst));
  assert.ok(damped((pendulum, t) => ({ ...pendulum.motion(t), theta: pendulum.motion(t).theta + 1e-14 })) > 2);
  assert.ok(damped((pendulum, t) => pendulum.motion(t * (1 + 1e-14))) > 2);
});

test("an array has the digits of its numbers, turns and energy are those of the angle", () => {
  const pendulum = new DampedPendulum({ theta0: 1, velocity0: 7, omega0: 2, friction: { linear: 0.05, dry: 0.1 } });
  const t = Float64Array.from({ length: 5000 }, (_, i) => 0.004 * i);
  const { theta, velocity } = pendulum.motion(t);
  const { n, angle } = pendulum.turns(t);
  const energy = pendulum.energy(t);
  for (let i = 0; i < t.length; i += 501) {
    assert.deepEqual(pendulum.motion(t[i]!), { theta: theta[i], velocity: velocity[i] });
    assert.ok(Math.abs(2 * Math.PI * n[i]! + angle[i]! - theta[i]!) < 1e-14 * Math.abs(theta[i]!) + 1e-14);
    assert.ok(Math.abs(energy[i]! - velocity[i]! ** 2 / 2 - 8 * Math.sin(theta[i]! / 2) ** 2) < 1e-13 * energy[0]!);
  }
  const spring = new Duffing({ u0: 1, p: 1, q: 1 });
  const found = spring.motion(t);
  for (let i = 0; i < t.length; i += 501) assert.deepEqual(spring.motion(t[i]!), { u: found.u[i], velocity: found.velocity[i] });
});

test("without friction it is the exact pendulum; turns, rests and the averaged law are those of the core", () => {
  const free = new DampedPendulum({ theta0: 2, omega0: 1 });
  assert.equal(free.motion(7).theta, new Pendulum({ theta0: 2 }).theta(7));
  const dry = new DampedPendulum({ theta0: 1, omega0: 2, friction: { dry: 0.5 } });
  const rests = dry.rests(0, 20).map((each) => each.map((t) => t.toFixed(6)));
  assert.deepEqual(rests, [["6.432369", "20.000000"]]);
  assert.equal(dry.turningTimes(0, 20)[0], 0);
  const slow = new DampedPendulum({ theta0: 1, omega0: 1, friction: { linear: 0.01 } });
  assert.equal(slow.averagedTurningAngle(1, [50])[0]!.toFixed(6), "0.596202");
});

test("a motion that takes too many steps ends where it ends; wrong arguments are named", () => {
  const driven = new DampedPendulum({ theta0: 1, omega0: 1, friction: { quadratic: -1 } });
  const reach = driven.reach(1e4);
  assert.ok(reach > 0 && reach < 1e4 && Number.isNaN(driven.motion(1e4).theta), String(reach));
  const refused = (make: () => unknown): string => {
    try {
      make();
    } catch (error) {
      if (error instanceof DomainError) return error.message;
    }
    return "";
  };
  assert.equal(refused(() => new Duffing({ u0: Number.NaN, p: 1, q: 1 })), "u0 = NaN: must be finite");
  assert.equal(refused(() => new Duffing({ u0: 1, p: 1, q: 1, r: Number.NaN })), "r = NaN: must be finite");
  assert.equal(refused(() => new CubicQuintic({ u0: 1, p: 1, q: 1, s: Number.POSITIVE_INFINITY })), "s = inf: must be finite");
  assert.equal(refused(() => new DampedPendulum({ theta0: 1, friction: { dry: -1 } })), "dry = -1.0: must be finite and not negative");
  assert.equal(refused(() => new DampedPendulum({ theta0: 1 }).turningTimes(3, 2)), "stop = 2.0: must be not before start, 3.0");
});

test("without even powers a Duffing oscillator is the same to the last bit; with them it has them", () => {
  const [odd, even] = [new Duffing({ u0: 1.2, p: 1, q: -0.5 }), new Duffing({ u0: 1.2, p: 1, q: -0.5, r: 0, c: 0 })];
  for (const t of [0.3, 4, 1e5]) assert.deepEqual(odd.motion(t), even.motion(t));
  const beam = new Duffing({ u0: 1, p: 1, q: 0.2, r: 0.5 });
  assert.deepEqual([beam.r, beam.c, odd.r, odd.c], [0.5, 0, 0, 0]);
  assert.equal(beam.range[0].toFixed(9), "-1.401980262");
  assert.equal(new Duffing({ u0: 0, p: 1, q: 0, c: 2 }).motion(Math.PI / 2).u.toFixed(9), "2.000000000");
});

test("the companion of a pendulum is tan(θ/2)", () => {
  const spring = Duffing.ofPendulum({ theta0: 2, length: 1, gravity: 9.81 });
  const pendulum = new Pendulum({ theta0: 2, length: 1, gravity: 9.81 });
  assert.ok(Math.abs(spring.period / pendulum.period - 1) < 1e-14);
  for (const t of [0.1, 0.7, 1.9]) assert.ok(Math.abs(spring.motion(t).u - Math.tan(pendulum.theta(t) / 2)) < 1e-13);
});

test("what is given back answers no more, and leaves the others alone", () => {
  const made = (theta0: number): DampedPendulum => new DampedPendulum({ theta0, friction: { linear: 0.1 } });
  const [first, second] = [made(1), made(2)];
  const kept = second.motion(3);
  first.free();
  first.free();
  assert.ok(Number.isNaN(first.reach(1)));
  const third = made(3);
  assert.deepEqual(second.motion(3), kept);
  assert.notEqual(third.motion(3).theta, kept.theta);
});
