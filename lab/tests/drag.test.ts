// What a drag does in each frame: studies into the arrays of the frame before, and paths of their own numbers.

import { beforeAll, describe, expect, it } from 'vitest'
import { pathOf } from '../src/draw/curve'
import { linearScale } from '../src/draw/scale'
import { readLink } from '../src/link'
import { type Model, openModel } from '../src/model'
import { radians } from '../src/number'
import { study } from '../src/study'

const { state } = readLink('#L=1m&g=9.81&curves=linear,fourier:4,taylor:8,rk4:0.01')
let model: Model
beforeAll(async () => {
  model = await openModel()
})

const dragged = (degrees: number, quick: boolean) =>
  study(model.motion({ ...state, theta0: radians(degrees) }), state.curves, 0, 8, quick)

describe('a study while a control is held', () => {
  it('has the numbers of one that is not, frame after frame', () => {
    for (const degrees of [150, 20, 149]) {
      const quick = dragged(degrees, true)
      const whole = dragged(degrees, false)
      expect(quick.exact).toEqual(whole.exact)
      expect(quick.total).toEqual(whole.total)
      expect(quick.parts()).toEqual(whole.parts())
      expect(quick.shown.length).toBe(4)
      quick.shown.forEach(({ track, error, energy, numerical }, i) => {
        const same = whole.shown[i]
        if (numerical) {
          expect(track.theta).toEqual(same?.track.theta)
          expect(energy).toEqual(same?.energy)
        }
        // A plain difference while it must be quick: off by the rounding of the larger of both angles.
        const off = track.theta.map((theta, at) => {
          const size = Math.max(1, Math.abs(theta))
          return Math.max(
            Math.abs(theta - (same?.track.theta[at] ?? Number.NaN)) / size,
            Math.abs((error[at] as number) - (same?.error[at] ?? Number.NaN)) / size,
          )
        })
        expect(Math.max(...off)).toBeLessThan(1e-14)
      })
    }
  })

  it('uses the same memory again, and is drawn with its own numbers all the same', () => {
    const [sx, sy] = [linearScale([0, 8], [0, 600]), linearScale([-4, 4], [200, 0])]
    const path = (degrees: number) => {
      const { times, exact } = dragged(degrees, true)
      return { memory: exact.theta.buffer, d: pathOf({ x: times, y: exact.theta }, sx, sy) }
    }
    dragged(100, true)
    const [first, second, third] = [path(150), path(60), path(150)]
    expect(second.memory).toBe(first.memory)
    expect(second.d).not.toBe(first.d)
    expect(third.d).toBe(first.d)
  })
})
