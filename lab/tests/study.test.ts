// The study on the core: the numbers of the papers, as the page shows them. Expected values are those printed in Lima 2019,
// Horsley 2025 and Salas 2019 or found by 30-digit integration (mpmath), never our own output.

import { approx, Pendulum } from 'libration'
import { beforeAll, describe, expect, it } from 'vitest'
import type { Curve } from '../src/curves'
import { readLink } from '../src/link'
import { completedModel, type Model, type Motion, openModel } from '../src/model'
import { radians } from '../src/number'
import { DEFAULTS, type State } from '../src/state'
import { errorFactor, inPercent, isLog, largestOf, showsTotal, spanOf, study, windowOf } from '../src/study'
import { EXAMPLES, type ExampleName, exampleState } from '../src/views/examples'

let model: Model
beforeAll(async () => {
  await openModel()
  model = await completedModel()
})

const motionOf = (state: Pick<State, 'theta0' | 'velocity0' | 'length' | 'gravity'>): Motion => model.motion(state)
const swing = (degrees: number): Motion => motionOf({ ...DEFAULTS, theta0: radians(degrees) })
const over = (motion: Motion, curves: readonly Curve[], span: State['span'], t = 0) => {
  const { from, to } = windowOf(spanOf({ span }, motion), t)
  return study(motion, curves, from, to)
}
const named = (name: Curve['name'], argument?: number): Curve =>
  argument === undefined ? { name, on: true } : { name, argument, on: true }

describe('Lima: the largest error over one period, in per cent of the angle', () => {
  it.each([
    [60, 'harmonic', undefined, 0.9413],
    [60, 'fourier', 1, 1.9513],
    [60, 'fourier', 2, 0.035],
    [90, 'harmonic', undefined, 2.3289],
    [90, 'fourier', 2, 0.2269],
    [144, 'harmonic', undefined, 8.5981],
    [144, 'fourier', 3, 0.6069],
    [157.5, 'harmonic', undefined, 12.3427],
    [157.5, 'fourier', 4, 0.3989],
    [171, 'harmonic', undefined, 19.7916],
    [171, 'fourier', 6, 0.2945],
  ] as const)('at %d°: %s %s is %d', (degrees, name, argument, expected) => {
    const motion = swing(degrees)
    const [row] = over(motion, [named(name, argument)], 'T').rows
    expect((row?.drawn?.largest?.value ?? Number.NaN) * errorFactor(true, motion)).toBeCloseTo(expected, 3)
  })

  it('samples of another window say the same to three digits', () => {
    const motion = swing(157.5)
    const [row] = study(motion, [named('harmonic')], motion.period, 2 * motion.period).rows
    expect((row?.drawn?.largest?.value ?? Number.NaN) * errorFactor(true, motion)).toBeCloseTo(12.3427, 2)
  })

  it('one term has no value at 140°, and is not a number but a gap', () => {
    const [row] = over(swing(140), [named('fourier', 1)], 'T').rows
    expect(row?.drawn?.gone).toBe(0)
    expect(over(swing(131), [named('fourier', 1)], 'T').rows[0]?.drawn?.gone).toBeNaN()
  })
})

describe('Horsley: 3 rad, 1 m, 9.8 m/s²', () => {
  const start = { theta0: 3, velocity0: 0, length: 1, gravity: 9.8 }

  it('RK45 at its defaults goes over the top at 9.47 s, RK4 and the exact motion do not', () => {
    const { rows, exact } = over(motionOf(start), [named('rk45'), named('rk4', 0.025)], 12)
    expect(rows[0]?.drawn?.solution.overTop).toBeCloseTo(9.47, 2)
    expect(rows[1]?.drawn?.solution.overTop).toBeNaN()
    expect(Math.max(...exact.theta)).toBeLessThanOrEqual(3)
    expect(Math.min(...exact.theta)).toBeGreaterThanOrEqual(-3)
  })

  it('shows total energy by itself, for RK45 drifts', () => {
    const found = over(motionOf(start), [named('rk45')], 12)
    expect(showsTotal(DEFAULTS, found)).toBe(true)
    expect(showsTotal(DEFAULTS, over(motionOf(start), [named('linear')], 12))).toBe(false)
    expect(showsTotal({ energy: 'parts' }, found)).toBe(false)
  })
})

describe('the motion', () => {
  it.each([
    [10, 1.001907],
    [60, 1.073182],
    [90, 1.180341],
    [150, 1.762204],
    [179, 3.901065],
  ])('at %d° has a period of %d small swings', (degrees, ratio) => {
    const motion = swing(degrees)
    expect(motion.period / motion.smallPeriod).toBeCloseTo(ratio, 6)
  })

  it('of Salas with m = 1.419 is at 5.1116 rad at 2.1 s, turns counted on', () => {
    const motion = motionOf(exampleState('salas', DEFAULTS))
    expect(motion.energyRatio.toFixed(3)).toBe('1.419')
    expect(motion.theta(2.1)).toBeCloseTo(5.1116, 4)
  })

  it('at rest at 180° stays, and the linear one beside it does not', () => {
    const motion = swing(180)
    expect([motion.balanced, motion.regime, motion.theta(1e4), motion.velocity(5)]).toEqual([true, 'rest', Math.PI, 0])
    const { rows, exact } = over(motion, [named('linear'), named('rk4', 0.025)], 60)
    expect(new Set(exact.theta)).toEqual(new Set([Math.PI]))
    expect(rows[0]?.drawn?.largest?.value).toBeCloseTo(2 * Math.PI, 2)
  })

  it('a hair beside it swings', () => expect(swing(179.999).regime).toBe('libration'))

  it('with the velocity of the separatrix never arrives', () => {
    const { length, gravity } = DEFAULTS
    const still = motionOf({ theta0: 0, velocity0: 0, length: 1, gravity: 4 })
    const motion = motionOf({ theta0: 0, velocity0: 4, length: 1, gravity: 4 })
    expect(still.separatrixVelocity(0)).toBe(4)
    expect([motion.regime, motion.period, motion.thetaMax]).toEqual(['separatrix', Number.POSITIVE_INFINITY, Math.PI])
    expect(length * gravity).toBeGreaterThan(0)
  })

  it('keeps its energy: kinetic and potential are the whole at every point', () => {
    for (const degrees of [1, 90, 179.999]) {
      const motion = swing(degrees)
      const times = Float64Array.from({ length: 500 }, (_, i) => (i / 7) * motion.period)
      for (const total of motion.energy(motion.sample(times)).total) {
        expect(Math.abs(total / motion.energyRatio - 1)).toBeLessThan(1e-12)
      }
    }
  })

  it('has level curves through its own points', () => {
    const motion = swing(150)
    for (const t of [0.3, 1, 2.4]) {
      const [level] = motion.levelVelocity(Float64Array.of(motion.theta(t)), motion.energyRatio)
      expect(level).toBeCloseTo(Math.abs(motion.velocity(t)), 9)
    }
  })
})

describe('a curve that is not for a motion', () => {
  it('is refused with a reason, and the others are drawn', () => {
    const motion = motionOf({ ...DEFAULTS, theta0: 0, velocity0: 7.5 })
    const { rows, shown } = over(motion, [named('harmonic'), named('rk45')], 8)
    expect(rows.map(({ refused }) => refused)).toEqual(['rotation', null])
    expect(shown.map(({ key }) => key)).toEqual(['rk45'])
  })

  it('is refused where all would take more steps than a frame has time for', () => {
    const refused = (curves: readonly Curve[], to: number, motion = swing(20)) =>
      over(motion, curves, 8, to).rows.map((row) => row.refused)
    expect(refused([named('euler', 0.0001)], 51)).toEqual(['steps'])
    expect(refused([named('euler', 0.0001)], 47)).toEqual([null])
    // They share them.
    expect(refused([named('euler', 0.0001), named('verlet', 0.0001)], 26)).toEqual(['steps', 'steps'])
    expect(refused([named('euler', 0.0001), named('harmonic'), named('rk4', 0.001)], 20)).toEqual([null, null, null])
    // RK45 chooses its own, more of them the faster it swings.
    expect(refused([named('rk45')], 600)).toEqual([null])
    const fast = motionOf({ ...DEFAULTS, length: 0.001, gravity: 1000 })
    expect(refused([named('rk45')], 600, fast)).toEqual(['steps'])
    expect(refused([named('rk45')], 60, fast)).toEqual([null])
    for (const [theta0, velocity0] of [
      [0.1, 0],
      [2.6, 3],
      [0, 30],
    ] as const) {
      const until = 100
      const steps = approx
        .numerical('rk45')
        .of(new Pendulum({ theta0, velocity0, omega0: 1 }), until)
        .steps().t.length
      // As much work as four of the others each.
      expect(4 * steps).toBeLessThan(6 * until * (1 + velocity0))
    }
  })
})

describe('a window', () => {
  it('turns its page at the end', () => {
    expect(windowOf(8, 0)).toEqual({ from: 0, to: 8 })
    expect(windowOf(8, 7.999)).toEqual({ from: 0, to: 8 })
    expect(windowOf(8, 8)).toEqual({ from: 8, to: 16 })
    expect(windowOf(8, 600)).toEqual({ from: 600, to: 608 })
  })

  it('of one period is a few small ones where there is none', () => {
    const motion = swing(180)
    expect(spanOf({ span: 'T' }, motion)).toBe(4 * motion.smallPeriod)
  })
})

describe('the axis of the error', () => {
  it('is a logarithm where errors differ much, unless the reader chose', () => {
    const found = over(swing(150), [named('linear'), named('fourier', 4)], 8)
    expect(isLog(DEFAULTS, found)).toBe(true)
    expect(isLog({ errorAxis: 'linear' }, found)).toBe(false)
    expect(isLog(DEFAULTS, over(swing(150), [named('linear')], 8))).toBe(false)
  })

  it('is in degrees where there is no amplitude', () => {
    const turning = over(motionOf({ ...DEFAULTS, theta0: 0, velocity0: 7.5 }), [], 8)
    expect(inPercent(DEFAULTS, turning)).toBe(false)
    expect(errorFactor(false, turning.motion)).toBe(180 / Math.PI)
  })
})

it('the largest of samples is sharpened between them', () => {
  const times = Float64Array.from({ length: 101 }, (_, i) => i / 100)
  const top = largestOf(
    times.map((t) => 1 - (t - 0.4567) ** 2),
    times,
  )
  expect(top?.value).toBeCloseTo(1, 12)
  expect(top?.t).toBeCloseTo(0.4567, 10)
  expect(largestOf(Float64Array.of(Number.NaN), Float64Array.of(0))).toBeNull()
})

it.each(Object.keys(EXAMPLES) as ExampleName[])('the example %s is a link without faults', (name) => {
  expect(readLink(EXAMPLES[name]).faults).toEqual([])
  const { rows } = over(motionOf(exampleState(name, DEFAULTS)), exampleState(name, DEFAULTS).curves, 8)
  expect(rows.filter(({ refused }) => refused)).toEqual([])
})

it('the curves are those of the core', async () => {
  const { CURVE_NAMES } = await import('../src/curves')
  const known = [...approx.angle.entries, ...approx.numerical.entries].map(({ name }) => name)
  expect([...CURVE_NAMES].sort()).toEqual([...known].sort())
})
