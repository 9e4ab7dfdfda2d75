/** The pendulum against the truth, stratum by stratum, at the bounds of the native core; spoiled siblings must go red. */

import { strict as assert } from "node:assert";
import { test } from "node:test";
import { Pendulum, type PendulumOptions } from "./loaded.js";
import { distance, eased, promised, type Row, rows, same, summary, ulp } from "./ruler.js";

const ROWS = rows("pendulum.csv", 1998);
const CORNERS = rows("pendulum_corners.csv", 554);
const MOST = promised("Pendulum.theta", "error_max_ulp");
const MEDIAN = promised("Pendulum.theta", "error_median_ulp");

/** The force of a row; of a corner the three factors a b/c are those of one of the constructor's arguments. */
function force(row: Row, corners: boolean): Partial<PendulumOptions> {
  if (!corners) return { omega2: row.hex("omega2") };
  const [a, b, c] = ["omega2_a", "omega2_b", "omega2_c"].map((name) => row.hex(name)) as [number, number, number];
  if (a === b && c === 1) return { omega0: a };
  assert.equal(b, 1);
  return c === 1 ? { omega2: a } : { gravity: a, length: c };
}

const pendulumOf = (row: Row, corners: boolean): Pendulum =>
  new Pendulum({ theta0: row.hex("theta0"), velocity0: row.hex("velocity0"), ...force(row, corners) });

/** Largest |θ| and |θ̇| of the orbit. */
function scales(row: Row, pendulum: Pendulum): [number, number] {
  const thetaMax = row.hex("theta_max_hi");
  const kappa = Number.isNaN(thetaMax) ? Math.sqrt(row.hex("energy_ratio_hi")) : Math.sin(thetaMax / 2);
  const turn = Math.abs(pendulum.turns(0).n * 2 * Math.PI);
  const theta = row.text("regime") === "libration" ? thetaMax + turn : Math.PI;
  return [theta, 2 * pendulum.omega0 * kappa];
}

type Answer = (pendulum: Pendulum, t: number) => { theta: number; velocity: number };

/** Worst error over all rows, worst median over the strata, and the wrong regimes. */
function measured(table: Row[], corners: boolean, answer: Answer): { worst: number; median: number; regimes: number; strata: number } {
  const strata = new Map<string, [number[], number[], number[]]>();
  let regimes = 0;
  for (const row of table) {
    const pendulum = pendulumOf(row, corners);
    if (pendulum.regime !== row.text("regime")) regimes += 1;
    const { theta, velocity } = answer(pendulum, row.hex("t"));
    const [thetaScale, velocityScale] = scales(row, pendulum);
    const floor = 2 ** -30;
    const period = row.truth("period");
    const lists = strata.get(row.text("stratum")) ?? [[], [], []];
    strata.set(row.text("stratum"), lists);
    lists[0].push(eased(theta, row.truth("theta"), floor * thetaScale, row.decimal("cond_theta"), thetaScale));
    lists[1].push(
      eased(velocity, row.truth("velocity"), floor * velocityScale, row.decimal("cond_velocity"), velocityScale),
    );
    lists[2].push(distance(pendulum.period, period, ulp(period[0]) + row.decimal("cond_period") * 2 ** -100));
  }
  const summaries = [...strata.values()].flat().map(summary);
  const worst = Math.max(...summaries.map((each) => each.worst));
  return { worst, median: Math.max(...summaries.map((each) => each.median)), regimes, strata: strata.size };
}

const motion: Answer = (pendulum, t) => pendulum.motion(t);

for (const [name, table, corners, strata] of [
  ["pendulum.csv", ROWS, false, 16],
  ["pendulum_corners.csv", CORNERS, true, 10],
] as const) {
  test(`every stratum of ${name} keeps its last digits`, () => {
    const found = measured(table, corners, motion);
    assert.equal(found.strata, strata);
    assert.equal(found.regimes, 0);
    assert.ok(found.worst <= MOST && found.median <= MEDIAN, JSON.stringify(found));
  });

  test(`energies and turning angles of ${name}`, () => {
    for (const row of table) {
      const pendulum = pendulumOf(row, corners);
      const complement = row.truth("energy_ratio_c");
      const turn = Math.max(Math.abs(pendulum.theta0), 4) * 2 ** -150;
      for (const [member, column, got, ease] of [
        ["energy_ratio", "energy_ratio", pendulum.energyRatio, 0],
        ["energy_ratio_c", "energy_ratio_c", pendulum.energyRatioC, turn * Math.max(Math.sqrt(Math.abs(complement[0])), 1e-3)],
        ["energy", "energy", pendulum.energy, 0],
        ["theta_max", "theta_max", pendulum.thetaMax, 0],
      ] as const) {
        const truth = row.truth(column);
        const error = distance(got, truth, ulp(truth[0]) + ease);
        assert.ok(error <= promised(`Pendulum.${member}`, "error_max_ulp"), `${row.text("id")} ${member} ${got} ${error}`);
      }
    }
  });
}

test("theta, velocity and motion of arrays of any length are those of single times, bit for bit", () => {
  for (const row of ROWS.filter((_, i) => i % 40 === 0)) {
    const pendulum = pendulumOf(row, false);
    const t = Float64Array.from({ length: 11 }, (_, i) => row.hex("t") * (1 + i / 7));
    for (const length of [1, 3, 4, 11]) {
      const { theta, velocity } = pendulum.motion(t.subarray(0, length));
      const [alone, speed] = [pendulum.theta(t.subarray(0, length)), pendulum.velocity(t.subarray(0, length))];
      for (let i = 0; i < length; i++) {
        const one = pendulum.motion(t[i]!);
        assert.ok(same(theta[i]!, one.theta) && same(velocity[i]!, one.velocity), row.text("id"));
        assert.ok(same(theta[i]!, alone[i]!) && same(velocity[i]!, speed[i]!), row.text("id"));
        assert.ok(same(theta[i]!, pendulum.theta(t[i]!)) && same(velocity[i]!, pendulum.velocity(t[i]!)));
      }
    }
  }
});

test("spoiled siblings are found", () => {
  const worst = (answer: Answer): number => measured(ROWS, false, answer).worst;
  const spoiled = (change: (theta: number, velocity: number, t: number, p: Pendulum) => [number, number]): number =>
    worst((pendulum, t) => {
      const found = pendulum.motion(t);
      const [theta, velocity] = change(found.theta, found.velocity, t, pendulum);
      return { theta, velocity };
    });
  assert.ok(spoiled((theta, velocity) => [theta * (1 + 5 * Number.EPSILON), velocity]) > MOST);
  assert.ok(spoiled((theta, velocity) => [theta, -velocity]) > MOST);
  assert.ok(spoiled((_, velocity, t, pendulum) => [pendulum.turns(t).angle, velocity]) > MOST);
  assert.ok(spoiled((theta, velocity, t) => [theta, t > 1e6 ? Number.NaN : velocity]) > MOST);
  assert.ok(worst((pendulum, t) => pendulum.motion(t % pendulum.period)) > MOST);
  // One ulp more, everywhere: the median sees it.
  const next = (value: number): number => (value === 0 ? value : value + Math.sign(value) * ulp(value));
  const medians = measured(ROWS, false, (pendulum, t) => {
    const { theta, velocity } = pendulum.motion(t);
    return { theta: next(theta), velocity: next(velocity) };
  });
  assert.ok(medians.median > MEDIAN);
});
