// The worksheet: thirty seeds are thirty sheets, on every machine the same, and every answer is that of an AGM written here.

import { beforeAll, describe, expect, it } from 'vitest'
import { Draws } from '../src/handouts/draws'
import { type Answers, answersOf, type Exercises, exercisesOf } from '../src/handouts/exercises'
import { completedModel, type Model, openModel } from '../src/model'

let model: Model
beforeAll(async () => {
  await openModel()
  model = await completedModel()
})

const SEEDS = Array.from({ length: 30 }, (_, i) => i + 1)
const radians = (degrees: number) => (degrees * Math.PI) / 180

/** The arithmetic-geometric mean: 2/π of it is 1/K, and T/T₀ = 1/agm(1, cos θ₀/2). */
function agm(a: number, b: number): number {
  return Math.abs(a - b) < 1e-15 * a ? a : agm((a + b) / 2, Math.sqrt(a * b))
}
const ratio = (degrees: number) => 1 / agm(1, Math.cos(radians(degrees) / 2))
const smallPeriod = (centimetres: number, g = 9.81) => 2 * Math.PI * Math.sqrt(centimetres / 100 / g)

/** The largest relative difference of the answers from those computed here; infinite where a word is another. */
function difference(exercises: Exercises, answers: Answers): number {
  const { small, large, error, measured, portrait, top, energy, reading } = exercises
  const short = smallPeriod(small.length)
  const theta = radians(error.angle)
  const first = 1 + theta ** 2 / 16
  const uncorrected = (4 * Math.PI ** 2 * (measured.length / 100)) / (measured.time / 1000) ** 2
  const omega0 = (centimetres: number) => Math.sqrt(9.81 / (centimetres / 100))
  const above = (degrees: number) => Math.sin(radians(degrees) / 2) ** 2
  const pairs: [number, number][] = [
    [answers.small, short],
    [answers.large.ratio, ratio(large.angle)],
    [answers.large.period, short * ratio(large.angle)],
    [1 + answers.error.linear, 1 / ratio(error.angle)],
    [1 + answers.error.first, first / ratio(error.angle)],
    [answers.measured.uncorrected, uncorrected],
    [answers.measured.corrected, uncorrected * ratio(measured.angle) ** 2],
    [answers.top, 2 * omega0(top.length) * Math.cos(radians(top.angle) / 2)],
    [answers.energy.potential, above(energy.at)],
    [answers.energy.velocity, 2 * omega0(energy.length) * Math.sqrt(above(energy.angle) - above(energy.at))],
    [answers.reading.period, smallPeriod(reading.length) * ratio(reading.angle)],
    [answers.reading.length, reading.length / 100],
  ]
  for (const [i, { angle, velocity }] of portrait.points.entries()) {
    const energyRatio = above(angle) + (velocity / 20 / omega0(portrait.length)) ** 2
    if (answers.portrait[i]?.turns !== energyRatio > 1) return Number.POSITIVE_INFINITY
  }
  return pairs.reduce((most, [found, wanted]) => {
    const off = Math.abs(found / wanted - 1)
    return Number.isNaN(off) ? Number.POSITIVE_INFINITY : Math.max(most, off)
  }, 0)
}

describe('thirty seeds', () => {
  it('are thirty sheets that differ in most of their numbers', () => {
    const sheets = SEEDS.map((seed) => exercisesOf(model, seed))
    expect(new Set(sheets.map((sheet) => JSON.stringify(sheet))).size).toBe(30)
    // Not one number alone: lengths and angles of the exercises come from long lists.
    for (const pick of [(each: Exercises) => each.small.length, (each: Exercises) => each.top.length])
      expect(new Set(sheets.map(pick)).size).toBeGreaterThan(20)
  })

  it('have the answers of an independent computation', () => {
    for (const seed of SEEDS) {
      const exercises = exercisesOf(model, seed)
      expect(difference(exercises, answersOf(model, exercises)), String(seed)).toBeLessThan(1e-12)
    }
  })

  it('do not have those of a spoiled one', () => {
    const exercises = exercisesOf(model, 1)
    const answers = answersOf(model, exercises)
    expect(difference(exercises, { ...answers, top: answers.top * (1 + 1e-9) })).toBeGreaterThan(1e-10)
    expect(difference(exercises, { ...answers, small: Number.NaN })).toBe(Number.POSITIVE_INFINITY)
    const turned = answers.portrait.map((each) => ({ ...each, turns: !each.turns }))
    expect(difference(exercises, { ...answers, portrait: turned })).toBe(Number.POSITIVE_INFINITY)
    expect(difference({ ...exercises, large: { angle: exercises.large.angle + 5 } }, answers)).toBeGreaterThan(1e-3)
  })

  it('can be read: angles within the charts, a swing and a turn in the portrait, g that is near', () => {
    for (const seed of SEEDS) {
      const exercises = exercisesOf(model, seed)
      const { measured, portrait } = answersOf(model, exercises)
      expect(exercises.large.angle).toBeLessThanOrEqual(170)
      expect(new Set(portrait.map(({ turns }) => turns)).size).toBe(2)
      expect(Math.abs(measured.corrected - 9.805)).toBeLessThan(0.06)
      expect(measured.uncorrected).toBeLessThan(measured.corrected)
      expect(exercises.energy.at).toBeLessThan(exercises.energy.angle)
    }
  })
})

describe('the numbers of a seed', () => {
  it('are whole 32-bit arithmetic: the same here as anywhere', () => {
    // By Python's integers: the finalizer, then xorshift 13 17 5.
    const draws = new Draws(1)
    expect(Array.from({ length: 6 }, () => draws.between(0, 999_999))).toEqual([
      573325, 206358, 670935, 597714, 618023, 533350,
    ])
    expect(exercisesOf(model, 7).small).toEqual({ length: 113, angle: 9 })
  })

  it('reach both ends and no further', () => {
    const draws = new Draws(5)
    const drawn = Array.from({ length: 2000 }, () => draws.between(-10, 10, 5))
    expect([...new Set(drawn)].sort((a, b) => a - b)).toEqual([-10, -5, 0, 5, 10])
  })
})
