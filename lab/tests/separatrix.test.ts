// The separatrix of the page: the start whose velocity is 2ω₀cos(θ₀/2) as a double has it, which for the core is next to it.
// Truth: θ = 4 arctan(exp(ω₀t + c)) − π, by another route than the core's.

import { beforeAll, describe, expect, it } from 'vitest'
import { type Model, openModel } from '../src/model'

let model: Model
beforeAll(async () => {
  model = await openModel(undefined)
})

const place = { length: 1, gravity: 9.81 }
const omega0 = Math.sqrt(9.81)

describe('the separatrix', () => {
  it.each([0, 0.7, -1.3, 2.5, -3.1])('through %s rad is followed to the top', (theta0) => {
    for (const sign of [1, -1]) {
      const velocity0 = sign * model.motion({ theta0, velocity0: 0, ...place }).separatrixVelocity(theta0)
      const motion = model.motion({ theta0, velocity0, ...place })
      expect(motion.regime).toBe('separatrix')
      expect(motion.period).toBe(Number.POSITIVE_INFINITY)
      expect(motion.energyRatio).toBe(1)
      const c = Math.log(Math.tan((sign * theta0 + Math.PI) / 4))
      for (const t of [0, 0.3, 1, 4, 20, 300]) {
        const truth = sign * (4 * Math.atan(Math.exp(omega0 * t + c)) - Math.PI)
        expect(Math.abs(motion.theta(t) - truth)).toBeLessThan(1e-13)
        const fast = (sign * 2 * omega0) / Math.cosh(omega0 * t + c)
        expect(Math.abs(motion.velocity(t) - fast)).toBeLessThan(1e-12)
      }
      const { theta, velocity } = motion.sample(Float64Array.of(0.3, 4))
      expect([theta[0], velocity[1]]).toEqual([motion.theta(0.3), motion.velocity(4)])
    }
  })

  it('is at (0, 2ω₀) as written in a link, and not a little beside it', () => {
    const at = (velocity0: number) => model.motion({ theta0: 0, velocity0, ...place })
    expect(at(2 * omega0).regime).toBe('separatrix')
    expect(at(2 * omega0 * (1 + 1e-13)).regime).toBe('rotation')
    expect(at(2 * omega0 * (1 - 1e-13)).regime).toBe('libration')
    expect(at(-2 * omega0).theta(100)).toBeLessThan(-Math.PI + 1e-12)
  })

  it('refuses what needs a period, and compares the others with the true motion', () => {
    const motion = model.motion({ theta0: 0, velocity0: 2 * omega0, ...place })
    expect(motion.solution({ name: 'harmonic', on: true }, 8)).toEqual({ refused: 'separatrix' })
    const linear = motion.solution({ name: 'linear', on: true }, 8)
    if ('refused' in linear) throw new Error('linear is for every motion')
    const times = Float64Array.of(20)
    const { error } = linear.compared(times, motion.sample(times), false)
    expect(error[0]).toBeCloseTo(linear.theta(20) - motion.theta(20), 14)
  })

  it('does not take the place of swings and turns', () => {
    for (const velocity0 of [0, 1, 6.2, 6.3, 100]) {
      const motion = model.motion({ theta0: 0.1, velocity0, ...place })
      expect(motion.asGiven).toBe(true)
      expect(['libration', 'rotation']).toContain(motion.regime)
    }
  })
})
