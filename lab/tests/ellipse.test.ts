// The Functions view: lengths in the ellipse are the core's functions, its x is the chord, and m = 0 is the circle and the cosine.

import { beforeAll, describe, expect, it } from 'vitest'
import { ellipseAngle, ellipseSpot } from '../src/draw/ellipse'
import {
  amplitudeOfModulus,
  amplitudeOfParameter,
  graphOf,
  heightOf,
  instantAt,
  placeAt,
  type Swing,
  shorteningOf,
  swingOf,
  timeAtAngle,
} from '../src/ellipse'
import { completedModel, type Model, openModel } from '../src/model'
import { radians } from '../src/number'

let model: Model
beforeAll(async () => {
  await openModel()
  model = await completedModel()
})

const at = (theta0: number, velocity0 = 0, length = 1) => model.motion({ theta0, velocity0, length, gravity: 9.81 })
const swing = (...start: Parameters<typeof at>): Swing => {
  const made = swingOf(model, at(...start))
  if (!made) throw new Error('it does not swing')
  return made
}

const toward = (phi: number, parameter: Swing['parameter']) => placeAt(Math.cos(phi), Math.sin(phi), parameter)

describe('lengths in the ellipse', () => {
  it.each([0.001, 1, 45, 90, 150, 170, 179, 179.99])(
    'at %s° are sn, cn and dn of the core, and x is the chord',
    (angle) => {
      for (const length of [1, 0.37]) {
        const one = swing(radians(angle), 0, length)
        for (let i = 0; i <= 40; i++) {
          const now = instantAt(model, one, (one.motion.period * i) / 17)
          expect(now.difference).toBeLessThan(1e-12)
          expect(Math.abs(now.chord - now.projection)).toBeLessThan(1e-12 * length)
          const { x, y, r } = now.place
          expect(x * x + one.parameter.mc * y * y).toBeCloseTo(1, 12)
          expect(Math.hypot(x, y) / r).toBeCloseTo(1, 13)
        }
      }
    },
  )

  it.each([
    [-1, 0],
    [0.4, 2],
    [-2.5, -1],
    [2, -3],
  ])('of a motion begun at %s rad with %s rad/s too', (theta0, velocity0) => {
    const one = swing(theta0, velocity0)
    expect(one.turned).toBeLessThanOrEqual(0)
    expect(one.motion.theta(one.turned)).toBeCloseTo(one.motion.thetaMax, 12)
    for (const t of [0, 0.2, 1, 3.3]) {
      const now = instantAt(model, one, t)
      expect(Math.abs(now.chord - now.projection)).toBeLessThan(1e-12)
      expect(now.difference).toBeLessThan(1e-12)
    }
  })

  it('have u as the length ∫ r dφ, by Simpson', () => {
    const one = swing(radians(150))
    for (const t of [0.1, 0.4, 0.8]) {
      const { u, phi } = instantAt(model, one, t)
      const n = 2000
      let sum = 0
      for (let i = 0; i <= n; i++) {
        const weight = i === 0 || i === n ? 1 : i % 2 === 1 ? 4 : 2
        sum += weight * toward((phi * i) / n, one.parameter).r
      }
      expect((sum * phi) / (3 * n)).toBeCloseTo(u, 10)
    }
  })
})

describe('m = 0', () => {
  it('is the circle and the cosine', () => {
    const one = swing(0)
    expect([one.parameter.m, one.parameter.mc, heightOf(one.parameter)]).toEqual([0, 1, 1])
    expect(one.quarter).toBeCloseTo(Math.PI / 2, 15)
    const { x, sn, u, dn, cosine } = graphOf(model, one, 0, one.motion.period)
    u.forEach((value, i) => {
      expect(x[i]).toBeCloseTo(Math.cos(value), 13)
      expect(sn[i]).toBeCloseTo(Math.sin(value), 13)
      expect(dn[i]).toBe(1)
      expect(cosine[i]).toBeCloseTo(Math.cos(value), 13)
    })
    const now = instantAt(model, one, 0.3)
    expect([now.place.r, now.chord, now.projection]).toEqual([1, 0, 0])
  })
})

it('modulus and parameter are amplitudes', () => {
  for (const m of [0, 1e-9, 0.2, 0.933, 0.999999]) {
    expect(at(amplitudeOfParameter(m)).energyRatio).toBeCloseTo(m, 14)
    expect(at(amplitudeOfModulus(Math.sqrt(m))).energyRatio).toBeCloseTo(m, 14)
  }
})

it('y is drawn shorter above 155° only, and then said', () => {
  const of = (angle: number) => shorteningOf(swing(radians(angle)).parameter)
  expect([10, 150, 154, 155].map(of)).toEqual([1, 1, 1, 2])
  expect([165, 170, 178, 179.9].map(of)).toEqual([2, 5, 20, 500])
  for (const angle of [10, 150, 155, 170, 179, 179.9]) {
    const { parameter } = swing(radians(angle))
    const height = heightOf(parameter)
    const spec = { height, shortening: shorteningOf(parameter) }
    for (let phi = -3; phi < 3; phi += 0.3) {
      const place = toward(phi, parameter)
      const point = ellipseSpot({ ...place, ...spec })
      expect(point.y).toBeGreaterThan(10)
      expect(point.y).toBeLessThan(478)
      expect(ellipseAngle(point.x, point.y, spec)).toBeCloseTo(phi, 6)
    }
  }
})

it('the point of the ellipse is moved by its polar angle', () => {
  const one = swing(radians(150))
  const { period } = one.motion
  for (const page of [0, 3]) {
    const graph = graphOf(model, one, page * period, (page + 1) * period)
    for (const part of [0.02, 0.11, 0.3, 0.55, 0.9]) {
      const t = (page + part) * period
      const { place } = instantAt(model, one, t)
      expect(timeAtAngle(graph, Math.atan2(place.y, place.x))).toBeCloseTo(t, 3)
    }
  }
})

it('there is no ellipse for what does not swing', () => {
  for (const motion of [at(0, 7.5), at(Math.PI), at(0, 2 * Math.sqrt(9.81))]) expect(swingOf(model, motion)).toBeNull()
})
