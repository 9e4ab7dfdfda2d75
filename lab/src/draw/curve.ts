// A curve as an SVG path: broken where it has no value, cut at the frame, with marks where it leaves it.
//
// Coordinates are whole tenths of a pixel, for a group scaled by 0.1: whole numbers make short text fast, and steps from point to
// point shorter text than places. They are written as bytes, and become text once.

import type { Scale } from './scale'

/** Points of the same index belong together. */
export interface Points {
  readonly x: Float64Array
  readonly y: Float64Array
}

interface Drawn {
  readonly key: string
  readonly d: string
}
const drawn = new WeakMap<Float64Array, Drawn>()

/** The path; drawn once for the same numbers and the same scales. `factor` turns the data into the axis' unit. */
export function pathOf({ x, y }: Points, sx: Scale, sy: Scale, factor = 1): string {
  const key = `${sx.key}|${sy.key}|${factor}`
  const before = drawn.get(y)
  if (before?.key === key) return before.d
  const d = written(x, y, sx, sy, factor)
  drawn.set(y, { key, d })
  return d
}

/** Far beyond the frame, so that a steep line keeps its slope and no number grows long. */
const FAR = 20_000

/** Bytes of a point, both numbers with a sign and six digits, and of the letter of a command. */
const POINT = 16
let text = new Uint8Array(POINT * 1536)
const letters = new TextDecoder()
const [ZERO, MINUS, SPACE, MOVE, LINE] = [48, 45, 32, 77, 108]

/** Writes a whole number at a place, the last four digits one by one; the place after it. */
function put(value: number, at: number): number {
  let left = value
  let place = at
  if (left < 0) {
    text[place++] = MINUS
    left = -left
  }
  if (left >= 10_000) {
    const head = (left / 10_000) | 0
    place = put(head, place)
    left -= head * 10_000
    text[place++] = ZERO + ((left / 1000) | 0)
    text[place++] = ZERO + (((left / 100) | 0) % 10)
    text[place++] = ZERO + (((left / 10) | 0) % 10)
  } else if (left >= 10) {
    if (left >= 100) {
      if (left >= 1000) text[place++] = ZERO + ((left / 1000) | 0)
      text[place++] = ZERO + (((left / 100) | 0) % 10)
    }
    text[place++] = ZERO + (((left / 10) | 0) % 10)
  }
  text[place] = ZERO + (left % 10)
  return place + 1
}

function written(x: Float64Array, y: Float64Array, sx: Scale, sy: Scale, factor: number): string {
  if (text.length < POINT * (y.length + 1)) text = new Uint8Array(2 * POINT * (y.length + 1))
  let end = 0
  /** Commands since the pen was put down. */
  let steps = -1
  let lastX = 0
  let lastY = 0
  for (let i = 0; i < y.length; i++) {
    const value = (y[i] as number) * factor
    const px = Math.round(10 * sx(x[i] as number))
    const py = Math.round(10 * sy(value))
    if (!(Number.isFinite(value) && Number.isFinite(py))) {
      steps = -1
      continue
    }
    const kept = Math.min(Math.max(py, -FAR), FAR)
    // Both ends far on the same side: nothing of the line is in the frame.
    if (steps >= 0 && (kept === FAR || kept === -FAR) && kept === lastY) {
      steps = -1
      continue
    }
    const dx = steps < 0 ? px : px - lastX
    const dy = steps < 0 ? kept : kept - lastY
    if (steps < 1) text[end++] = steps < 0 ? MOVE : LINE
    else if (dx >= 0) text[end++] = SPACE
    end = put(dx, end)
    if (dy >= 0) text[end++] = SPACE
    end = put(dy, end)
    steps++
    lastX = px
    lastY = kept
  }
  return letters.decode(text.subarray(0, end))
}

export interface Leaving {
  readonly x: number
  readonly up: boolean
}

/**
 * Where a curve leaves the frame through its top or bottom, on the way out; at most so many. One that begins outside is marked
 * where it comes in, and at its beginning if it never does.
 */
export function leavings({ x, y }: Points, low: number, high: number, factor = 1, most = 12): Leaving[] {
  const out: Leaving[] = []
  let inside: boolean | null = null
  let begun: Leaving | null = null
  for (let i = 0; i < y.length && out.length < most; i++) {
    const value = (y[i] as number) * factor
    if (!Number.isFinite(value)) continue
    const within = value >= low && value <= high
    const here = { x: x[i] as number, up: value > high }
    if (inside === null && !within) begun = here
    else if (inside && !within) out.push(here)
    else if (begun && within) {
      out.push({ x: here.x, up: begun.up })
      begun = null
    }
    inside = within
  }
  return begun ? [begun] : out
}

/** Stretches of x without a value: [from, to]. */
export function gaps({ x, y }: Points): [number, number][] {
  const out: [number, number][] = []
  let from = -1
  for (let i = 0; i <= y.length; i++) {
    const none = i < y.length && Number.isNaN(y[i] as number)
    if (none && from < 0) from = i
    if (!none && from >= 0) {
      out.push([x[from] as number, x[Math.min(i, y.length - 1)] as number])
      from = -1
    }
  }
  return out
}

/** Least and greatest number that is finite. */
export function extent(values: Float64Array): [number, number] {
  let low = Number.POSITIVE_INFINITY
  let high = Number.NEGATIVE_INFINITY
  for (const value of values) {
    if (!Number.isFinite(value)) continue
    if (value < low) low = value
    if (value > high) high = value
  }
  return [low, high]
}
