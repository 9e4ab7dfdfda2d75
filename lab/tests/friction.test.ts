// Friction: what the page makes of the core's motions, and the section in pieces against the motion in one.

import { DampedPendulum, load, loadMotions } from 'libration'
import { beforeAll, describe, expect, it, vi } from 'vitest'
import { AveragedLaw } from '../src/model/averaged'
import { DampedMotion, dampedOf, type FrictionSetup } from '../src/model/friction'
import { Motion } from '../src/model/motion'
import { Section } from '../src/model/section'
import { radians } from '../src/number'
import { envelopeOf } from '../src/views/friction-charts'
import { sectionEnds, withinOneTurn } from '../src/views/friction-phase'
import { FRICTION_PRESETS } from '../src/views/friction-presets'

beforeAll(async () => {
  await load()
  await loadMotions()
})

const SETUP: FrictionSetup = {
  theta0: radians(60),
  velocity0: 0,
  length: 1,
  gravity: 9.81,
  linear: 0.03,
  quadratic: 0,
  dry: 0,
  torque: 0,
  drive: 0,
  driveFrequency: 2,
}
const of = (patch: Partial<FrictionSetup>, until = 60) => new DampedMotion({ ...SETUP, ...patch }, until)

describe('friction', () => {
  it('takes half of the energy at the time it says', () => {
    const motion = of({})
    const outcome = motion.outcome()
    if (outcome.kind !== 'halves') throw new Error(outcome.kind)
    expect(Math.abs(motion.energyAt(outcome.t) / motion.energyAt(0) - 0.5)).toBeLessThan(1e-12)
    // About ln 2 / 2γ, as small swings: a little longer, since it is slow at large angles.
    expect(Math.abs(outcome.t / (Math.log(2) / 0.06) - 1)).toBeLessThan(0.1)
    expect(of({ linear: 0.0001 }).outcome()).toMatchObject({ kind: 'keeps' })
    expect(of({ linear: 0 }).outcome()).toEqual({ kind: 'exact' })
  })

  it('has energies as parts of that at the top', () => {
    const motion = of({ linear: 0 })
    // sin² of half the release angle.
    expect(Math.abs(motion.energyAt(0) - 0.25)).toBeLessThan(1e-15)
    // The page takes those of a curve from the states, by the pendulum without friction.
    const times = Float64Array.of(0, 1, 2.5, 17)
    const damped = new DampedMotion({ ...SETUP, quadratic: 0.1 }, 60, times)
    const { total } = new Motion({ ...damped.setup, theta0: 0 }).energy(damped.track)
    for (const [i, t] of times.entries())
      expect(Math.abs((total[i] as number) - damped.energyAt(t))).toBeLessThan(1e-15)
  })

  it('stops a pendulum where the core says that it is held', () => {
    const motion = of({ linear: 0, dry: 0.3, theta0: radians(40) }, 30)
    const [rest] = dampedOf(motion.setup).rests(0, 30)
    expect(motion.outcome()).toEqual({ kind: 'stops', t: rest?.[0], theta: motion.at(30).theta })
    // Where it is held the pull is less than the friction.
    expect(9.81 * Math.abs(Math.sin(motion.at(30).theta))).toBeLessThan(0.3)
    expect(of({ theta0: 0.001, linear: 0, dry: 1 }).outcome()).toEqual({ kind: 'still' })
  })

  it('counts turns over the top, and knows whether it still turns', () => {
    const thrown = of({ theta0: 0, velocity0: 12, linear: 0.1, quadratic: 0.03 }, 30)
    expect([thrown.turnsOver, thrown.turnsStill]).toEqual([3, false])
    expect(of({ theta0: 0, velocity0: -12, linear: 0.1, quadratic: 0.03 }, 30).turnsOver).toBe(-3)
    expect(of({ theta0: 0, velocity0: 12, linear: 0.001 }, 5).turnsStill).toBe(true)
  })

  it('under a constant torque is aside, or goes round at the velocity that balances it', () => {
    const aside = of({ theta0: 0, linear: 0.5, torque: 2 }, 60).outcome()
    if (aside.kind !== 'settles') throw new Error(aside.kind)
    expect(Math.abs(aside.theta - Math.asin(2 / 9.81))).toBeLessThan(1e-9)
    const { until, ...setup } = FRICTION_PRESETS.josephson
    const round = new DampedMotion(setup, until).outcome()
    if (round.kind !== 'rotates') throw new Error(round.kind)
    // τ/2γ without gravity; gravity takes some of it.
    expect(round.velocity).toBeGreaterThan(0.8 * 2.4)
    expect(round.velocity).toBeLessThan(2.4)
  })

  it('joins turning points above and below', () => {
    const motion = of({}, 20)
    const [above, below] = envelopeOf(motion.turning)
    expect(above?.x[0]).toBe(0)
    expect(above?.y.every((theta, i, all) => theta > 0 && (i === 0 || theta < (all[i - 1] as number)))).toBe(true)
    expect(below?.y.every((theta) => theta < 0)).toBe(true)
    expect((above?.x.length ?? 0) + (below?.x.length ?? 0)).toBe(motion.turning.t.length)
    expect(envelopeOf({ t: Float64Array.of(0, 1), theta: Float64Array.of(1, -1) })).toEqual([])
  })

  it('has the averaged law beside its turning points: near them where friction is weak', () => {
    for (const [patch, within] of [
      [{}, 0.01],
      [{ velocity0: 2, theta0: -0.3 }, 0.01],
      [{ linear: 0.01, quadratic: 0.02, dry: 0.01 }, 0.02],
    ] as const) {
      const motion = of(patch, 20)
      const law = new AveragedLaw(motion, 6)
      while (!law.done) law.advance()
      const [above] = envelopeOf(motion.turning)
      for (let i = 0; i < law.count - 1; i++) {
        const t = law.t[i] as number
        const after = above?.x.findIndex((each) => each >= t) ?? -1
        if (after < 1) continue
        const [t0, t1] = [above?.x[after - 1] as number, above?.x[after] as number]
        const [y0, y1] = [above?.y[after - 1] as number, above?.y[after] as number]
        const joined = y0 + ((y1 - y0) * (t - t0)) / (t1 - t0)
        expect(Math.abs((law.above[i] as number) / joined - 1), JSON.stringify(patch)).toBeLessThan(within)
      }
      expect(law.below[0]).toBe(-(law.above[0] as number))
    }
    expect(new AveragedLaw(of({ torque: 1 }, 20), 6).done).toBe(true)
    // Dry friction stops it: the law ends there.
    const stopped = of({ linear: 0, dry: 0.5 }, 200)
    const rest = stopped.rests.at(-1)
    expect(rest?.[1]).toBe(stopped.reach)
    expect(rest?.[0]).toBeLessThan(stopped.reach)
    expect(new AveragedLaw(stopped, 6).t.at(-1)).toBeCloseTo(rest?.[0] as number, 12)
    // After three turns it swings about three.
    const thrown = new AveragedLaw(of({ theta0: 0, velocity0: 12, linear: 0.1, quadratic: 0.03 }, 30), 6)
    thrown.advance()
    expect(((thrown.above[0] as number) + (thrown.below[0] as number)) / 2).toBeCloseTo(6 * Math.PI, 10)
  })

  it('in the phase plane is lifted where it goes over the top', () => {
    const { x, y } = withinOneTurn(Float64Array.of(3, 3.2, 3.4), Float64Array.of(1, 2, 3))
    expect(Array.from(x, (each) => Math.round(each))).toEqual([172, -177, -177, -165])
    expect(Array.from(y)).toEqual([1, Number.NaN, 2, 3])
  })
})

describe('friction: a motion that takes long', () => {
  /** ω₀ = 1000/s. */
  const FAST = { ...SETUP, length: 0.001, gravity: 1000 }
  const finished = (motion: DampedMotion): DampedMotion => {
    while (!motion.done) motion.advance()
    return motion
  }

  it('is computed piece by piece, and is that of the core in one', () => {
    for (const [patch, until, pieces] of [
      [{ theta0: 3, linear: 0.05 }, 9, 8],
      // Held by dry friction in the second piece, and until the end.
      [{ theta0: 1, linear: 0.01, dry: 800 }, 9, 4],
      [{ theta0: 0.5, quadratic: 0.02, torque: 300 }, 9, 4],
      // Turned round and round, ever faster.
      [{ theta0: 0, length: 9.81, gravity: 9.81, linear: 0.01, torque: 100 }, 40, 8],
      [{ theta0: 0, linear: 0.2, drive: 900, driveFrequency: 300 }, 5, 2],
    ] as const) {
      const setup = { ...FAST, ...patch }
      const times = Float64Array.from({ length: 101 }, (_, i) => (until * i) / 100)
      const motion = new DampedMotion(setup, until, times)
      let count = 0
      for (; !motion.done; count++) motion.advance()
      expect(count, JSON.stringify(patch)).toBeGreaterThanOrEqual(pieces)
      const whole = dampedOf(setup)
      const near = (one: number, other: number) => Math.abs(one - other) < 1e-9 * (1 + Math.abs(other))
      const { theta, velocity } = whole.motion(times)
      expect(motion.track.theta.every((each, i) => near(each, theta[i] as number))).toBe(true)
      expect(motion.track.velocity.every((each, i) => near(each, velocity[i] as number))).toBe(true)
      // In any order, so that pieces are computed again.
      for (const i of [77, 3, 100, 50, 51, 0, 99]) {
        const at = motion.at(times[i] as number)
        expect([near(at.theta, theta[i] as number), near(at.velocity, velocity[i] as number)]).toEqual([true, true])
        expect(near(at.energy * 2 * (setup.gravity / setup.length), whole.energy(times[i] as number))).toBe(true)
      }
      const turning = whole.turningTimes(0, until)
      expect(motion.turning.t.length).toBe(turning.length)
      expect(motion.turning.t.every((t, i) => near(t, turning[i] as number))).toBe(true)
      expect(motion.turnsOver).toBe(whole.turns(until).n)
      const rests = whole.rests(0, until)
      expect(motion.rests.length).toBe(rests.length)
      expect(motion.rests.flat().every((t, i) => near(t, rests.flat()[i] as number))).toBe(true)
      whole.free()
      motion.free()
    }
  })

  it('loses half of its energy where the core says so', () => {
    const motion = finished(new DampedMotion({ ...FAST, theta0: 2, linear: 0.2 }, 12))
    const outcome = motion.outcome()
    if (outcome.kind !== 'halves') throw new Error(outcome.kind)
    const whole = dampedOf(motion.setup)
    expect(Math.abs(whole.energy(outcome.t) / whole.energy(0) - 0.5)).toBeLessThan(1e-9)
    whole.free()
  })

  it('asks the core for no more than a piece at once, whatever the rates are', () => {
    const reach = vi.spyOn(DampedPendulum.prototype, 'reach')
    for (const patch of [
      { ...FAST, theta0: 3 },
      { ...SETUP, linear: 0, drive: 1000, driveFrequency: 0.01 },
      { ...SETUP, linear: 0.01, torque: 1000, drive: 1000, driveFrequency: 1000 },
      { ...SETUP, linear: 100, quadratic: 100, dry: 1000, torque: -1000 },
    ]) {
      reach.mockClear()
      const motion = new DampedMotion(patch, 600)
      for (let i = 0; i < 4 && !motion.done; i++) motion.advance()
      const omega0 = Math.sqrt(patch.gravity / patch.length)
      // What a motion at its fastest goes through in the time asked for.
      for (const [time] of reach.mock.calls) {
        expect(time * omega0).toBeLessThan(6000)
        expect(time * time * (Math.abs(patch.torque) + patch.drive) * (patch.linear === 0 ? 1 : 0)).toBeLessThan(12_000)
      }
      expect(reach.mock.calls.length).toBeGreaterThan(0)
      motion.free()
    }
    reach.mockRestore()
  })

  it('is content with what it has when it is ended', () => {
    const times = Float64Array.of(0, 1, 599)
    const motion = new DampedMotion({ ...FAST, theta0: 3 }, 600, times)
    motion.advance()
    motion.end()
    expect([motion.done, motion.reach > 1, motion.reach < 10]).toEqual([true, true, true])
    expect(Array.from(motion.track.theta, Number.isNaN)).toEqual([false, false, true])
    expect(motion.at(599).theta).toBeNaN()
    expect(motion.outcome().kind).toBe('keeps')
  })
})

describe('friction: the section of a driven pendulum', () => {
  const section = (drive: number, most = 400, skip = 100): Section => {
    const { until: _, ...setup } = FRICTION_PRESETS.one
    const made = new Section({ ...setup, drive }, most, skip)
    while (!made.done) made.advance()
    return made
  }

  it('ends where the core follows a motion no further, with the points that it has', () => {
    const { until: _, ...setup } = FRICTION_PRESETS.one
    const period = (2 * Math.PI) / setup.driveFrequency
    const made = new Section(setup, 400, 0)
    const whole = section(0.9, 40, 0)
    made.advance()
    const short = vi.spyOn(DampedPendulum.prototype, 'reach').mockReturnValue(3.5 * period)
    made.advance()
    short.mockRestore()
    expect([made.stopped, made.done, made.count]).toEqual([true, true, 19])
    expect(made.angles.subarray(0, 19)).toEqual(whole.angles.subarray(0, 19))
    expect(whole.stopped).toBe(false)
  })

  it('draws rounding no larger than it is', () => {
    const [low, high] = sectionEnds(Float64Array.of(1.5, 1.5 + 1e-15), 8)
    expect(high - low).toBe(2)
    expect((low + high) / 2).toBeCloseTo(1.5, 12)
    const [least, most] = sectionEnds(Float64Array.of(-3, 1), 8)
    expect([least, most].map((each) => each.toFixed(2))).toEqual(['-3.48', '1.48'])
    expect(sectionEnds(new Float64Array(), 1).map((each) => each.toFixed(2))).toEqual(['-1.24', '1.24'])
  })

  it('has the points of one long motion', () => {
    const made = section(0.9, 40, 0)
    const whole = dampedOf(made.setup)
    const period = (2 * Math.PI) / made.setup.driveFrequency
    for (const n of [1, 16, 17, 40]) {
      expect(Math.abs((made.angles[n - 1] as number) - whole.turns(n * period).angle)).toBeLessThan(1e-10)
      expect(Math.abs((made.velocities[n - 1] as number) - whole.motion(n * period).velocity)).toBeLessThan(1e-10)
    }
    // A point of another phase of the drive is another one.
    expect(Math.abs((made.angles[39] as number) - whole.turns(40.01 * period).angle)).toBeGreaterThan(1e-4)
  })

  it('repeats every period, every second one, or never: the cases of Baker and Gollub', () => {
    expect([0.9, 1.07, 1.5].map((drive) => section(drive).repeats)).toEqual([1, 2, null])
    const chaos = section(1.5)
    const cells = new Set(
      Array.from(chaos.angles, (angle, i) => `${angle.toFixed(2)} ${(chaos.velocities[i] as number).toFixed(2)}`),
    )
    expect(cells.size).toBeGreaterThan(150)
  })

  it('cuts a period in which the pendulum is too fast for a piece, and has the same points', () => {
    const setup = { ...SETUP, linear: 0.4, drive: 40, driveFrequency: 0.05 }
    const reach = vi.spyOn(DampedPendulum.prototype, 'reach')
    const made = new Section(setup, 3, 0)
    while (!made.done) made.advance()
    // More than a piece in each of three periods.
    expect(reach.mock.calls.length).toBeGreaterThanOrEqual(6)
    reach.mockRestore()
    const whole = dampedOf(setup)
    for (const n of [1, 2, 3]) {
      const [turns, motion] = [whole.turns((n * 2 * Math.PI) / 0.05), whole.motion((n * 2 * Math.PI) / 0.05)]
      expect(Math.abs((made.angles[n - 1] as number) - turns.angle)).toBeLessThan(1e-6)
      expect(Math.abs((made.velocities[n - 1] as number) - motion.velocity)).toBeLessThan(1e-6)
    }
  })

  it('is filled piece by piece, with what was asked for', () => {
    const { until: _, ...setup } = FRICTION_PRESETS.chaos
    const made = new Section(setup, 50, 10)
    made.advance()
    expect([made.count, made.done, made.repeats]).toEqual([6, false, null])
    while (!made.done) made.advance()
    expect(made.count).toBe(50)
  })
})
