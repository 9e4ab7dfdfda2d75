// The Period view on the numbers of its acceptance table: error in % of T/T₀ by amplitude, to the printed digit.

import { beforeAll, describe, expect, it } from 'vitest'
import { placedLabels } from '../src/draw/labels'
import { linearScale } from '../src/draw/scale'
import { completedModel, type Model, openModel } from '../src/model'
import { radians } from '../src/number'
import { AMPLITUDES, nearestOf, periodAt, periodCurve, periodResults, TABLE_ROWS } from '../src/period-study'
import { PERIOD_KINDS, PERIOD_NAMES, periodRows, readPeriod, USUAL_PERIODS, withPeriod } from '../src/periods'
import { formulaMarkup } from '../src/views/formula-list'

let model: Model
beforeAll(async () => {
  await openModel()
  model = await completedModel()
})

// Amplitudes 10, 30, 60, 90, 120, 150, 170, 179 degrees; from 40-digit arithmetic (agm, sine series), as printed.
const TABLE: readonly (readonly [string, string])[] = [
  ['linear', '-0.190 -1.711 -6.819 -15.279 -27.160 -43.253 -59.006 -74.366'],
  ['bernoulli', '-0.0003 -0.027 -0.433 -2.214 -7.191 -18.944 -36.450 -58.729'],
  ['series:4', '0 -0.0005 -0.031 -0.367 -2.173 -9.399 -25.074 -49.985'],
  ['kidd-fogg', '0.0001 0.0075 0.129 0.751 3.011 11.544 38.860 174.407'],
  ['molina', '0.0000 0.0035 0.061 0.355 1.436 5.577 18.842 79.327'],
  ['ganley-parwani', '0 -0.0005 -0.011 -0.078 -0.428 -2.442 -10.687 -35.118'],
  ['lima-arun', '0 0.0025 0.043 0.249 0.977 3.485 9.579 22.611'],
  ['agm:1', '-0.0001 -0.0075 -0.129 -0.743 -2.881 -9.841 -24.584 -49.175'],
  ['agm:2', '0 0 0 -0.0014 -0.022 -0.282 -2.255 -14.236'],
  ['belendez', '0 0 0 -0.0014 -0.022 -0.282 -2.255 -14.236'],
  ['cromer', '-11.67 -11.09 -9.23 -6.537 -3.574 -1.089 -0.141 -0.0016'],
  ['salas-26', '0 -0.0006 -0.042 -0.545 -3.537 -15.397 -35.983 -59.721'],
  ['salas-27', '0 0 -0.0002 -0.017 -0.423 -5.720 -24.503 -52.051'],
  ['salas-28', '0 0 0 -0.0005 -0.049 -2.091 -17.294 -46.847'],
]
const EXACT = '1.001907 1.017409 1.073182 1.180341 1.372881 1.762204 2.439363 3.901065'

/** As many decimals as printed; 0 is less than half of the fourth. */
function printed(value: number, as: string): string {
  if (as === '0') return Math.abs(value) < 0.00005 ? '0' : value.toFixed(4)
  return value.toFixed(as.split('.')[1]?.length ?? 0)
}

describe('the table of the period chart', () => {
  it('has the amplitudes of the acceptance table as its short rows', () => {
    expect(TABLE_ROWS.map((i) => AMPLITUDES[i])).toEqual([10, 30, 60, 90, 120, 150, 170, 179])
    for (let degrees = 0; degrees <= 180; degrees++) expect(AMPLITUDES.includes(degrees)).toBe(true)
  })

  it('exact', () => {
    const { ratio } = periodCurve(model, 'exact')
    expect(TABLE_ROWS.map((i) => (ratio[i] as number).toFixed(6)).join(' ')).toBe(EXACT)
  })

  it.each(TABLE)('%s', (key, row) => {
    const { error, ratio, size } = periodCurve(model, key)
    const exact = periodCurve(model, 'exact').ratio
    row.split(' ').forEach((as, k) => {
      const i = TABLE_ROWS[k] as number
      expect(printed(100 * (error[i] as number), as)).toBe(as)
      expect((ratio[i] as number) / (exact[i] as number) - 1).toBeCloseTo(error[i] as number, 12)
      expect(size[i]).toBe(Math.abs(error[i] as number))
      expect(periodAt(model, key, radians(AMPLITUDES[i] as number)).error).toBe(error[i])
    })
  })
})

describe('the formulas', () => {
  it('are those of the registry, in its order', () => {
    expect(PERIOD_NAMES).toEqual(model.periods.map(({ name }) => name).filter((name) => name !== 'exact'))
  })

  it('take the N that the registry takes', () => {
    for (const { name, orders } of model.periods) {
      if (name === 'exact') continue
      const own = PERIOD_KINDS[name as keyof typeof PERIOD_KINDS]
      const { usual: _, ...ours } = { usual: 0, ...('orders' in own ? own.orders : {}) }
      expect([name, ours]).toEqual([name, orders ?? {}])
    }
  })

  it('wear different clothes', () => {
    expect(new Set(PERIOD_NAMES.map((name) => PERIOD_KINDS[name].clothes)).size).toBe(PERIOD_NAMES.length)
  })

  it('are switched one by one, in the order of the registry', () => {
    expect(withPeriod([], 'cromer', true)).toEqual(['cromer'])
    expect(withPeriod(['cromer'], 'agm:3', true)).toEqual(['agm:3', 'cromer'])
    expect(withPeriod(['agm:3', 'cromer'], 'agm:4', true)).toEqual(['agm:4', 'cromer'])
    expect(withPeriod(null, 'linear', false)).toHaveLength(USUAL_PERIODS.length - 1)
    expect(periodRows(null).filter(({ on }) => on)).toHaveLength(USUAL_PERIODS.length)
    for (const name of PERIOD_NAMES)
      expect(readPeriod(name)).toEqual(periodRows([]).find((row) => row.name === name)?.key)
  })

  it('are sorted by the size of their error at the amplitude, and the nearest is named', () => {
    const results = periodResults(model, periodRows(null), radians(150), 'error')
    const sizes = results.map(({ error }) => Math.abs(error))
    expect(sizes).toEqual([...sizes].sort((a, b) => a - b))
    expect(nearestOf(results)?.name).toBe('belendez')
    expect(nearestOf(periodResults(model, periodRows(null), radians(178), 'registry'))?.name).toBe('cromer')
    expect(nearestOf(periodResults(model, periodRows([]), 1, 'registry'))).toBeNull()
  })

  it('have their stated range where the author states one', () => {
    const at = (key: string, degrees: number) => periodCurve(model, key).stated?.[AMPLITUDES.indexOf(degrees)]
    expect(Number.isNaN(at('salas-27', 120) as number)).toBe(false)
    expect(at('salas-27', 121)).toBeNaN()
    expect(at('salas-26', 71)).toBeNaN()
    expect(periodCurve(model, 'lima-arun').stated).toBeNull()
  })

  it('are written with their indices', () =>
    expect(formulaMarkup('1 − θ_max²/16, a_(n+1)')).toBe('1 − _θ_{max}²/16, _a_{n+1}'))
})

describe('names beside curves', () => {
  const x = Float64Array.from({ length: 11 }, (_, i) => i)
  const room = {
    sx: linearScale([0, 10], [0, 500]),
    sy: linearScale([0, 10], [200, 0]),
    width: 500,
    height: 200,
    letter: 7,
    line: 15,
  }

  it('touch no curve, no other name and not the frame', () => {
    const curves = [1, 3, 4, 8].map((level) => ({ x, y: x.map((at) => level + 0.1 * at), text: `curve ${level}` }))
    const placed = placedLabels(curves, room)
    expect(placed.length).toBeGreaterThan(2)
    placed.forEach(({ x: left, y, text }, k) => {
      const half = (text.length * 7) / 2
      for (const curve of curves) {
        for (let at = left - half; at <= left + half; at += 5) {
          const value = room.sx.invert(at)
          const level = (curve.y[0] as number) + 0.1 * value
          expect(Math.abs(room.sy(level) - y)).toBeGreaterThan(7)
        }
      }
      placed.slice(k + 1).forEach((other) => {
        expect(Math.abs(other.x - left) > half || Math.abs(other.y - y) > 15).toBe(true)
      })
      expect([left - half > 0, left + half < 500, y > 8, y < 192]).toEqual([true, true, true, true])
    })
  })

  it('are left out where there is no room', () => {
    const dense = Array.from({ length: 30 }, (_, i) => ({ x, y: x.map(() => i / 3), text: `curve ${i}` }))
    expect(placedLabels(dense, room)).toEqual([])
  })
})
