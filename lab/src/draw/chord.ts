// The pendulum with its chord: from the lowest point of the circle to the bob. Angles in, picture out.

import { nothing, svg, type TemplateResult } from 'lit-html'

interface ChordSpec {
  readonly angle: number
  readonly reach: number
  readonly chord: string
}

export const CHORD_BOX = { width: 304, height: 276 } as const
const CENTRE = { x: 152, y: 136 }
const LENGTH = 118

export function chordSpot(angle: number, radius = LENGTH): { x: number; y: number } {
  return { x: CENTRE.x + radius * Math.sin(angle), y: CENTRE.y + radius * Math.cos(angle) }
}

export function chordAngle(x: number, y: number): number {
  return Math.atan2(x - CENTRE.x, y - CENTRE.y)
}

const n = (value: number): string => value.toFixed(1)

/** All but the bob, which is a control. */
export function chordDrawing({ angle, reach, chord }: ChordSpec): TemplateResult {
  const bob = chordSpot(angle)
  const left = chordSpot(-reach)
  const right = chordSpot(reach)
  const low = CENTRE.y + LENGTH
  const middle = { x: (CENTRE.x + bob.x) / 2, y: (low + bob.y) / 2 }
  const wide = Math.abs(angle) > 0.12
  const end = chordSpot(angle, 36)
  const named = chordSpot(angle / 2, 21)
  const away = angle >= 0 ? 10 : -10
  // On the side of the rod where the chord is not.
  const half = chordSpot(angle, LENGTH / 2)
  const beside = { x: half.x + 1.3 * away * Math.cos(angle), y: half.y - 1.3 * away * Math.sin(angle) }
  return svg`<circle class="grid-line" cx=${CENTRE.x} cy=${CENTRE.y} r=${LENGTH}/>
    ${reach > 0.01 ? svg`<path class="reach" d="M${n(left.x)} ${n(left.y)}A${LENGTH} ${LENGTH} 0 ${reach > Math.PI / 2 ? 1 : 0} 0 ${n(right.x)} ${n(right.y)}"/>` : nothing}
    <circle class="release" cx=${n(right.x)} cy=${n(right.y)} r="10"/>
    <path class="plumb" d="M${CENTRE.x} ${CENTRE.y}V${low}"/>
    <path class="length x" d="M${CENTRE.x} ${low}L${n(bob.x)} ${n(bob.y)}"/>
    <path class="quiet-rod" d="M${CENTRE.x} ${CENTRE.y}L${n(bob.x)} ${n(bob.y)}"/>
    ${
      wide
        ? svg`<path class="angle-arc" d="M${CENTRE.x} ${CENTRE.y + 36}A36 36 0 0 ${angle > 0 ? 0 : 1} ${n(end.x)} ${n(end.y)}"/>
      <text class="symbol" x=${n(named.x)} y=${n(named.y + 5)} text-anchor="middle">θ</text>`
        : nothing
    }
    <text class="symbol" x=${n(beside.x)} y=${n(beside.y + 5)} text-anchor="middle">L</text>
    <circle class="pivot" cx=${CENTRE.x} cy=${CENTRE.y} r="3.5"/>
    ${Math.abs(angle) > 0.5 ? svg`<text class="strong" x=${n(middle.x + away)} y=${n(middle.y + 14)} text-anchor=${angle > 0 ? 'start' : 'end'}>${chord}</text>` : nothing}`
}
