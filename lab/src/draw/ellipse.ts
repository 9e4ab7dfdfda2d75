// The ellipse with its unit circle: point, radius, angle, and the lengths sn, cn and x. Plain numbers in; y may be drawn shorter.

import { nothing, svg, type TemplateResult } from 'lit-html'

interface EllipseSpec {
  readonly x: number
  readonly y: number
  /** Of the point where the radius meets the unit circle. */
  readonly cn: number
  readonly sn: number
  /** Half the height; half the width is 1. */
  readonly height: number
  /** y is drawn 1 : so much. */
  readonly shortening: number
  readonly text: (value: number) => string
}

export const ELLIPSE_BOX = { width: 240, height: 486 } as const
const CENTRE = { x: 118, y: 244 }
/** Greatest, where the ellipse is not tall. */
const UNIT = 96
const ROOM = 232

/** Pixels of 1 along x and along y. */
function ellipseUnits({ height, shortening }: Pick<EllipseSpec, 'height' | 'shortening'>): {
  x: number
  y: number
} {
  const unit = Math.min(UNIT, (ROOM * shortening) / height)
  return { x: unit, y: unit / shortening }
}

export function ellipseSpot(spec: Pick<EllipseSpec, 'x' | 'y' | 'height' | 'shortening'>): { x: number; y: number } {
  const unit = ellipseUnits(spec)
  return { x: CENTRE.x + unit.x * spec.x, y: CENTRE.y - unit.y * spec.y }
}

/** Polar angle, in the ellipse's own axes, of a point of the drawing. */
export function ellipseAngle(x: number, y: number, spec: Pick<EllipseSpec, 'height' | 'shortening'>): number {
  const unit = ellipseUnits(spec)
  return Math.atan2((CENTRE.y - y) / unit.y, (x - CENTRE.x) / unit.x)
}

const n = (value: number): string => value.toFixed(1)

/** All but the point itself, which is a control. */
export function ellipseDrawing(spec: EllipseSpec): TemplateResult {
  const { cn, sn, height, text } = spec
  const unit = ellipseUnits(spec)
  const { x: cx, y: cy } = CENTRE
  const point = ellipseSpot(spec)
  const on = { x: cx + unit.x * cn, y: cy - unit.y * sn }
  const seen = Math.atan2(cy - point.y, point.x - cx)
  const turned = seen < 0 ? seen + 2 * Math.PI : seen
  const arc = `M${cx + 15} ${cy}A15 15 0 ${turned > Math.PI ? 1 : 0} 0 ${n(cx + 15 * Math.cos(seen))} ${n(cy - 15 * Math.sin(seen))}`
  const right = cn >= 0
  const above = sn >= 0
  // φ in the middle of its arc; below the axis on the other side of x, whose name is then above it.
  const phiAt = above ? turned / 2 : right ? 2.4 : 0.75
  const tall = unit.y * height
  const wide = Math.abs(on.x - cx)
  const high = Math.abs(on.y - cy)
  const far = Math.hypot(point.x - cx, point.y - cy)
  // Beside the part of the radius that is outside the circle; where there is little of it, below its middle.
  const outside = far > 1.4 * Math.hypot(on.x - cx, on.y - cy)
  const part = outside ? 0.5 * (1 + Math.hypot(on.x - cx, on.y - cy) / far) : 0.5
  const aside = (outside ? 1 : -1) * (right ? -12 : 12)
  const named = { x: cx + part * (point.x - cx) + aside, y: cy + part * (point.y - cy) + (outside === above ? 0 : 8) }
  return svg`
    <path class="zero-line" d="M${n(cx - unit.x - 22)} ${cy}H${n(cx + unit.x + 22)}M${cx} 6V482"/>
    <ellipse class="ellipse" cx=${cx} cy=${cy} rx=${n(unit.x)} ry=${n(tall)}/>
    <ellipse class="unit-circle" cx=${cx} cy=${cy} rx=${n(unit.x)} ry=${n(unit.y)}/>
    <path class="angle-arc" d=${arc}/>${turned > 0.5 ? svg`<text class="symbol" x=${n(cx + 24 * Math.cos(phiAt))} y=${n(cy - 24 * Math.sin(phiAt) + 5)} text-anchor="middle">φ</text>` : nothing}
    <path class="drop-line" d="M${n(point.x)} ${n(point.y)}V${cy}"/>
    <path class="c c-dn" d="M${cx} ${cy}L${n(point.x)} ${n(point.y)}"/>
    ${far > 45 ? svg`<text class="symbol" x=${n(named.x)} y=${n(named.y)} text-anchor="middle">r</text>` : nothing}
    <path class="length sn" d="M${n(on.x)} ${cy}V${n(on.y)}"/><path class="length cn" d="M${cx} ${n(on.y)}H${n(on.x)}"/>
    <path class="length x" d="M${cx} ${cy}H${n(point.x)}"/>
    ${Math.abs(point.x - cx) > 16 ? svg`<text class="symbol" x=${n((cx + point.x) / 2)} y=${above ? cy + 17 : cy - 8} text-anchor="middle">x</text>` : nothing}
    <circle class="meeting" cx=${n(on.x)} cy=${n(on.y)} r="3.5"/>
    <text x=${n(cx + unit.x + 6)} y=${above ? cy + 17 : cy - 6}>${text(1)}</text><text x=${cx + 10} y=${n(Math.max(cy - tall - 4, 12))}>${text(height)}</text>
    ${wide > 22 && high > 12 ? svg`<text class="strong" x=${n((cx + on.x) / 2)} y=${n(on.y + (above ? -7 : 17))} text-anchor="middle">cn</text>` : nothing}
    ${high > 20 ? svg`<text class="strong" x=${n(on.x + (right ? 5 : -5))} y=${n((on.y + cy) / 2 + 5)} text-anchor=${right ? 'start' : 'end'}>sn</text>` : nothing}`
}
