// The force diagram: rod, arc, weight, and its parts along and across the arc, at one angle. Words in, picture out.

import { svg, type TemplateResult } from 'lit-html'
import { richSvg } from '../language/rich'

interface ForcesSpec {
  readonly weight: string
  readonly along: string
  readonly across: string
  readonly rod: string
}

export const FORCES_BOX = { width: 330, height: 238 } as const
const PIVOT = { x: 96, y: 16 }
const ROD = 128
const ANGLE = 0.72
/** Length of the weight's arrow. */
const WEIGHT = 92
/** That of the rod's pull: the weight along the rod, and what keeps a moving mass on the arc. */
const PULL = WEIGHT * (Math.cos(ANGLE) + 0.25)

const n = (value: number): string => value.toFixed(1)
const [SIN, COS] = [Math.sin(ANGLE), Math.cos(ANGLE)]
const BOB = { x: PIVOT.x + ROD * SIN, y: PIVOT.y + ROD * COS }

/** An arrow from the bob by a vector. */
function arrow(dx: number, dy: number, className: string): TemplateResult {
  const size = Math.hypot(dx, dy)
  const [ux, uy] = [dx / size, dy / size]
  const tip = { x: BOB.x + dx, y: BOB.y + dy }
  const back = { x: tip.x - 10 * ux, y: tip.y - 10 * uy }
  const head = `M${n(tip.x)} ${n(tip.y)}L${n(back.x - 4.5 * uy)} ${n(back.y + 4.5 * ux)}L${n(back.x + 4.5 * uy)} ${n(back.y - 4.5 * ux)}Z`
  return svg`<g class="force ${className}"><path d="M${n(BOB.x)} ${n(BOB.y)}L${n(back.x)} ${n(back.y)}"/><path class="head" d=${head}/></g>`
}

export function forces({ weight, along, across, rod }: ForcesSpec): TemplateResult {
  const part = { x: -WEIGHT * SIN * COS, y: WEIGHT * SIN * SIN }
  const rest = { x: WEIGHT * COS * SIN, y: WEIGHT * COS * COS }
  const low = { x: PIVOT.x, y: PIVOT.y + ROD }
  const arc = { x: PIVOT.x + ROD * Math.sin(1.15), y: PIVOT.y + ROD * Math.cos(1.15) }
  const left = { x: PIVOT.x - ROD * Math.sin(0.42), y: PIVOT.y + ROD * Math.cos(0.42) }
  const end = { x: PIVOT.x + 40 * SIN, y: PIVOT.y + 40 * COS }
  return svg`
    <path class="reach faint-arc" d="M${n(left.x)} ${n(left.y)}A${ROD} ${ROD} 0 0 0 ${n(arc.x)} ${n(arc.y)}"/>
    <path class="plumb" d="M${PIVOT.x} ${PIVOT.y}V${low.y + 14}"/>
    <path class="angle-arc" d="M${PIVOT.x} ${PIVOT.y + 40}A40 40 0 0 0 ${n(end.x)} ${n(end.y)}"/>
    <text class="symbol" x=${n(PIVOT.x + 27 * Math.sin(ANGLE / 2))} y=${n(PIVOT.y + 29 * Math.cos(ANGLE / 2) + 4)} text-anchor="middle">θ</text>
    <path class="rod" d="M${PIVOT.x} ${PIVOT.y}L${n(BOB.x)} ${n(BOB.y)}"/>
    <circle class="pivot" cx=${PIVOT.x} cy=${PIVOT.y} r="3.5"/>
    <path class="drop-line" d="M${n(BOB.x + part.x)} ${n(BOB.y + part.y)}L${n(BOB.x)} ${n(BOB.y + WEIGHT)}L${n(BOB.x + rest.x)} ${n(BOB.y + rest.y)}"/>
    ${arrow(-PULL * SIN, -PULL * COS, 'quiet')}
    ${arrow(rest.x, rest.y, 'quiet')}
    ${arrow(part.x, part.y, 'strong')}
    ${arrow(0, WEIGHT, '')}
    <circle class="bob" cx=${n(BOB.x)} cy=${n(BOB.y)} r="10"/>
    <text class="symbol" x=${n(PIVOT.x + 0.72 * ROD * SIN + 12)} y=${n(PIVOT.y + 0.72 * ROD * COS - 4)}>L</text>
    <text x=${n(BOB.x - PULL * SIN + 14)} y=${n(BOB.y - PULL * COS + 8)}>${rod}</text>
    <text x=${n(BOB.x + part.x - 8)} y=${n(BOB.y + part.y + 4)} text-anchor="end" class="ink">${richSvg(along)}</text>
    <text x=${n(BOB.x + rest.x + 8)} y=${n(BOB.y + rest.y + 2)}>${richSvg(across)}</text>
    <text x=${n(BOB.x)} y=${n(BOB.y + WEIGHT + 17)} text-anchor="middle">${richSvg(weight)}</text>`
}
