// What the Period view shows, as plain numbers: the exact ratio T/T₀, that of every formula, and their relative errors.
//
// The amplitudes are half degrees, closer together towards 180° where the exact period has no limit. All values are the core's.

import type { Model } from './model'
import { radians } from './number'
import type { PeriodRow } from './periods'

const NEAR_TOP = [179.95, 179.98, 179.99, 179.995, 179.998, 179.999, 180]

/** Turning angles in degrees: 0 to 180, every whole degree among them. */
export const AMPLITUDES = Float64Array.from([
  ...Array.from({ length: 351 }, (_, i) => i / 2),
  ...Array.from({ length: 49 }, (_, i) => (1751 + i) / 10),
  ...NEAR_TOP,
])
const ANGLES = AMPLITUDES.map(radians)

/** Places of the amplitudes of the short table. */
export const TABLE_ROWS = [10, 30, 60, 90, 120, 150, 170, 179].map((degrees) => AMPLITUDES.indexOf(degrees))

interface PeriodCurve {
  /** T/T₀. */
  readonly ratio: Float64Array
  /** Formula over exact, minus 1. */
  readonly error: Float64Array
  /** Its size. */
  readonly size: Float64Array
  /** The size in the range that the author states, NaN outside; null if none is stated. */
  readonly stated: Float64Array | null
}

const curves = new Map<string, PeriodCurve>()

/** By its name with N: `agm:1`; `exact` is the truth. Computed once. */
export function periodCurve(model: Model, key: string): PeriodCurve {
  const before = curves.get(key)
  if (before) return before
  const error = model.periodError(key, ANGLES)
  const size = error.map(Math.abs)
  const range = model.periods.find(({ name }) => name === key.split(':')[0])?.statedRange ?? null
  const stated = range && size.map((each, i) => (inside(ANGLES[i] as number, range) ? each : Number.NaN))
  const made = { ratio: model.periodRatio(key, ANGLES), error, size, stated }
  curves.set(key, made)
  return made
}

/** Both ends belong to it, however they were rounded. */
const inside = (angle: number, [least, most]: readonly [number, number]): boolean =>
  angle >= least && angle <= most + 4 * Number.EPSILON

interface PeriodAt {
  readonly ratio: number
  readonly error: number
}

export function periodAt(model: Model, key: string, thetaMax: number): PeriodAt {
  const at = Float64Array.of(thetaMax)
  return {
    ratio: model.periodRatio(key, at)[0] ?? Number.NaN,
    error: model.periodError(key, at)[0] ?? Number.NaN,
  }
}

export interface PeriodResult extends PeriodRow, PeriodAt {}

/** Every row with its value at an amplitude, sorted as the registry or by the size of the error. */
export function periodResults(
  model: Model,
  rows: readonly PeriodRow[],
  thetaMax: number,
  order: 'registry' | 'error',
): PeriodResult[] {
  const results = rows.map((row) => ({ ...row, ...periodAt(model, row.key, thetaMax) }))
  if (order === 'registry') return results
  const size = ({ error }: PeriodAt) => (Number.isNaN(error) ? Number.POSITIVE_INFINITY : Math.abs(error))
  return results.sort((a, b) => size(a) - size(b))
}

/** The formula that is drawn and nearest to the exact period. */
export function nearestOf(results: readonly PeriodResult[]): PeriodResult | null {
  const finite = results.filter(({ on, error }) => on && Number.isFinite(error))
  return finite.reduce<PeriodResult | null>(
    (best, each) => (best && Math.abs(best.error) <= Math.abs(each.error) ? best : each),
    null,
  )
}
