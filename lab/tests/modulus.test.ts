// Modulus, parameter and modular angle: each from each, and the mistake of one for the other as the period shows it.

import { beforeAll, expect, it } from 'vitest'
import { MODULUS_NAMES, mistakes, modulusOf } from '../src/handouts/modulus'
import { completedModel, type Model, openModel } from '../src/model'
import { radians } from '../src/number'

let model: Model
beforeAll(async () => {
  await openModel()
  model = await completedModel()
})

const agm = (a: number, b: number): number => (Math.abs(a - b) < 1e-15 * a ? a : agm((a + b) / 2, Math.sqrt(a * b)))
/** K by the parameter. */
const completeK = (m: number) => Math.PI / 2 / agm(1, Math.sqrt(1 - m))

it.each([
  [20, 4.03],
  [45, 8.1],
  [90, 12.5],
])('k given for m makes the period of a swing of %d° longer by %d %%', (angle, percent) => {
  const modulus = modulusOf('theta0', radians(angle))
  const { kForM, mForK } = mistakes(model, modulus)
  expect(100 * kForM).toBeCloseTo(percent, percent === 4.03 ? 2 : 1)
  const { k, m } = modulus
  expect(kForM).toBeCloseTo(completeK(k) / completeK(m) - 1, 12)
  expect(mForK).toBeCloseTo(completeK(m * m) / completeK(m) - 1, 12)
  expect(mForK).toBeLessThan(0)
})

it('each gives the others', () => {
  for (const angle of [0, 1e-6, 1, 30, 100, 179]) {
    const wanted = modulusOf('theta0', radians(angle))
    for (const name of MODULUS_NAMES) {
      const found = modulusOf(name, name === 'theta0' ? radians(angle) : wanted[name])
      expect(found.k).toBeCloseTo(wanted.k, 12)
      expect(found.m).toBeCloseTo(wanted.m, 12)
      expect(found.alpha).toBeCloseTo(wanted.alpha, 7)
      expect(found.m + found.mc).toBeCloseTo(1, 14)
    }
  }
})
