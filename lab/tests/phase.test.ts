// The phase portrait: a start is where the hand is, the axis stays, a rotation is counted on, the separatrix can be hit.

import { beforeAll, describe, expect, it } from 'vitest'
import { grainOf, linearScale } from '../src/draw/scale'
import { type Model, openModel } from '../src/model'
import { domainOf } from '../src/views/orbit-angle'
import { reachOf, startAt } from '../src/views/phase'
import { levelCurves } from '../src/views/portrait'

let model: Model
beforeAll(async () => {
  model = await openModel(undefined)
})

const place = { length: 1, gravity: 9.81 }
const at = (theta0: number, velocity0: number) => model.motion({ theta0, velocity0, ...place })

describe.each([
  [588, 480],
  [280, 304],
  [1100, 700],
])('a start in a plot of %s by %s pixels', (width, height) => {
  const sx = linearScale([-180, 180], [0, width])

  it('is within a pixel of the hand, and so is its curve', () => {
    const reach = reachOf(at(1, 0), [{ theta0: 1, velocity0: 0 }])
    const sy = linearScale([-reach, reach], [height, 0])
    for (let i = 0; i < 200; i++) {
      const x = ((i * 97) % 199) * (width / 199)
      const y = ((i * 61) % 197) * (height / 197)
      const start = startAt(at(1, 0), x, y, sx, sy)
      const point = { x: sx((start.theta0 * 180) / Math.PI), y: sy(start.velocity0) }
      expect(Math.hypot(point.x - x, point.y - y)).toBeLessThanOrEqual(1)
      expect(reachOf(at(1, 0), [start])).toBe(reach)
      const motion = at(start.theta0, start.velocity0)
      if (motion.regime === 'rest') continue
      const loops = levelCurves(motion, motion.energyRatio, motion.thetaMax)
      const nearest = Math.min(
        ...loops.flatMap((loop) =>
          Array.from(loop.x, (angle, k) => {
            const a = { x: sx(angle), y: sy(loop.y[k] as number) }
            const b = { x: sx(loop.x[k + 1] ?? angle), y: sy(loop.y[k + 1] ?? (loop.y[k] as number)) }
            const along = { x: b.x - a.x, y: b.y - a.y }
            const length = along.x ** 2 + along.y ** 2 || 1
            const part = Math.min(1, Math.max(0, ((x - a.x) * along.x + (y - a.y) * along.y) / length))
            return Math.hypot(a.x + part * along.x - x, a.y + part * along.y - y)
          }),
        ),
      )
      expect(nearest).toBeLessThanOrEqual(1)
    }
  })

  it('next to the separatrix is on it', () => {
    const reach = reachOf(at(0, 0), [{ theta0: 0, velocity0: 0 }])
    const sy = linearScale([-reach, reach], [height, 0])
    for (const degrees of [-120, -40, 0, 75, 150]) {
      for (const sign of [1, -1]) {
        const top = sign * at(0, 0).separatrixVelocity((degrees * Math.PI) / 180)
        const start = startAt(at(0, 0), sx(degrees), sy(top) + 0.4, sx, sy)
        expect(at(start.theta0, start.velocity0).regime).toBe('separatrix')
      }
    }
  })
})

it('a grain is below a pixel and a short number', () => {
  expect([0.61, 0.0375, 1.3, 1, 0.2].map(grainOf)).toEqual([0.5, 0.02, 1, 1, 0.2])
})

it("Salas's rotation of m = 1.419 is counted on: 5.1116 rad at 2.1 s", () => {
  const motion = model.motion({ theta0: 0.6, velocity0: 3, length: 1, gravity: 1.69 })
  expect(motion.regime).toBe('rotation')
  expect(motion.energyRatio.toFixed(3)).toBe('1.419')
  expect(motion.theta(2.1).toFixed(4)).toBe('5.1116')
})

it('the axis of the angle is the circle for wide swings, and goes on with a rotation', () => {
  expect(domainOf(Float64Array.of(-2.6, 2.6))).toEqual([-190, 190])
  const [low, high] = domainOf(Float64Array.of(0, 2 * Math.PI))
  expect([low, high].map(Math.round)).toEqual([-18, 378])
})
