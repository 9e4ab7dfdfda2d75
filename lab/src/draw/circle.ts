// The circle of the energy: a point with the width x and the height s at the distance κ, the separatrix at 1, and the angle φ of a swing.

import { nothing, svg, type TemplateResult } from 'lit-html'
import { richSvg } from '../language/rich'

interface CircleSpec {
  readonly x: number
  readonly s: number
  readonly kappa: number
  /** Whether the point goes all the way round. */
  readonly swings: boolean
  readonly width: string
  readonly height: string
}

export const CIRCLE_BOX = { width: 330, height: 220 } as const
const CENTRE = { x: 165, y: 110 }
/** Of the larger circle. */
const RADIUS = 92

const n = (value: number): string => value.toFixed(1)

/** φ from the axis of the width, against the clock: in [0, 2π). */
export function angleOf(x: number, s: number): number {
  const phi = Math.atan2(s, x)
  return phi < 0 ? phi + 2 * Math.PI : phi
}

export function circle({ x, s, kappa, swings, width, height }: CircleSpec): TemplateResult {
  const unit = RADIUS / Math.max(1, kappa)
  const { x: cx, y: cy } = CENTRE
  const at = { x: cx + unit * x, y: cy - unit * s }
  const large = Math.hypot(at.x - cx, at.y - cy) > 34
  const phi = angleOf(x, s)
  const end = { x: cx + 24 * Math.cos(phi), y: cy - 24 * Math.sin(phi) }
  const named = { x: cx + 36 * Math.cos(phi / 2), y: cy - 36 * Math.sin(phi / 2) }
  return svg`
    <path class="zero-line" d="M${cx - RADIUS - 20} ${cy}H${cx + RADIUS + 62}M${cx} ${cy - RADIUS - 12}V${cy + RADIUS + 12}"/>
    <text x=${cx + RADIUS + 10} y=${cy - 6}>${richSvg(width)}</text>
    <text x=${cx + 6} y=${cy - RADIUS - 6}>${richSvg(height)}</text>
    <circle class="unit-circle" cx=${cx} cy=${cy} r=${n(unit)}/>
    <circle class="reach" cx=${cx} cy=${cy} r=${n(unit * kappa)}/>
    ${
      large
        ? svg`<path class="drop-line" d="M${n(at.x)} ${n(at.y)}V${cy}M${n(at.x)} ${n(at.y)}H${cx}"/>
    <path class="quiet-rod" d="M${cx} ${cy}L${n(at.x)} ${n(at.y)}"/>`
        : nothing
    }
    ${
      large && swings && phi > 0.35
        ? svg`<path class="angle-arc" d="M${cx + 24} ${cy}A24 24 0 ${phi > Math.PI ? 1 : 0} 0 ${n(end.x)} ${n(end.y)}"/>
    <text class="symbol" x=${n(named.x)} y=${n(named.y + 5)} text-anchor="middle">φ</text>`
        : nothing
    }
    <circle class="bob" cx=${n(at.x)} cy=${n(at.y)} r="7"/>`
}
