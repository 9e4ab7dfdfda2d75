// The errors against the step: the orders of the textbooks, and a row that is none.

import { beforeAll, describe, expect, it } from 'vitest'
import { convergence, ORDERS, slopeOf } from '../src/convergence'
import { type Model, openModel } from '../src/model'
import { radians } from '../src/number'

let model: Model

beforeAll(async () => {
  model = await openModel()
})

const setup = { theta0: radians(150), velocity0: 0, length: 1, gravity: 9.81 }

describe('the error against the step', () => {
  it.each([
    ['a swing', setup],
    ['a rotation', { ...setup, theta0: 0, velocity0: 7.5 }],
  ])('of %s falls with the order of each scheme', (_, start) => {
    const { schemes, steps } = convergence(model.motion(start))
    for (const { name, errors, slope } of schemes) {
      expect(Math.abs(slope - ORDERS[name]), name).toBeLessThan(0.1)
      expect(errors).toHaveLength(steps.length)
    }
  })

  it('has no slope where there is no error', () => {
    const { schemes } = convergence(model.motion({ ...setup, theta0: 0 }))
    for (const { slope } of schemes) expect(slope).toBeNaN()
  })

  it('is told from another order', () => {
    const steps = Float64Array.of(0.1, 0.05)
    expect(slopeOf(steps, Float64Array.of(0.2, 0.1))).toBeCloseTo(1, 12)
    expect(slopeOf(steps, Float64Array.of(0.4, 0.1))).toBeCloseTo(2, 12)
    // Rounding is left out.
    expect(slopeOf(Float64Array.of(0.2, 0.1, 0.05), Float64Array.of(0.4, 0.1, 1e-14))).toBeCloseTo(2, 12)
  })
})
