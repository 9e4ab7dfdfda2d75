// The drawn pendulum: circle with protractor, rod and bob, the bobs of other curves as rings, and the energy as a column.
//
// Geometry only: angles come in, and the energies as parts of the energy at the top. 16 units are 1 rem.

import { nothing, svg, type TemplateResult } from 'lit-html'
import { colourOf } from './clothes'

export interface Ghost {
  readonly clothes: string
  readonly angle: number
  readonly faded: boolean
}

export interface PendulumSpec {
  readonly angle: number
  readonly release: number
  /** Highest angle reached; π or more if it turns over. */
  readonly reach: number
  readonly kinetic: number
  readonly potential: number
  readonly ghosts: readonly Ghost[]
  readonly words: {
    readonly energy: string
    readonly kinetic: string
    readonly potential: string
    readonly more: string
  }
  readonly degree: (degrees: number) => string
}

export const BOX = { width: 280, height: 246 } as const
const CENTRE = { x: 128, y: 127 }
const LENGTH = 92
const COLUMN = { x: 268, width: 12 }
const LOW = CENTRE.y + LENGTH
const TOP = CENTRE.y - LENGTH

export function spot(angle: number, radius = LENGTH): { x: number; y: number } {
  return { x: CENTRE.x + radius * Math.sin(angle), y: CENTRE.y + radius * Math.cos(angle) }
}

/** The angle at which a point of the drawing is seen from the pivot. */
export function angleAt(x: number, y: number): number {
  return Math.atan2(x - CENTRE.x, y - CENTRE.y)
}

const n = (value: number): string => value.toFixed(1)

function arc(from: number, to: number, radius: number): string {
  const a = spot(from, radius)
  const b = spot(to, radius)
  const large = Math.abs(to - from) > Math.PI ? 1 : 0
  return `M${n(a.x)} ${n(a.y)}A${radius} ${radius} 0 ${large} ${to < from ? 1 : 0} ${n(b.x)} ${n(b.y)}`
}

const PROTRACTOR = Array.from({ length: 36 }, (_, i) => {
  const degrees = i * 10 - 170
  const a = spot((degrees * Math.PI) / 180, LENGTH + 3)
  const b = spot((degrees * Math.PI) / 180, LENGTH + (degrees % 30 === 0 ? 9 : 6))
  return `M${n(a.x)} ${n(a.y)}L${n(b.x)} ${n(b.y)}`
}).join('')

const MARKS: readonly [number, number, number, string][] = [
  [0, 1, 12, 'middle'],
  [90, 3, 5, 'start'],
  [-90, -3, 5, 'end'],
  [180, 1, -3, 'middle'],
]

function column({ kinetic, potential, words }: PendulumSpec): TemplateResult {
  const total = kinetic + potential
  const level = LOW - 2 * LENGTH * Math.min(total, 1)
  const bob = LOW - 2 * LENGTH * Math.min(potential, 1)
  const right = COLUMN.x + COLUMN.width
  const over = total > 1.0005
  // Beside the circle there is no room for it: below the middle, or not at all.
  const at = Math.max(level, TOP) + 16
  const beside = at > CENTRE.y - 52 && at < CENTRE.y + 52
  const named = beside ? CENTRE.y + 56 : at
  const room = bob - 4 > named && bob - level > 18
  return svg`
    <rect class="column" x=${COLUMN.x} y=${TOP} width=${COLUMN.width} height=${2 * LENGTH}/>
    <rect class="potential" x=${COLUMN.x} y=${n(bob)} width=${COLUMN.width} height=${n(LOW - bob)}/>
    <rect class="kinetic" x=${COLUMN.x} y=${n(level)} width=${COLUMN.width} height=${n(Math.max(bob - level, 0))}/>
    ${over ? svg`<path class="kinetic" d="M${COLUMN.x} ${TOP - 1}h${COLUMN.width}l${-COLUMN.width / 2} -7z"/>` : nothing}
    ${room ? svg`<text x=${COLUMN.x - 5} y=${n(named)} text-anchor="end">${words.kinetic}</text>` : nothing}
    ${LOW - bob > 18 ? svg`<text x=${COLUMN.x - 5} y=${LOW - 4} text-anchor="end">${words.potential}</text>` : nothing}
    <text x=${right} y=${TOP - (over ? 14 : 6)} text-anchor="end">${over ? words.more : words.energy}</text>`
}

/** All but the bob itself, which is a control. */
export function pendulum(spec: PendulumSpec): TemplateResult {
  const { angle, release, reach, ghosts } = spec
  const within = reach < Math.PI
  const bob = spot(angle)
  const from = spot(release)
  const level = LOW - 2 * LENGTH * Math.min(spec.kinetic + spec.potential, 1)
  // The arc from the bottom to the rod, within one turn.
  const turned = angle - 2 * Math.PI * Math.round(angle / (2 * Math.PI))
  const middle = spot(turned / 2, 42)
  const wide = Math.abs(turned) > 0.12
  return svg`
    <circle class="grid-line" cx=${CENTRE.x} cy=${CENTRE.y} r=${LENGTH}/>
    <path class="zero-line" d=${PROTRACTOR}/>
    ${MARKS.map(([degrees, dx, dy, anchor]) => {
      const at = spot((degrees * Math.PI) / 180, LENGTH + 10)
      return svg`<text x=${n(at.x + dx)} y=${n(at.y + dy)} text-anchor=${anchor}>${spec.degree(degrees)}</text>`
    })}
    ${
      within
        ? svg`<path class="reach" d=${arc(-reach, reach, LENGTH)}/>`
        : svg`<circle class="reach" cx=${CENTRE.x} cy=${CENTRE.y} r=${LENGTH}/>`
    }
    <path class="plumb" d="M${CENTRE.x} ${CENTRE.y}V${LOW}"/>
    ${wide ? svg`<path class="angle-arc" d=${arc(0, turned, 30)}/><text visibility=${Math.abs(turned) > 0.4 ? 'visible' : 'hidden'} class="symbol" x=${n(middle.x)} y=${n(middle.y + 5)} text-anchor="middle">θ</text>` : nothing}
    ${within && reach > 0.02 ? svg`<path class="level" d="M${n(from.x)} ${n(level)}H${COLUMN.x + COLUMN.width}"/>` : nothing}
    ${column(spec)}
    ${ghosts.map(({ clothes, angle: other, faded }) => {
      if (!Number.isFinite(other)) return nothing
      const at = spot(other)
      return svg`<g class=${faded ? 'faded' : ''}><path class="c thin ${clothes}" d="M${CENTRE.x} ${CENTRE.y}L${n(at.x)} ${n(at.y)}"/>
        <circle class="ghost" cx=${n(at.x)} cy=${n(at.y)} r="6" stroke=${colourOf(clothes)}/></g>`
    })}
    <circle class="release" cx=${n(from.x)} cy=${n(from.y)} r="10"/>
    <path class="rod" d="M${CENTRE.x} ${CENTRE.y}L${n(bob.x)} ${n(bob.y)}"/>
    <circle class="pivot" cx=${CENTRE.x} cy=${CENTRE.y} r="3.5"/>`
}
