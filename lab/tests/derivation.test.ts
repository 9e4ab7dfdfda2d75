// Story 8, in numbers: every displayed equality holds for 1,000 pendulums of all kinds, and a side that is spoiled is seen.

import { beforeAll, describe, expect, it } from 'vitest'
import { type Equality, sidesOf, TOLERANCE } from '../src/derivation/equality'
import { EQUALITIES } from '../src/derivation/lessons'
import { Moment } from '../src/derivation/moment'
import { carlsonF, legendreF, mean, slope, around } from '../src/derivation/second-route'
import { completedModel, type Model, openModel, type Setup } from '../src/model'
import { radians } from '../src/number'

let model: Model
beforeAll(async () => {
  await openModel()
  model = await completedModel()
})

/** A fixed generator: mulberry32. */
function generator(seed: number): () => number {
  let state = seed
  return () => {
    state = (state + 0x6d2b79f5) | 0
    let z = Math.imul(state ^ (state >>> 15), state | 1)
    z = (z + Math.imul(z ^ (z >>> 7), z | 61)) ^ z
    return ((z ^ (z >>> 14)) >>> 0) / 2 ** 32
  }
}

interface State {
  readonly setup: Setup
  readonly t: number
}

/** Ends of the ranges and of the kinds of motion, then whatever comes. */
function states(count: number): State[] {
  const random = generator(8)
  const between = (low: number, high: number) => low + (high - low) * random()
  const out: State[] = []
  const put = (theta0: number, velocity0 = 0, length = 1, gravity = 9.81, t = between(0, 20)) =>
    out.push({ setup: { theta0, velocity0, length, gravity }, t })
  for (const angle of [0, 1e-6, 1, 60, 90, 150, 171, 179, 179.999, 180, -1, -90, -150, -180])
    for (const t of [0, 0.7, 13.3]) put(radians(angle), 0, 1, 9.81, t)
  for (const velocity of [-100, -7, -1e-6, 1e-6, 0.3, 6.264, 6.265, 7.5, 100]) for (const angle of [0, 1, -2.5, 3]) put(angle, velocity)
  for (const [length, gravity] of [
    [0.001, 0.001],
    [0.001, 1000],
    [1000, 0.001],
    [1000, 1000],
  ] as const)
    for (const [theta0, velocity0] of [
      [2, 0],
      [2, 1],
      [0, 100],
    ] as const)
      put(theta0, velocity0, length, gravity, 5 * Math.sqrt(length / gravity))
  // On the separatrix as doubles have it, and beside it.
  for (let i = 0; i < 120; i++) {
    const theta0 = between(-3, 3)
    const [length, gravity] = [between(0.1, 3), between(1, 25)]
    const velocity = model.motion({ theta0, velocity0: 0, length, gravity }).separatrixVelocity(theta0)
    const away = i % 3 === 0 ? 1 : 1 + (i % 2 === 0 ? 1 : -1) * 10 ** between(-9, -2)
    put(theta0, (i % 4 < 2 ? 1 : -1) * velocity * away, length, gravity, between(0, 8))
  }
  while (out.length < count) {
    const kind = Math.floor(random() * 3)
    const small = kind === 0 ? 10 ** between(-5, 0) : 1
    put(
      Math.PI * small * between(-1, 1),
      kind === 2 ? between(-12, 12) : between(-2, 2) * small * (random() < 0.4 ? 0 : 1),
      10 ** between(-1, 0.5),
      between(1, 25),
      random() < 0.1 ? 0 : between(0, 100),
    )
  }
  return out
}

const momentOf = ({ setup, t }: State): Moment => new Moment(model, model.motion(setup), t)

/** Where an equality does not hold, as lines. */
function wrong(equalities: readonly Equality[], all: readonly Moment[]): string[] {
  const lines: string[] = []
  for (const now of all) {
    for (const equality of equalities) {
      const sides = sidesOf(equality, now)
      if (sides && !(sides.apart <= TOLERANCE))
        lines.push(`${equality.id}: ${sides.left} ${sides.right} ${now.regime} ${JSON.stringify(now.motion.setup)} ${now.t}`)
    }
  }
  return lines
}

describe('story 8: 1,000 pendulums', () => {
  let all: readonly Moment[]
  beforeAll(() => {
    all = states(1000).map(momentOf)
  })

  it('of all kinds', () => {
    expect(all.length).toBe(1000)
    for (const kind of ['rest', 'libration', 'separatrix', 'rotation'])
      expect([kind, all.filter(({ regime }) => regime === kind).length >= 4]).toEqual([kind, true])
  })

  it('every displayed equality holds to 1e-9', () => {
    expect(wrong(EQUALITIES, all)).toEqual([])
  })

  it('a side that is spoiled by 1e-8 is seen, whichever it is', () => {
    for (const equality of EQUALITIES) {
      const asked = all.filter((now) => sidesOf(equality, now) !== null)
      expect([equality.id, asked.length >= 30]).toEqual([equality.id, true])
      const some = asked.filter(({ regime }) => regime !== 'rest').slice(-40)
      for (const side of ['left', 'right'] as const) {
        // As large as what the difference is measured against, so that it is seen at the zeros too.
        const spoiled = {
          ...equality,
          [side]: (now: Moment) => {
            const size = Math.max(Math.abs(equality[side](now)), equality.size?.(now) ?? 0)
            return equality[side](now) + 1e-8 * size
          },
        }
        expect([equality.id, side, wrong([spoiled], some).length]).toEqual([equality.id, side, some.length])
      }
    }
  })
})

describe('the second route', () => {
  it('is Legendre’s integral: am of the core undoes it, and at 90° it is K', () => {
    for (const mc of [1, 0.9, 0.5, 1e-3, 1e-9]) {
      const parameter = { m: 1 - mc, mc }
      expect(carlsonF(0, mc, 1) / model.completeK(parameter)).toBeCloseTo(1, 14)
      for (const phi of [-3, -1.6, -0.4, 1e-9, 0.7, 1.5, 2.9]) {
        const am = model.jacobi(Float64Array.of(legendreF(Math.sin(phi), Math.cos(phi), parameter)), parameter).am[0]
        expect((am ?? 0) / phi).toBeCloseTo(1, 10)
      }
    }
  })

  it('has the mean of Gauss and the slope of a sine', () => {
    expect(mean(1, Math.SQRT2)).toBeCloseTo(1.1981402347355923, 15)
    expect(slope(around(0.3, 1 / 64).map(Math.sin), 1 / 64)).toBeCloseTo(Math.cos(0.3), 13)
  })
})
