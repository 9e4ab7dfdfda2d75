// Drawing: scales and their inverses, ticks, paths with gaps, marks where a curve leaves the frame, clothes.

import { describe, expect, it } from 'vitest'
import { usualCurve } from '../src/curves'
import { clothesOf } from '../src/draw/clothes'
import { extent, gaps, leavings, pathOf } from '../src/draw/curve'
import { angleAt, spot } from '../src/draw/pendulum'
import { hatchedRegions } from '../src/draw/plot'
import {
  degreeTicks,
  linearScale,
  logScale,
  roundTicks,
  symmetricLogScale,
  symmetricLogTicks,
  tickDecimals,
} from '../src/draw/scale'
import { energyTicks } from '../src/views/energy'

const numbers = (...values: number[]) => Float64Array.from(values)

describe('ticks of the energy', () => {
  it('are two at least', () => {
    expect(roundTicks(93.25, 93.55, 2)).toEqual([93.4])
    expect(energyTicks([93.25, 93.55], 2)).toEqual([93.3, 93.5])
    expect(energyTicks([0, 104], 3)).toEqual([0, 50, 100])
    for (let low = 0; low < 1; low += 0.01) expect(energyTicks([93 + low, 93.3 + low], 2).length).toBeGreaterThan(1)
  })
})

describe('a scale', () => {
  it.each([
    ['linear', linearScale([-3, 5], [0, 400]), [-3, 0.1, 5]],
    ['log', logScale([1e-5, 200], [300, 0]), [1e-5, 1, 200]],
    ['symmetric log', symmetricLogScale(0.1, [-300, 300], [130, 0]), [-300, -0.05, 0, 200]],
  ] as const)('%s goes there and back', (_, scale, values) => {
    for (const value of values) expect(scale.invert(scale(value))).toBeCloseTo(value, 9)
  })

  it('has its ends at the ends', () => {
    const scale = symmetricLogScale(0.1, [-300, 300], [130, 0])
    expect([scale(-300), scale(0), scale(300)].map((each) => Number(each.toFixed(9)))).toEqual([130, 65, 0])
  })
})

describe('ticks', () => {
  it('are round and not too many', () => {
    expect(roundTicks(0, 8, 9)).toEqual([0, 1, 2, 3, 4, 5, 6, 7, 8])
    expect(roundTicks(0, 8, 5)).toEqual([0, 2, 4, 6, 8])
    for (let most = 2; most < 10; most++) expect(roundTicks(-190.3, 77, most).length).toBeLessThanOrEqual(most)
  })

  it('of angles are those of a protractor', () => {
    expect(degreeTicks(-190, 190, 7)).toEqual([-180, -90, 0, 90, 180])
    expect(degreeTicks(-570, 215, 7)).toEqual([-540, -360, -180, 0, 180])
    expect(degreeTicks(-50, 50, 7)).toEqual([-45, -30, -15, 0, 15, 30, 45])
  })

  it('of an error are powers of ten on both sides of zero', () => {
    expect(symmetricLogTicks(0.1, 300, 7)).toEqual([-100, -10, -1, 0, 1, 10, 100])
    expect(symmetricLogTicks(1e-9, 300, 7)).toHaveLength(7)
  })

  it('have as many decimals as they differ in', () => {
    expect(
      [
        [1, 2],
        [0.5, 1],
        [0.25, 0.5],
      ].map(tickDecimals),
    ).toEqual([0, 1, 2])
  })
})

describe('a path', () => {
  const sx = linearScale([0, 3], [0, 300])
  const sy = linearScale([0, 1], [100, 0])

  it('goes through the points in tenths of a pixel', () => {
    expect(pathOf({ x: numbers(0, 1, 2), y: numbers(0, 0.5, 0.2) }, sx, sy)).toBe('M0 1000l1000-500 1000 300')
  })

  /** Corners of a path in tenths of a pixel. */
  const cornersOf = (d: string) => {
    const steps = [...d.matchAll(/-?\d+/g)].map(Number)
    let [x, y] = [0, 0]
    return Array.from({ length: steps.length / 2 }, (_, i) => {
      x += steps[2 * i] as number
      y += steps[2 * i + 1] as number
      return { x, y }
    })
  }
  /** Greatest distance, upwards or downwards, of points from the line through corners, in tenths of a pixel. */
  const farthest = (corners: readonly { x: number; y: number }[], points: readonly { x: number; y: number }[]) => {
    let [at, most] = [0, 0]
    for (const { x, y } of points) {
      while (at < corners.length - 2 && (corners[at + 1]?.x ?? 0) < x) at++
      const [a, b] = [corners[at], corners[at + 1]]
      if (!a || !b) return Number.NaN
      most = Math.max(most, Math.abs(a.y + ((b.y - a.y) * (x - a.x)) / (b.x - a.x) - y))
    }
    return most
  }

  it.each([
    ['a wave', (t: number) => 0.5 + 0.45 * Math.cos(5 * t)],
    ['a quick wave', (t: number) => 0.5 + 0.45 * Math.cos(60 * t)],
    ['a corner', (t: number) => Math.abs(t - 1.5) / 3],
    ['a jump', (t: number) => (t < 1 ? 0.1 : 0.9)],
    ['a straight line', (t: number) => t / 3],
  ])('leaves out points of %s only where the line passes them within a tenth of a pixel', (_, of) => {
    const x = Float64Array.from({ length: 1201 }, (_, i) => i / 400)
    const y = x.map(of)
    const corners = cornersOf(pathOf({ x, y }, sx, sy))
    const points = Array.from(x, (t, i) => ({ x: 10 * sx(t), y: 10 * sy(y[i] as number) }))
    expect(corners.length).toBeLessThan(x.length)
    // Half a tenth for the line and half a tenth, along both axes, for the rounding of its ends.
    const steep = Math.max(...points.map(({ y }, i) => Math.abs(y - (points[i - 1]?.y ?? y)))) / 2.5
    expect(farthest(corners, points)).toBeLessThanOrEqual(1 + steep / 2)
    // A line that lacks one more corner would be seen.
    if (corners.length > 2) {
      const without = corners.filter((_, i) => i !== corners.length >> 1)
      expect(farthest(without, points)).toBeGreaterThan(1)
    }
  })

  it('has all points where it goes back', () => {
    const loop = { x: numbers(0, 1, 2, 1, 0), y: numbers(0, 0.5, 1, 0.5, 0) }
    expect(pathOf(loop, sx, sy)).toBe('M0 1000l2000-1000-1000 500-1000 500')
  })

  it('is broken where there is no value', () => {
    expect(pathOf({ x: numbers(0, 1, 2, 3), y: numbers(0, Number.NaN, 1, 1) }, sx, sy)).toBe('M0 1000M2000 0l1000 0')
  })

  it('is drawn again for another scale', () => {
    const points = { x: numbers(0, 1), y: numbers(0, 1) }
    const first = pathOf(points, sx, sy)
    expect(pathOf(points, sx, linearScale([0, 2], [100, 0]))).not.toBe(first)
    expect(pathOf(points, sx, sy, 0.5)).not.toBe(first)
    expect(pathOf(points, sx, sy)).toBe(first)
  })

  it('keeps infinite and enormous values out of the text', () => {
    const d = pathOf({ x: numbers(0, 1, 2, 3), y: numbers(0, 1e300, Number.POSITIVE_INFINITY, 0) }, sx, sy)
    expect(d).not.toMatch(/NaN|Infinity|e/)
  })
})

describe('a curve that leaves the frame', () => {
  it('is marked on its way out, at each side', () => {
    const points = { x: numbers(0, 1, 2, 3, 4, 5), y: numbers(0, 2, 0, -2, -3, 0) }
    expect(leavings(points, -1, 1)).toEqual([
      { x: 1, up: true },
      { x: 3, up: false },
    ])
  })

  it('is marked where it comes in if it begins outside, or at its beginning if it does not', () => {
    expect(leavings({ x: numbers(0, 1, 2, 3), y: numbers(-5, -3, 0, 4) }, -1, 1)).toEqual([
      { x: 2, up: false },
      { x: 3, up: true },
    ])
    expect(leavings({ x: numbers(0, 1), y: numbers(5, 4) }, -1, 1)).toEqual([{ x: 0, up: true }])
  })

  it('is not marked while it stays', () => expect(leavings({ x: numbers(0, 1), y: numbers(0, 1) }, -1, 1)).toEqual([]))
})

describe('where there is no value', () => {
  const x = numbers(0, 1, 2, 3, 4)
  it('a region begins and ends', () => {
    expect(gaps({ x, y: numbers(Number.NaN, 1, 1, Number.NaN, Number.NaN) })).toEqual([
      [0, 1],
      [3, 4],
    ])
  })
  it('regions of two curves are one where they touch', () => {
    const a = { x, y: numbers(1, Number.NaN, 1, 1, 1) }
    const b = { x, y: numbers(1, 1, Number.NaN, 1, 1) }
    expect(hatchedRegions([a, b])).toEqual([[1, 3]])
  })
  it('does not count for the extent', () =>
    expect(extent(numbers(1, Number.NaN, -2, Number.POSITIVE_INFINITY))).toEqual([-2, 1]))
})

it('two of a family differ by their dash', () => {
  expect(clothesOf([usualCurve('rk45'), usualCurve('euler'), usualCurve('rk4'), usualCurve('verlet')])).toEqual([
    'c-integrator',
    'c-euler',
    'c-integrator second',
    'c-integrator third',
  ])
})

it('the bob is where its angle is', () => {
  for (let degrees = -179; degrees < 180; degrees += 7) {
    const angle = (degrees * Math.PI) / 180
    const { x, y } = spot(angle)
    expect(angleAt(x, y)).toBeCloseTo(angle, 12)
  }
})
