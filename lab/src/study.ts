// What the Lab shows of a state, as plain numbers: the exact motion and the curves over the window, their errors and energies.
//
// The window is a page of time: at its end the next one follows. Everything comes from the model; here it is put in order.

import { type Curve, curveKey, kindOf } from './curves'
import { clothesOf } from './draw/clothes'
import type { Points } from './draw/curve'
import { remember } from './memory'
import {
  type Arrays,
  type Compared,
  type Energy,
  KeptArrays,
  MOST_STEPS,
  type Motion,
  newArrays,
  type Refusal,
  type Solution,
  type Track,
} from './model'
import { DEGREES } from './number'
import type { State } from './state'

/** Steps of a curve in a window. */
export const POINTS = 1200

export interface Window {
  readonly from: number
  readonly to: number
}

export interface Drawn {
  readonly key: string
  readonly curve: Curve
  readonly clothes: string
  /** Whether it goes step by step. */
  readonly numerical: boolean
  readonly solution: Solution
  readonly track: Compared
  /** Solution − exact, in rad. */
  readonly error: Float64Array
  /** Parts of the energy at the top; empty for a formula, which is not a motion. */
  readonly energy: Points
  readonly largest: { readonly value: number; readonly t: number } | null
  /** First time in the window without a value. */
  readonly gone: number
}

export interface Row {
  readonly key: string
  readonly curve: Curve
  readonly clothes: string
  readonly drawn: Drawn | null
  readonly refused: Refusal | null
}

export interface Study {
  readonly motion: Motion
  readonly window: Window
  readonly times: Float64Array
  readonly exact: Track
  /** Total of the exact motion, which does not change. */
  readonly total: Float64Array
  /** Its parts, computed when they are asked for. */
  readonly parts: () => Energy
  readonly rows: readonly Row[]
  /** Those of the rows that are on and have values. */
  readonly shown: readonly Drawn[]
}

/** Length of the window in s. */
export function spanOf(state: Pick<State, 'span'>, motion: Motion): number {
  if (state.span !== 'T') return state.span
  const { period, smallPeriod } = motion
  return Number.isFinite(period) && period > 0 ? period : 4 * smallPeriod
}

/** The page of time that holds t. The end of one page is the beginning of the next. */
export function windowOf(span: number, t: number): Window {
  const page = Math.floor(t / span + 1e-9)
  return { from: page * span, to: (page + 1) * span }
}

/** The time within a span that is shown again and again. */
export function within(t: number, span: number): number {
  return t - span * Math.floor(t / span)
}

export function evenTimes({ from, to }: Window, points: number): Float64Array {
  const times = new Float64Array(points + 1)
  for (let i = 0; i <= points; i++) times[i] = from + ((to - from) * i) / points
  return times
}

/** The same while the window stays, so that what depends on them stays too. */
const timesOf = remember((from: number, to: number) => evenTimes({ from, to }, POINTS))

/** Largest size of the numbers, sharpened by the parabola through it and its neighbours, and when. */
export function largestOf(values: Float64Array, times: Float64Array): { value: number; t: number } | null {
  let at = -1
  for (let i = 0; i < values.length; i++) {
    const size = Math.abs(values[i] as number)
    if (Number.isNaN(size)) continue
    if (at < 0 || size > Math.abs(values[at] as number)) at = i
  }
  if (at < 0) return null
  const b = Math.abs(values[at] as number)
  const a = Math.abs(values[at - 1] ?? Number.NaN)
  const c = Math.abs(values[at + 1] ?? Number.NaN)
  const bend = a - 2 * b + c
  if (!(bend < 0)) return { value: b, t: times[at] as number }
  const shift = (a - c) / (2 * bend)
  const stride = (times[at + 1] as number) - (times[at] as number)
  return { value: b - ((a - c) * shift) / 4, t: (times[at] as number) + shift * stride }
}

/** The largest error of the window: searched for by the core where the window is one period from the start. */
function largestIn(solution: Solution, motion: Motion, { from, to }: Window, error: Float64Array, times: Float64Array) {
  const onePeriod = from === 0 && to === motion.period
  return (onePeriod && solution.largest(1)) || largestOf(error, times)
}

const NOTHING: Points = { x: new Float64Array(0), y: new Float64Array(0) }

interface Frame {
  readonly motion: Motion
  readonly window: Window
  readonly times: Float64Array
  readonly exact: Track
  readonly quick: boolean
  readonly arrays: Arrays
}

/** Of the quick study before; there is one at a time. */
const kept = new KeptArrays()

/** The first without a value; −1 if there is none. */
function firstNaN(values: Float64Array): number {
  for (let i = 0; i < values.length; i++) if (Number.isNaN(values[i] as number)) return i
  return -1
}

function drawn(
  { motion, window, times, exact, quick, arrays }: Frame,
  curve: Curve,
  clothes: string,
  solution: Solution,
): Drawn {
  const { numerical } = kindOf(curve.name)
  const track = solution.compared(times, exact, quick, arrays)
  const { error } = track
  const gone = firstNaN(track.theta)
  return {
    key: curveKey(curve),
    curve,
    clothes,
    numerical,
    solution,
    track,
    error,
    energy: numerical ? { x: times, y: motion.energy(track, arrays).total } : NOTHING,
    largest: quick ? largestOf(error, times) : largestIn(solution, motion, window, error, times),
    gone: gone < 0 ? Number.NaN : (times[gone] as number),
  }
}

/**
 * All that the Lab draws, but for the time shown. While a control is held it is `quick`: errors are plain differences,
 * and what is switched off is not computed.
 */
export function study(motion: Motion, curves: readonly Curve[], from: number, to: number, quick = false): Study {
  const window = { from, to }
  const times = timesOf(from, to)
  const arrays = quick ? kept.begin() : newArrays
  const exact = motion.sample(times, arrays)
  const frame = { motion, window, times, exact, quick, arrays }
  const clothes = clothesOf(curves)
  const most = MOST_STEPS / Math.max(1, curves.filter(({ name }) => kindOf(name).numerical).length)
  const rows = curves.map((curve, i): Row => {
    const row = { key: curveKey(curve), curve, clothes: clothes[i] as string }
    if (quick && !curve.on) return { ...row, drawn: null, refused: null }
    const solution = motion.solution(curve, window.to, most)
    if ('refused' in solution) return { ...row, drawn: null, refused: solution.refused }
    return { ...row, drawn: drawn(frame, curve, row.clothes, solution), refused: null }
  })
  const shown = rows.flatMap((row) => (row.drawn && row.curve.on ? [row.drawn] : []))
  let parts: Energy | null = null
  return {
    motion,
    window,
    times,
    exact,
    total: arrays.next(times.length).fill(motion.energyRatio),
    parts: () => {
      parts ??= motion.energy(exact, arrays)
      return parts
    },
    rows,
    shown,
  }
}

export const rememberedStudy = remember(study)

/** Whether total energy is shown: when some curve goes step by step, unless the reader chose. */
export function showsTotal(state: Pick<State, 'energy'>, { shown }: Study): boolean {
  if (state.energy !== 'auto') return state.energy === 'total'
  return shown.some(({ numerical }) => numerical)
}

/** Errors are in degrees where there is no amplitude to compare with. */
export function inPercent(state: Pick<State, 'errorUnit'>, { motion }: Study): boolean {
  return state.errorUnit === 'percent' && motion.regime === 'libration'
}

/** From rad to per cent of the turning angle, or to degrees. */
export function errorFactor(percent: boolean, motion: Motion): number {
  return percent ? 100 / motion.thetaMax : DEGREES
}

/** Log by itself where the largest errors differ by more than 20. */
export function isLog(state: Pick<State, 'errorAxis'>, { shown }: Study): boolean {
  if (state.errorAxis !== 'auto') return state.errorAxis === 'log'
  const sizes = shown.map(({ largest }) => largest?.value ?? 0).filter((size) => size > 0)
  return sizes.length > 1 && Math.max(...sizes) > 20 * Math.min(...sizes)
}
