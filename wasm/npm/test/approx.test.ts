/** Approximations against the numbers of their papers, and the integrators against what is known of them. */

import { strict as assert } from "node:assert";
import { test } from "node:test";
import { approx, DomainError, Pendulum } from "./loaded.js";

const degrees = (angle: number): number => (angle * Math.PI) / 180;
const released = (angle: number): Pendulum => new Pendulum({ theta0: degrees(angle) });

test("the percentages of Lima's figures 2 to 4", () => {
  for (const [angle, name, percent] of [
    [60, "harmonic", 0.9413],
    [60, "fourier:1", 1.9513],
    [60, "fourier:2", 0.035],
    [90, "harmonic", 2.3289],
    [90, "fourier:2", 0.2269],
    [144, "harmonic", 8.5981],
    [144, "fourier:3", 0.6069],
    [157.5, "harmonic", 12.3427],
    [157.5, "fourier:4", 0.3989],
    [171, "harmonic", 19.7916],
    [171, "fourier:6", 0.2945],
  ] as const) {
    const { relative, undefinedFrom } = approx.angle(name).of(released(angle)).error();
    assert.ok(Math.abs(100 * relative - percent) < 5e-5, `${angle} ${name} ${relative}`);
    assert.ok(Number.isNaN(undefinedFrom));
  }
});

test("where a formula has no value it gives NaN and says since when", () => {
  const series = approx.angle("fourier:1").of(released(140));
  assert.ok(Number.isNaN(series.theta(0)) && series.error().undefinedFrom === 0);
  assert.match(series.formula.entry.undefinedWhere, /from 131\.55 deg with N = 1/);
  const rotation = new Pendulum({ theta0: 0, velocity0: 3 });
  assert.throws(() => approx.angle("harmonic").of(rotation), /regime = rotation: must be libration for harmonic/);
});

test("the table of errors of the period formulas", () => {
  for (const [name, at90, at150] of [
    ["linear", -15.279, -43.253],
    ["bernoulli", -2.214, -18.944],
    ["series:4", -0.367, -9.399],
    ["kidd-fogg", 0.751, 11.544],
    ["molina", 0.355, 5.577],
    ["ganley-parwani", -0.078, -2.442],
    ["lima-arun", 0.249, 3.485],
    ["agm:1", -0.743, -9.841],
    ["agm:2", -0.0014, -0.282],
    ["salas-26", -0.545, -15.397],
    ["salas-27", -0.017, -5.72],
    ["salas-28", -0.0005, -2.091],
  ] as const) {
    const errors = approx.period(name).error({ thetaMax: [degrees(90), degrees(150)] });
    assert.ok(Math.abs(100 * errors[0]! - at90) < 5.1e-4, `${name} ${errors}`);
    assert.ok(Math.abs(100 * errors[1]! - at150) < 5.1e-4, `${name} ${errors}`);
  }
  assert.equal(approx.period("exact").ratio({ thetaMax: degrees(120) }).toFixed(6), "1.372881");
});

test("the registries are complete: every entry says what it is and from whom, and is found by its name", () => {
  for (const [registry, n] of [
    [approx.angle, ":4"],
    [approx.period, ":4"],
    [approx.numerical, ":0.1"],
  ] as const) {
    assert.ok(registry.entries.length >= 5);
    for (const entry of registry.entries) {
      assert.ok(entry.formula !== "" && entry.source !== "", entry.pattern);
      assert.equal(registry(entry.pattern.replace(/:[NH]$/, n)).entry.name, entry.name);
    }
  }
});

test("SciPy's defaults carry Horsley's pendulum over the top, a Runge-Kutta scheme of fixed step does not", () => {
  const horsley = new Pendulum({ theta0: 3, length: 1, gravity: 9.8 });
  const scipy = approx.numerical("rk45").of(horsley, 10);
  assert.ok(Math.abs(scipy.overTheTop - 9.47) < 0.005);
  assert.ok(Number.isNaN(approx.numerical("rk4:0.025").of(horsley, 10).overTheTop));
  assert.ok(horsley.theta(Float64Array.from({ length: 1000 }, (_, i) => i / 100)).every((theta) => Math.abs(theta) <= 3));
  const { t, theta } = scipy.steps();
  assert.ok(t[0] === 0 && t[t.length - 1] === 10 && theta.length === t.length);
  assert.ok(Number.isNaN(scipy.theta(10.1)) && Number.isNaN(scipy.theta(-0.1)));
});

test("errors fall with the order of the scheme", () => {
  const pendulum = new Pendulum({ theta0: 2 });
  const error = (name: string, step: number): number => {
    const { t, theta } = approx.numerical(`${name}:${step}`).of(pendulum, 3).steps();
    const exact = pendulum.theta(t);
    return theta.reduce((worst, angle, i) => Math.max(worst, Math.abs(angle - exact[i]!)), 0);
  };
  for (const [name, order] of [
    ["euler", 1],
    ["euler-cromer", 1],
    ["verlet", 2],
    ["rk4", 4],
  ] as const) {
    const seen = Math.log2(error(name, 1 / 64) / error(name, 1 / 128));
    assert.ok(Math.abs(seen - order) < 0.1, `${name} ${seen}`);
  }
});

test("both energies of the exact motion add up to its energy", () => {
  for (const theta0 of [1, degrees(150), degrees(179.999)]) {
    const pendulum = new Pendulum({ theta0 });
    const t = Float64Array.from({ length: 5000 }, (_, i) => 2 * i * pendulum.period);
    const { kinetic, potential } = pendulum.energies(pendulum.motion(t));
    assert.ok(kinetic.every((each, i) => Math.abs((each + potential[i]!) / pendulum.energy - 1) < 1e-12), String(theta0));
  }
});

test("the sine models", () => {
  const pendulum = new Pendulum({ theta0: 1, omega0: 2 });
  const cubic = approx.angle("cubic").of(pendulum);
  assert.ok(Math.abs(cubic.theta(0) - 1) < 1e-15 && cubic.error().relative < 0.05);
  assert.ok(approx.angle("cubic-quintic").of(pendulum).error().relative < cubic.error().relative);
  assert.equal(approx.angle("cubic").ranges(0.01).length, 1);
});

test("wrong names and steps are answered in one line", () => {
  for (const [wrong, said] of [
    [() => approx.angle("furier:2"), /^formula = "furier:2": must be one of fourier:N, /],
    [() => approx.angle("fourier:0"), /^formula = "fourier:0": must be fourier:N with a whole N from 1 to 500$/],
    [() => approx.period("agm:9"), /^period = "agm:9": must be agm:N with a whole N from 1 to 8$/],
    [() => approx.numerical("rk4"), /^step = none: must be given in s for rk4$/],
    [() => approx.numerical("rk4:x"), /^step = "x": must be a number in s/],
    [() => approx.numerical("euler:1e-9").of(new Pendulum({ theta0: 1 }), 10), /^steps = 1\d{10}: must be at most 5000000$/],
    [() => approx.period("exact").ratio({} as approx.Swing), /^swing = none: must be given as one of thetaMax, m and mc$/],
  ] as const) {
    assert.throws(wrong, (error) => error instanceof DomainError && said.test(error.message));
  }
});
