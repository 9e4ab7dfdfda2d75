// Springs: what the page computes beside the core, and the numbers of the page against the vectors and the command line.

import { readFileSync } from 'node:fs'
import { CubicQuintic, Duffing, load, loadMotions, Pendulum } from 'libration'
import { beforeAll, describe, expect, it } from 'vitest'
import { roundUp } from '../src/draw/scale'
import { companionOf, SpringOrbit } from '../src/model/spring'
import { equilibria, type Force, forceOf, potential } from '../src/model/spring-force'
import { levelCurves, levelThrough } from '../src/model/spring-levels'
import { within } from '../src/study'
import { springAxes, springSpan } from '../src/views/spring-axes'
import { SPRING_PRESETS } from '../src/views/spring-presets'

beforeAll(async () => {
  await load()
  await loadMotions()
})

const duffing = (p: number, q: number) => forceOf('duffing', { p, r: 7, q, c: 7, s: 7 })
const even = (p: number, r: number, q: number, c: number) => forceOf('helmholtz-duffing', { p, r, q, c, s: 7 })
const quintic = (p: number, q: number, s: number) => forceOf('cubic-quintic', { p, r: 7, q, c: 7, s })

const FORCES: readonly Force[] = [
  duffing(1, 1),
  duffing(1, -0.5),
  duffing(-1, 0.5),
  duffing(-2, -1),
  quintic(1, -4, 3),
  quintic(1, 1, -1),
  quintic(-1, 0, 0.25),
  quintic(0, 0, 1),
  even(1, 0.5, 0.2, 0),
  even(-1, 0, 1, 0.125),
  even(1, -1, 0, 0),
  even(1, 0.3, -0.5, 0.1),
  even(0, 0, 1, 2),
]

const orbit = (force: Force, u0: number, velocity0 = 0) => new SpringOrbit(force, u0, velocity0)

describe('springs', () => {
  it('have a potential that is the energy at rest by the core', () => {
    for (const force of FORCES)
      for (const u of [-2.3, -0.4, 0, 0.7, 1.9]) {
        const { p, r, q, c, s } = force
        const terms = [c, p / 2, r / 3, q / 4, 0, s / 6].map((each, i) => Math.abs(each * u ** (i + 1)))
        const scale = terms.reduce((sum, each) => sum + each, 0)
        expect(Math.abs(potential(force, u) - orbit(force, u).energy)).toBeLessThanOrEqual(4e-16 * scale)
      }
    // A potential with another coefficient is found.
    expect(Math.abs(potential(duffing(1, 1.0000001), 1.9) - orbit(FORCES[0] as Force, 1.9).energy)).toBeGreaterThan(
      1e-8,
    )
  })

  it('stay at their equilibria, and swing about the stable ones at the rate of the curvature', () => {
    for (const force of FORCES) {
      for (const { u, stable, rate } of equilibria(force)) {
        const { u: after } = orbit(force, u).at(0.1)
        expect(Math.abs(after - u)).toBeLessThan(1e-12)
        if (!stable || rate === 0) continue
        const near = orbit(force, u + 1e-5)
        expect(Math.abs(near.period / ((2 * Math.PI) / rate) - 1)).toBeLessThan(1e-4)
      }
    }
    expect(equilibria(FORCES[4] as Force).map(({ stable }) => stable)).toEqual([true, false, true, false, true])
    expect(equilibria(FORCES[2] as Force).map(({ u }) => u)).toEqual([-Math.SQRT2, 0, Math.SQRT2])
  })

  it('with even powers have one to three equilibria, or none, and such where two or three meet', () => {
    const places = (force: Force) => equilibria(force).map(({ u, stable }) => [Number(u.toFixed(9)), stable])
    expect(places(even(1, -1, 0, 0))).toEqual([
      [0, true],
      [1, false],
    ])
    expect(places(even(2, -3, 1, 0))).toEqual([
      [0, true],
      [1, false],
      [2, true],
    ])
    // (u − 1)²(u + 2), (u − 1)³, u², u² + 1, a force that is the same everywhere.
    expect(places(even(-3, 0, 1, -2))).toEqual([
      [-2, true],
      [1, false],
    ])
    expect(places(even(3, -3, 1, 1))).toEqual([[1, true]])
    expect(places(even(0, 1, 0, 0))).toEqual([[0, false]])
    expect(places(even(0, 1, 0, -1))).toEqual([])
    expect(places(even(0, 0, 0, 1))).toEqual([])
    expect(places(even(2, 0, 0, 3))).toEqual([[1.5, true]])
    // The third is beyond what doubles hold.
    expect(places(even(1e-6, 1e6, 1e-300, 1e6)).length).toBe(2)
  })

  it('have the numbers of the vectors', () => {
    const text = readFileSync(new URL('../../reference/vectors/duffing.csv', import.meta.url), 'utf8')
    const [head = '', ...rows] = text.split('\n').filter((line) => line !== '' && !line.startsWith('#'))
    const names = head.split(',')
    const hex = (cell: string): number => {
      const match = /^(-?)0x([01])\.([0-9a-f]*)p([+-]\d+)$/.exec(cell)
      if (!match) return Number(cell.replace('inf', 'Infinity'))
      const [, sign, whole, fraction = '', power] = match
      return Number(`${sign}1`) * Number(BigInt(`0x${whole}${fraction}`)) * 2 ** (Number(power) - 4 * fraction.length)
    }
    let compared = 0
    for (const row of rows) {
      const cells = row.split(',')
      const of = (name: string) => hex(cells[names.indexOf(name)] ?? '')
      if (
        ![of('p'), of('q'), of('u0'), of('velocity0')].every((value) => Math.abs(value) < 100 && Math.abs(value) > 1e-6)
      )
        continue
      const found = orbit(duffing(of('p'), of('q')), of('u0'), of('velocity0'))
      const near = (got: number, truth: number) =>
        Number.isFinite(truth) ? Math.abs(got / truth - 1) < 1e-13 : got === truth
      expect(near(found.period, of('period_hi')) && near(found.escapeTime, of('escape_hi')), row).toBe(true)
      compared++
    }
    expect(compared).toBeGreaterThan(300)
  })

  it('by their presets are what they are called', () => {
    const regimes = Object.fromEntries(
      Object.entries(SPRING_PRESETS).map(([name, { spring, u0, springVelocity0, ...force }]) => {
        return [name, orbit(forceOf(spring, force), u0, springVelocity0).regime]
      }),
    )
    expect(regimes).toEqual({
      hardening: 'libration',
      softening: 'libration',
      escape: 'escape',
      saddles: 'heteroclinic',
      inside: 'well',
      on: 'homoclinic',
      outside: 'libration',
      beam: 'libration',
      tilted: 'well',
      helmholtz: 'homoclinic',
      bistable: 'libration',
      quintic: 'escape',
    })
    expect(orbit(duffing(1, -0.5), 1.6).name).toBe('softening')
  })

  it('as companion are the tangent of half the angle', () => {
    const start = companionOf(2, 0.5, 1.3, 9.81)
    if (!start) throw new Error('no companion')
    const pendulum = new Pendulum({ theta0: 2, velocity0: 0.5, length: 1.3, gravity: 9.81 })
    const found = orbit(duffing(start.p, start.q), start.u0, start.springVelocity0)
    expect(Math.abs(found.period / pendulum.period - 1)).toBeLessThan(1e-13)
    expect(Math.abs(found.at(0.4).u - Math.tan(pendulum.theta(0.4) / 2))).toBeLessThan(1e-12)
    expect(companionOf(Math.PI, 0, 1, 9.81)).toBe(null)
  })

  it('draw the curve that the core moves on', () => {
    for (const [force, u0, v0] of [
      [FORCES[0], 1.5, 0],
      [FORCES[2], 1.9, 0],
      [FORCES[2], 2.1, 0],
      [FORCES[4], 0.5, 0.01],
      [FORCES[1], 1.6, -0.02],
      [FORCES[1], 0, 1],
      [FORCES[2], 2, 0],
      [FORCES[8], 1, 0],
      [FORCES[9], -1.25, 0],
      [FORCES[10], -0.5, 0],
      [FORCES[10], 1.5, -0.5],
    ] as const) {
      const found = orbit(force as Force, u0, v0)
      const { reach } = springAxes(found)
      const levels = levelThrough(found, reach)
      expect(levels.length).toBeGreaterThan(0)
      const points = levels.flatMap(({ x, y }) => Array.from(x, (u, i) => [u, y[i] as number] as const))
      const end = Math.min(springSpan(found), 0.999 * found.escapeTime)
      for (let i = 0; i <= 60; i++) {
        const { u, velocity } = found.at((end * i) / 60)
        if (!(Math.abs(u) < reach)) continue
        const fastest = Math.max(...points.map(([, y]) => Math.abs(y)))
        const nearest = Math.min(...points.map(([x, y]) => Math.hypot((x - u) / reach, (y - velocity) / fastest)))
        expect(nearest, `${u0} ${v0} ${i}`).toBeLessThan(0.03)
      }
    }
  })

  it('have separatrices that meet at the unstable equilibria', () => {
    const force = FORCES[2] as Force
    const [left, right] = levelCurves(force, 0, 2.5, [0])
    expect([left?.x[0], right?.x[0]].map((u) => Number(u?.toFixed(6)))).toEqual([-2, 0])
    expect(levelCurves(force, -1, 2.5)).toEqual([])
  })

  it('are shown on round axes, an escape a little beyond its time', () => {
    expect([0.9, 1, 1.01, 1.9, 7, 0.023].map(roundUp).map((each) => Number(each.toPrecision(3)))).toEqual([
      1, 1, 1.2, 2, 8, 0.025,
    ])
    const escaping = orbit(duffing(1, -0.5), 1.6)
    expect(springSpan(escaping)).toBe(1.25 * escaping.escapeTime)
    const { times } = springAxes(escaping)
    expect(times[0]).toBeLessThan(0)
    expect(times[1]).toBeGreaterThan(3 * 1.6)
    const falling = springAxes(orbit(duffing(1, -0.5), -1.6))
    expect(falling.times).toEqual([-times[1], -times[0]])
    expect(within(7.5, 2)).toBe(1.5)
  })

  it('agree with the same numbers of the package', () => {
    expect(orbit(duffing(1, -0.5), 1.2).period).toBe(new Duffing({ u0: 1.2, p: 1, q: -0.5 }).period)
    const beam = new Duffing({ u0: 1, p: 1, q: 0.2, r: 0.5, c: 0.25 })
    expect(orbit(even(1, 0.5, 0.2, 0.25), 1).period).toBe(beam.period)
    expect(orbit(even(1, 0, -0.5, 0), 1.2).period).toBe(orbit(duffing(1, -0.5), 1.2).period)
    expect(orbit(quintic(1, -4, 3), 0.5).period).toBe(new CubicQuintic({ u0: 0.5, p: 1, q: -4, s: 3 }).period)
  })

  it('have charts with a scale however small what they show is', () => {
    for (const u0 of [5e-324, 1e-310, 1e-300, 1e-160, 1e-100, 0])
      for (const force of [
        duffing(1e-6, 1e-6),
        duffing(1, -0.5),
        duffing(0, 1),
        duffing(0, 0),
        even(1, 1e-6, 0, 0),
        even(0, 0, 0, 1),
      ]) {
        const { reach, fastest, lowest, highest, times } = springAxes(orbit(force, u0))
        for (const range of [reach, fastest, highest - lowest, times[1] - times[0]])
          expect([u0, Number.isFinite(1000 / range), range > 0]).toEqual([u0, true, true])
      }
  })
})
