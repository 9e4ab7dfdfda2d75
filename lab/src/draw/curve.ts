// A curve as an SVG path: broken where it has no value, cut at the frame, with marks where it leaves it.
//
// Coordinates are whole tenths of a pixel, for a group scaled by 0.1: whole numbers make short text fast, and steps from point to
// point shorter text than places. Points that the line passes anyway are left out. Written as bytes, which become text once.

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
  findCorners(x, y, sx, sy, factor)
  const d = written()
  drawn.set(y, { key, d })
  return d
}

/** Far beyond the frame, so that a steep line keeps its slope and no number grows long. */
const FAR = 20_000

/** How far a line may pass from a point that is left out, in tenths of a pixel: as little as the places themselves are rounded. */
const SLACK = 0.5

interface Places {
  readonly key: string
  readonly at: Float64Array
}
const places = new WeakMap<Float64Array, Places>()

/** Where points are along the axis; the curves of a plot have them in common. */
function placesOf(x: Float64Array, sx: Scale): Float64Array {
  const before = places.get(x)
  if (before?.key === sx.key) return before.at
  const at = new Float64Array(x.length)
  sx.fill(at, x, 1)
  places.set(x, { key: sx.key, at })
  return at
}

/** Stands before the first corner of a stretch; no place is as far. */
const LIFT = -1e9
/** Both places of each corner. */
let corners = new Int32Array(3 * 1536)
let count = 0
let heights = new Float64Array(1536)

function corner(x: number, y: number): void {
  corners[count++] = Math.round(x)
  corners[count++] = Math.round(y)
}

/**
 * The corners of a curve. A point is left out where the line from the corner before it to a later point passes it within the
 * slack: the slopes that do so for all points since are an interval, which narrows from point to point, and the line may end
 * at a point whose own slope is in it. That needs points from left to right; all others are corners.
 */
function findCorners(x: Float64Array, y: Float64Array, sx: Scale, sy: Scale, factor: number): void {
  if (heights.length < y.length) {
    corners = new Int32Array(6 * y.length)
    heights = new Float64Array(2 * y.length)
  }
  count = 0
  const along = placesOf(x, sx)
  sy.fill(heights, y, factor)
  let fromX = Number.NaN
  let fromY = Number.NaN
  let lastX = Number.NaN
  let lastY = Number.NaN
  let least = Number.NaN
  let most = Number.NaN
  let drawing = false
  /** Whether the last point is not a corner yet. */
  let open = false
  for (let i = 0; i < y.length; i++) {
    const px = 10 * (along[i] as number)
    const place = 10 * (heights[i] as number)
    const py = Math.min(Math.max(place, -FAR), FAR)
    const begins: boolean = !drawing
    // Both ends far on the same side: nothing of the line is in the frame.
    drawing =
      place < Number.POSITIVE_INFINITY &&
      place > Number.NEGATIVE_INFINITY &&
      (begins || py !== lastY || (py !== FAR && py !== -FAR))
    if (!drawing || begins) {
      if (open) corner(lastX, lastY)
      open = false
      if (!drawing) continue
      corners[count++] = LIFT
    }
    if (open && px > lastX) {
      const run = px - fromX
      const rise = py - fromY
      if (rise >= least * run && rise <= most * run) {
        if (rise - SLACK > least * run) least = (rise - SLACK) / run
        if (rise + SLACK < most * run) most = (rise + SLACK) / run
        lastX = px
        lastY = py
        continue
      }
    }
    if (open) corner(lastX, lastY)
    open = !begins && px > lastX
    if (open) {
      fromX = lastX
      fromY = lastY
      least = (py - SLACK - fromY) / (px - fromX)
      most = (py + SLACK - fromY) / (px - fromX)
    } else {
      corner(px, py)
    }
    lastX = px
    lastY = py
  }
  if (open) corner(lastX, lastY)
}

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

/** The corners as text. */
function written(): string {
  if (text.length < POINT * count) text = new Uint8Array(2 * POINT * count)
  let end = 0
  /** Commands since the pen was put down. */
  let steps = -1
  let lastX = 0
  let lastY = 0
  for (let i = 0; i < count; i += 2) {
    if (corners[i] === LIFT) {
      steps = -1
      i++
    }
    const x = corners[i] as number
    const y = corners[i + 1] as number
    const dx = steps < 0 ? x : x - lastX
    const dy = steps < 0 ? y : y - lastY
    if (steps < 1) text[end++] = steps < 0 ? MOVE : LINE
    else if (dx >= 0) text[end++] = SPACE
    end = put(dx, end)
    if (dy >= 0) text[end++] = SPACE
    end = put(dy, end)
    steps++
    lastX = x
    lastY = y
  }
  return letters.decode(text.subarray(0, end))
}

interface Leaving {
  readonly x: number
  readonly up: boolean
}

function staysWithin(y: Float64Array, low: number, high: number, factor: number): boolean {
  for (let i = 0; i < y.length; i++) {
    const value = (y[i] as number) * factor
    if (value < low || value > high) return false
  }
  return true
}

/**
 * Where a curve leaves the frame through its top or bottom, on the way out; at most so many. One that begins outside is marked
 * where it comes in, and at its beginning if it never does.
 */
export function leavings({ x, y }: Points, low: number, high: number, factor = 1, most = 12): Leaving[] {
  const out: Leaving[] = []
  if (staysWithin(y, low, high, factor)) return out
  let inside: boolean | null = null
  let begun: Leaving | null = null
  for (let i = 0; i < y.length && out.length < most; i++) {
    const value = (y[i] as number) * factor
    if (!Number.isFinite(value)) continue
    const within = value >= low && value <= high
    if (within !== inside) {
      const here = { x: x[i] as number, up: value > high }
      if (inside === null && !within) begun = here
      else if (inside && !within) out.push(here)
      else if (begun && within) {
        out.push({ x: here.x, up: begun.up })
        begun = null
      }
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
  for (let i = 0; i < values.length; i++) {
    const value = values[i] as number
    if (!Number.isFinite(value)) continue
    if (value < low) low = value
    if (value > high) high = value
  }
  return [low, high]
}
