/** How the core is loaded, what is refused before, and which arguments a pendulum takes. */

import { strict as assert } from "node:assert";
import { execFile } from "node:child_process";
import { readFile } from "node:fs/promises";
import { test } from "node:test";
import { promisify } from "node:util";
import { DomainError, hasVectors, Pendulum, version } from "./loaded.js";
import { ROOT } from "./ruler.js";

/** What a program of its own prints, the package not yet being loaded in it. */
async function printed(program: string): Promise<string> {
  const options = { cwd: new URL("wasm/npm/", ROOT) };
  const { stdout } = await promisify(execFile)(process.execPath, ["--input-type=module", "-e", program], options);
  return stdout.trim();
}

test("before load everything says what is missing", async () => {
  const program = `import { Pendulum } from "libration";
    try { new Pendulum({ theta0: 1 }); } catch (error) { console.log(error.message); }`;
  assert.equal(await printed(program), "the core is not loaded: await load() first");
});

test("what is in the second module says so, and is there once it is loaded", async () => {
  const program = `import { approx, elliptic, load, loadSecond, Pendulum } from "libration";
    await load();
    const pendulum = new Pendulum({ theta0: 1 });
    const asked = [
      () => approx.angle("cubic").of(pendulum).theta(0), () => approx.angle("linear").ranges(0.01).length,
      () => approx.period("exact").period(pendulum) / pendulum.period, () => elliptic.completeK({ m: 0 }).toFixed(6),
      () => elliptic.sn(0.5, { m: 0 }).toFixed(6),
    ];
    for (const each of asked) try { each(); } catch (error) { console.log(error.message); }
    await loadSecond();
    console.log(approx.period.names.length > 10);
    for (const each of asked) console.log(each());`;
  const missing = ["cubic", "ranges", "approx.period", "elliptic", "elliptic"].map((each) => `${each} is in the second module: await loadSecond() first`);
  assert.equal(await printed(program), [...missing, "true", "1", "1", "1", "1.570796", "0.479426"].join("\n"));
});

test("a module comes from the package, from bytes, from a base64 address; a wrong one can be tried again", async () => {
  const program = `import { load, Pendulum, usesVectors } from "libration";
    import { readFileSync } from "node:fs";
    const scalar = "data:application/wasm;base64," + readFileSync("dist/libration-scalar.wasm").toString("base64");
    await load({ scalar: new Uint8Array(4) }).catch((error) => console.log(error.name));
    await Promise.all([load({ scalar }), load({ scalar })]);
    console.log(usesVectors(), new Pendulum({ theta0: 3 }).theta(5));`;
  const scalar = await printed(program);
  const simd = await printed(`import { load, Pendulum } from "libration"; await load(); console.log(new Pendulum({ theta0: 3 }).theta(5));`);
  assert.equal(scalar, `CompileError\nfalse ${simd}`);
});

test("an engine without vectors takes the scalar module", async () => {
  const program = `WebAssembly.validate = () => false;
    const { load, usesVectors, hasVectors } = await import("libration");
    await load(); console.log(hasVectors(), usesVectors());`;
  assert.equal(await printed(program), "false false");
  assert.equal(hasVectors(), true);
});

test("the version is that of the core", async () => {
  const manifest = await readFile(new URL("Cargo.toml", ROOT), "utf8");
  assert.equal(version(), /^version = "(.*)"$/m.exec(manifest)?.[1]);
  const { version: ours } = JSON.parse(await readFile(new URL("wasm/npm/package.json", ROOT), "utf8")) as { version: string };
  assert.equal(version(), ours);
});

test("wrong arguments are named with their value and what is allowed", () => {
  const refused = (options: object): string => {
    try {
      new Pendulum(options as { theta0: number });
    } catch (error) {
      if (error instanceof DomainError) return error.message;
      throw error;
    }
    return "";
  };
  assert.equal(refused({ theta0: Number.NaN }), "theta0 = NaN: must be finite");
  assert.equal(refused({ theta0: 1, length: -1 }), "length = -1.0: must be finite and positive");
  assert.match(refused({ theta0: 1, omega0: 1, length: 2 }), /must be given as one of omega0, omega2 and length$/);
  assert.match(refused({ theta0: 1, gravity: 9.8 }), /^gravity = 9.8: must be given with a length$/);
  assert.equal(new Pendulum({ theta0: 1, length: 2 }).gravity, 9.80665);
  // Numbers as the native core writes them.
  const written: readonly [number, string][] = [
    [-0, "-0.0"], [-0.1, "-0.1"], [-1e-4, "-0.0001"], [-1e-5, "-1e-5"], [-9.9999e-5, "-9.9999e-5"], [-5e-324, "-5e-324"], [-123456789.25, "-123456789.25"],
    [-9999999999999998, "-9999999999999998.0"], [-1e16, "-1e16"], [-1.5e300, "-1.5e300"], [Number.POSITIVE_INFINITY, "inf"],
    [Number.NEGATIVE_INFINITY, "-inf"],
  ];
  for (const [length, text] of written) assert.match(refused({ theta0: 1, length }), new RegExp(`^length = ${text.replace(".", "\\.")}: `));
  assert.match(refused({ theta0: 1, omega0: -1e-5, length: 1e21 }), /^frequency = omega0 = -1e-5, length = 1e21: /);
});

test("times, turns and crossings", () => {
  const pendulum = new Pendulum({ theta0: 1 });
  const times = pendulum.times(0.5, 0, 7);
  assert.deepEqual(Array.from(times, (t) => t.toFixed(6)), ["1.126844", "5.573131"]);
  assert.deepEqual(Array.from(pendulum.turningTimes(0, 10), (t) => t.toFixed(6)), ["0.000000", "3.349988", "6.699976"]);
  assert.equal(pendulum.nextCrossing(0.5, 2), times[1]);
  assert.ok(Number.isNaN(pendulum.nextCrossing(2, 0)));
  assert.throws(() => pendulum.times(0.5, 1, 0), /^DomainError: stop = 0.0: must be not before start, 1.0$/);
  const { n, angle } = new Pendulum({ theta0: 0, velocity0: 3 }).turns(10);
  assert.ok(n === 4 && angle.toFixed(6) === "1.025388");
});

test("thousands of forgotten pendulums leave room, and one thousand are kept apart", () => {
  const many = Array.from({ length: 1000 }, (_, i) => new Pendulum({ theta0: (i + 1) / 1000 }));
  many.forEach((pendulum, i) => assert.equal(pendulum.theta(0), (i + 1) / 1000));
});

test("results go where they are told, also onto their arguments", () => {
  const pendulum = new Pendulum({ theta0: 2 });
  const t = Float64Array.from({ length: 10000 }, (_, i) => i / 100);
  const expected = pendulum.motion(t);
  const out = { theta: new Float64Array(t.length), velocity: new Float64Array(t.length) };
  assert.equal(pendulum.motion(t, out).theta, out.theta);
  assert.deepEqual(out, expected);
  const energies = pendulum.energies(expected);
  const kept = { kinetic: new Float64Array(t.length), potential: out.velocity };
  assert.equal(pendulum.energies(out, kept).potential, out.velocity);
  assert.deepEqual(kept, energies);
  assert.equal(pendulum.theta(t, t), t);
  assert.deepEqual(t, expected.theta);
});
