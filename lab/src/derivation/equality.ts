// One displayed equality: its formula, the equations of the papers, and both sides as numbers of the reader's own pendulum.

import type { Regime } from '../model'
import type { Moment } from './moment'

export interface Equality {
  /** Also the name of its formula in formulas.tex. */
  readonly id: string
  /** Equations of the papers, as in `Salas (6)`. */
  readonly tag: string
  readonly unit: '' | 'rad' | 'rad/s' | 'rad/s²' | '1/s²' | 'm/s²' | 's'
  /** The motions for which it holds. */
  readonly of: readonly Regime[]
  readonly left: (now: Moment) => number
  readonly right: (now: Moment) => number
  /** What a difference is measured against where both sides pass through 0: the largest that they or their terms become. */
  readonly size?: (now: Moment) => number
  /** Where it has no value though the motion is of the right kind. */
  readonly undefinedAt?: (now: Moment) => boolean
}

/** Largest relative difference of the sides of an equality that holds. */
export const TOLERANCE = 1e-9

export const ALL: readonly Regime[] = ['rest', 'libration', 'separatrix', 'rotation']
export const MOVING: readonly Regime[] = ['libration', 'separatrix', 'rotation']
export const SWING: readonly Regime[] = ['libration']
export const TURN: readonly Regime[] = ['rotation']
export const BOTH: readonly Regime[] = ['libration', 'rotation']
export const LIMIT: readonly Regime[] = ['separatrix']

export const square = (x: number): number => x * x
/** The size of what is at most 1: a sine, sn, cn. */
export const one = (): number => 1

export interface Sides {
  readonly left: number
  readonly right: number
  /** What the difference is measured against: the larger side, or more where both pass through 0. */
  readonly size: number
  /** Difference over the size. */
  readonly apart: number
}

/** Both sides; null where the equality is not about this motion or has no value there. */
export function sidesOf(equality: Equality, now: Moment): Sides | null {
  if (!equality.of.includes(now.regime) || equality.undefinedAt?.(now)) return null
  const left = equality.left(now)
  const right = equality.right(now)
  const size = Math.max(Math.abs(left), Math.abs(right), equality.size?.(now) ?? 0)
  return { left, right, size, apart: left === right ? 0 : Math.abs(left - right) / size }
}

/** Digits in which the sides agree, as many as are shown at most. */
export function digitsOf(apart: number, most: number): number {
  return apart === 0 ? most : Math.max(0, Math.min(most, Math.floor(-Math.log10(apart))))
}
