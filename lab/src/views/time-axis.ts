// What the plots over time share: their axis with the unit at its end, period marks, and the time in words.

import { linearScale, roundTicks, type Scale, type Tick, tickDecimals } from '../draw/scale'
import type { Words } from '../language'
import type { Study, Window } from '../study'
import type { PlotSize } from './chart-spec'
import type { Page } from './page'

export function timeScale({ from, to }: Window, { width }: PlotSize): Scale {
  return linearScale([from, to], [0, width])
}

/** Round numbers; the last label has the unit. */
export function timeTicks(words: Words, { from, to }: Window, { width, rem }: PlotSize): Tick[] {
  const most = width < 24 * rem ? 5 : 9
  const span = to - from
  const room = (3.2 * rem * span) / width
  const round = roundTicks(from, to, most)
  const ends = Math.abs((round.at(-1) ?? from) - to) < 1e-9 * span
  const values = ends ? round : [...round.filter((value) => to - value > room), to]
  const decimals = tickDecimals(ends ? values : values.slice(0, -1))
  return values.map((value, i) => {
    const last = i === values.length - 1
    const text = words.fixed(value, last && !ends ? Math.max(decimals, 2) : decimals)
    return { value, text: last ? words.with(text, words.say.units.s) : text }
  })
}

export function periodVerticals(
  { words, state }: Page,
  { motion }: Study,
  marks: readonly number[],
): { x: number; text: string }[] {
  // Where g is hidden the period is for the reader to find.
  return (state.hide ? [] : marks).map((x) => {
    const n = Math.round(x / motion.period)
    return { x, text: n === 1 ? '_T_' : `${words.given(n)}_T_` }
  })
}

export function timeText(words: Words, t: number): string {
  return words.with(words.given(Number(t.toFixed(2))), words.say.units.s)
}

/** T, 2T … in the window. */
export function periodMarks({ motion, window }: Study): number[] {
  const { period } = motion
  if (!(period > 0) || !Number.isFinite(period) || (window.to - window.from) / period > 12) return []
  const first = Math.max(1, Math.ceil(window.from / period + 1e-9))
  const marks: number[] = []
  for (let n = first; n * period <= window.to * (1 + 1e-12); n++) marks.push(n * period)
  return marks
}
