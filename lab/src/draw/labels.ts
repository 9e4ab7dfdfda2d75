// Names beside curves, only where they touch nothing: no curve, no other name, not the frame. Where there is no room there is none.

import type { Points } from './curve'
import type { Scale } from './scale'

interface Named extends Points {
  readonly text: string
  readonly factor?: number
}

interface Placed {
  readonly text: string
  /** Middle of the line of text, in pixels. */
  readonly x: number
  readonly y: number
}

interface Room {
  readonly sx: Scale
  readonly sy: Scale
  readonly width: number
  readonly height: number
  /** Of a letter and of a line, in px. */
  readonly letter: number
  readonly line: number
}

const COLUMNS = 160

/** Heights of a curve at even columns of the frame; NaN where it is not. */
function heights({ x, y, factor = 1 }: Named, { sx, sy, width }: Room): Float64Array {
  const out = new Float64Array(COLUMNS + 1).fill(Number.NaN)
  let i = 0
  for (let column = 0; column <= COLUMNS; column++) {
    const value = sx.invert((width * column) / COLUMNS)
    while (i < x.length - 2 && (x[i + 1] as number) < value) i++
    const [a, b] = [x[i] as number, x[i + 1] as number]
    const [from, to] = [sy((y[i] as number) * factor), sy((y[i + 1] as number) * factor)]
    out[column] = b > a ? from + ((to - from) * (value - a)) / (b - a) : from
  }
  return out
}

interface Box {
  readonly left: number
  readonly right: number
  readonly top: number
  readonly bottom: number
}

const touch = (a: Box, b: Box): boolean => a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom

/** Whether a curve goes through a box. */
function through(curve: Float64Array, box: Box, width: number): boolean {
  const first = Math.max(0, Math.floor((box.left / width) * COLUMNS))
  const last = Math.min(COLUMNS, Math.ceil((box.right / width) * COLUMNS))
  for (let i = first; i < last; i++) {
    const [a, b] = [curve[i] as number, curve[i + 1] as number]
    if (Math.max(a, b) >= box.top && Math.min(a, b) <= box.bottom) return true
  }
  return false
}

/** A place for each name, in the order given; those without one are left out. A curve without a name is only kept clear of. */
export function placedLabels(curves: readonly Named[], room: Room): Placed[] {
  const { width, height, letter, line } = room
  const all = curves.map((each) => heights(each, room))
  const boxes: Box[] = []
  const out: Placed[] = []
  curves.forEach(({ text }, k) => {
    if (text === '') return
    const own = all[k] as Float64Array
    const half = (text.length * letter) / 2
    for (let step = 0; step < COLUMNS; step++) {
      // Begins a little further right for each, so that names do not stand in one column.
      const column = (Math.round(COLUMNS * (0.2 + 0.11 * k)) + step * 7) % COLUMNS
      const x = (width * column) / COLUMNS
      if (x - half < 2 || x + half > width - 2) continue
      for (const away of [-0.95, 0.95, -1.5, 1.5, -2.2, 2.2, -3, 3]) {
        const y = (own[column] as number) + away * line
        const box = { left: x - half - 2, right: x + half + 2, top: y - 0.55 * line, bottom: y + 0.55 * line }
        if (!(box.top > 1 && box.bottom < height - 1)) continue
        if (boxes.some((each) => touch(each, box)) || all.some((each) => through(each, box, width))) continue
        // Its own curve is the nearest one.
        const near = Math.abs(away) * line
        if (all.some((each, j) => j !== k && Math.abs((each[column] as number) - y) < 1.25 * near)) continue
        boxes.push(box)
        out.push({ text, x, y })
        return
      }
    }
  })
  return out
}
