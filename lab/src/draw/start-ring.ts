// The dashed ring at the start of a motion, over a phase portrait.

import { svg, type TemplateResult } from 'lit-html'

interface RingSpec {
  readonly width: number
  readonly height: number
  readonly rem: number
}

/** At x and y in pixels. */
export function startRing(x: number, y: number, { width, height, rem }: RingSpec): TemplateResult {
  return svg`<svg class="plot-drawing" width=${width} height=${height} aria-hidden="true"><circle class="start-ring" cx=${x.toFixed(1)} cy=${y.toFixed(1)} r=${0.4375 * rem}/></svg>`
}
