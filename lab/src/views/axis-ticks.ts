// Round numbers of an axis as ticks, in the language of the page.

import { roundTicks, type Tick, tickDecimals } from '../draw/scale'
import type { Words } from '../language'

/** With as many decimals as tell them apart, and a unit that needs no space. */
export function ticksAt(words: Words, values: readonly number[], unit = ''): Tick[] {
  const decimals = tickDecimals(values)
  return values.map((value) => ({ value, text: `${words.fixed(value, decimals)}${unit}` }))
}

/** At most so many between two ends. */
export function roundTicksOf(words: Words, low: number, high: number, most: number): Tick[] {
  return ticksAt(words, roundTicks(low, high, most))
}
