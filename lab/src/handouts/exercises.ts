// The exercises of a worksheet: their numbers from the seed, and their answers from the core.
//
// Numbers are whole in the units of the sheet: degrees, centimetres, tenths of rad/s, hundredths of a second.

import { remember } from '../memory'
import type { Model, Motion } from '../model'
import { radians } from '../number'
import { Draws } from './draws'

/** In m/s². */
export const GRAVITY = 9.81

export interface Point {
  readonly name: 'P' | 'Q' | 'R'
  /** In degrees, and tenths of rad/s. */
  readonly angle: number
  readonly velocity: number
}

export interface Exercises {
  readonly small: { readonly length: number; readonly angle: number }
  readonly large: { readonly angle: number }
  readonly error: { readonly angle: number }
  /** The time is that of ten swings. */
  readonly measured: { readonly length: number; readonly angle: number; readonly time: number }
  readonly portrait: { readonly length: number; readonly points: readonly Point[] }
  readonly top: { readonly length: number; readonly angle: number }
  readonly energy: { readonly length: number; readonly angle: number; readonly at: number }
  readonly reading: { readonly length: number; readonly angle: number; readonly until: number }
}

const motionOf = (model: Model, length: number, angle: number, velocity = 0, gravity = GRAVITY): Motion =>
  model.motion({ theta0: radians(angle), velocity0: velocity / 10, length: length / 100, gravity })

/** How far from the separatrix a point of the portrait must be, as a part of the energy at the top: to be seen on paper. */
const CLEAR = 0.12

/** Three points, of which at least one swings and one turns over. */
function points(draws: Draws, model: Model, length: number): readonly Point[] {
  const drawn = (name: Point['name'], turns: boolean | null): Point => {
    for (;;) {
      const angle = draws.between(-160, 160, 10)
      const velocity = draws.between(-90, 90, 5)
      const { energyRatio } = motionOf(model, length, angle, velocity)
      const clear = Math.abs(energyRatio - 1) > CLEAR && energyRatio > CLEAR && energyRatio < 1.8
      if (clear && (turns === null || energyRatio > 1 === turns)) return { name, angle, velocity }
    }
  }
  const first = draws.between(0, 1) === 1
  return [drawn('P', first), drawn('Q', !first), drawn('R', null)]
}

export const exercisesOf = remember((model: Model, seed: number): Exercises => {
  const draws = new Draws(seed)
  const small = { length: draws.between(25, 180), angle: draws.between(4, 9) }
  const large = { angle: draws.between(70, 165, 5) }
  const error = { angle: draws.between(25, 85, 5) }
  const length = draws.between(40, 150)
  const angle = draws.between(30, 80, 5)
  // Gravity between the equator and the poles.
  const { period } = motionOf(model, length, angle, 0, draws.between(978, 983) / 100)
  const measured = { length, angle, time: Math.round(1000 * period) }
  const wide = draws.between(50, 120, 5)
  const portrait = { length: wide, points: points(draws, model, wide) }
  const top = { length: draws.between(30, 150), angle: draws.between(5, 120, 5) }
  const from = draws.between(60, 150, 10)
  const energy = { length: draws.between(30, 150), angle: from, at: draws.between(10, from - 30, 5) }
  const seen = { length: draws.between(30, 180, 5), angle: draws.between(70, 150, 5) }
  const reading = { ...seen, until: 2 * Math.ceil(motionOf(model, seen.length, seen.angle).period) }
  return { small, large, error, measured, portrait, top, energy, reading }
})

export interface Answers {
  /** In s. */
  readonly small: number
  readonly large: { readonly ratio: number; readonly period: number }
  /** Relative: formula over exact, minus 1. */
  readonly error: { readonly linear: number; readonly first: number }
  /** In m/s². */
  readonly measured: { readonly uncorrected: number; readonly corrected: number }
  readonly portrait: readonly { readonly name: Point['name']; readonly turns: boolean }[]
  /** In rad/s. */
  readonly top: number
  /** Potential energy over that at the top; velocity in rad/s. */
  readonly energy: { readonly potential: number; readonly velocity: number }
  /** In s and m. */
  readonly reading: { readonly period: number; readonly length: number }
}

export const answersOf = remember((model: Model, exercises: Exercises): Answers => {
  const { small, large, error, measured, portrait, top, energy, reading } = exercises
  const smallMotion = motionOf(model, small.length, small.angle)
  const largeMotion = motionOf(model, small.length, large.angle)
  const at = Float64Array.of(radians(error.angle))
  const off = (name: string) => model.periodError(name, at)[0] as number
  // A period goes as 1/√g: with g = 1 it is what the measured one is to be compared with.
  const unit = motionOf(model, measured.length, measured.angle, 0, 1)
  const time = measured.time / 1000
  const falling = motionOf(model, energy.length, energy.angle)
  const here = Float64Array.of(radians(energy.at))
  return {
    small: smallMotion.smallPeriod,
    large: { ratio: largeMotion.period / largeMotion.smallPeriod, period: largeMotion.period },
    error: { linear: off('linear'), first: off('bernoulli') },
    measured: { uncorrected: (unit.smallPeriod / time) ** 2, corrected: (unit.period / time) ** 2 },
    portrait: portrait.points.map(({ name, angle, velocity }) => ({
      name,
      turns: motionOf(model, portrait.length, angle, velocity).regime === 'rotation',
    })),
    top: motionOf(model, top.length, top.angle).separatrixVelocity(radians(top.angle)),
    energy: {
      potential: falling.energyAt(radians(energy.at), 0).potential,
      velocity: falling.levelVelocity(here, falling.energyRatio)[0] as number,
    },
    reading: { period: motionOf(model, reading.length, reading.angle).period, length: reading.length / 100 },
  }
})

/** The pendulum of the portrait and that of the chart over time. */
export function motionsOf(
  model: Model,
  { portrait, reading }: Exercises,
): { readonly portrait: Motion; readonly reading: Motion } {
  return { portrait: motionOf(model, portrait.length, 90), reading: motionOf(model, reading.length, reading.angle) }
}
