// Measured values as dots: one path of steps without a length, which round ends make into dots.

import type { Points } from './curve'
import type { Scale } from './scale'

/** The path of the values that are in the frame, in tenths of a pixel, as curves are drawn. */
export function dotsOf({ x, y }: Points, sx: Scale, sy: Scale, factor = 1, xFactor = 1): string {
  const out: string[] = []
  for (let i = 0; i < y.length; i++) {
    const px = Math.round(10 * sx((x[i] as number) * xFactor))
    const py = Math.round(10 * sy((y[i] as number) * factor))
    if (Number.isFinite(px) && Number.isFinite(py)) out.push(`M${px} ${py}h0`)
  }
  return out.join('')
}
