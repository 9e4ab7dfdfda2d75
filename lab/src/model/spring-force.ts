// The forces of the springs u″ + p u + r u² + q u³ + s u⁵ = c, beside the core: the potential and the places where nothing pulls.
//
// The core has no potential and no list of equilibria: V(u) = p u²/2 + r u³/3 + q u⁴/4 + s u⁶/6 − c u and the roots of V′ are computed
// here, and tests/springs.test.ts holds them to the core's energies and motions.

import type { SpringKind, State } from '../state'

type Coefficients = Pick<State, 'p' | 'r' | 'q' | 'c' | 's'>

/** The coefficients; 0 where the kind has none. */
export interface Force extends Coefficients {
  readonly kind: SpringKind
}

/** The force without what its kind has not. */
export function forceOf(kind: SpringKind, { p, r, q, c, s }: Coefficients): Force {
  const even = kind === 'helmholtz-duffing'
  return { kind, p, r: even ? r : 0, q, c: even ? c : 0, s: kind === 'cubic-quintic' ? s : 0 }
}

/** Whether u = 0 is a place as any other. */
export const isEven = ({ r, c }: Force): boolean => r !== 0 || c !== 0

export interface Equilibrium {
  readonly u: number
  /** The potential there. */
  readonly height: number
  readonly stable: boolean
  /** √|V″|: of small oscillations, or how fast it is left. */
  readonly rate: number
}

type Place = Pick<Equilibrium, 'u' | 'stable'>

/** V(u), 0 at u = 0. */
export function potential({ p, r, q, c, s }: Force, u: number): number {
  const w = u * u
  return w * (p / 2 + w * (q / 4 + (w * s) / 6)) + u * ((w * r) / 3 - c)
}

/** V″(u). */
function bend({ p, r, q, s }: Force, u: number): number {
  const w = u * u
  return p + 2 * r * u + w * (3 * q + 5 * w * s)
}

/** Real roots of a u² + 2 b u + c, without cancellation, rising; of a root that is two, one. */
function quadraticRoots(a: number, b: number, c: number): number[] {
  if (a === 0) return b === 0 ? [] : [-c / (2 * b)]
  const square = b * b - a * c
  if (square < 0) return []
  const sum = -(b + (b < 0 ? -1 : 1) * Math.sqrt(square))
  const roots = sum === 0 ? [0] : [sum / a, c / sum]
  return [...new Set(roots)].filter(Number.isFinite).sort((x, y) => x - y)
}

/** Without even powers: 0, and ± the roots of p + q u² + s u⁴. */
function oddPlaces(force: Force): Place[] {
  const { p, q, s } = force
  const right = quadraticRoots(s, q / 2, p)
    .filter((w) => w > 0)
    .map((w) => Math.sqrt(w))
  return [...right.map((u) => -u).reverse(), 0, ...right].map((u) => {
    return { u, stable: u === 0 && p === 0 ? q > 0 || (q === 0 && s > 0) : bend(force, u) > 0 }
  })
}

/** Between two places where a rising or falling function has other signs, to the last bit. */
function bisected(of: (u: number) => number, from: number, to: number): number {
  let [negative, positive] = of(from) < 0 ? [from, to] : [to, from]
  for (;;) {
    const middle = negative / 2 + positive / 2
    if (middle === negative || middle === positive) return middle
    const value = of(middle)
    if (value === 0) return middle
    if (value < 0) negative = middle
    else positive = middle
  }
}

/** With even powers: roots of V′ between the places where V″ vanishes, and these where it is 0 there but for rounding. */
function evenPlaces({ p, r, q, c }: Force): Place[] {
  const pull = (u: number) => ((q * u + r) * u + p) * u - c
  const terms = (u: number) => Math.abs(q * u ** 3) + Math.abs(r * u * u) + Math.abs(p * u) + Math.abs(c)
  const [first = 0, ...others] = [q, r, p].slice([q, r, p].findIndex((each) => each !== 0))
  if (first === 0) return []
  // All roots are nearer.
  const far = Math.min(1e300, 1 + Math.max(...[...others, c].map((each) => Math.abs(each / first))))
  const inner = [...quadraticRoots(3 * q, r, p), ...(c === 0 ? [0] : [])].sort((x, y) => x - y)
  const points = [-far, ...new Set(inner), far]
  const signs = points.map((u) => {
    const value = pull(u)
    return Math.abs(u) < far && Math.abs(value) <= 8 * Number.EPSILON * terms(u) ? 0 : Math.sign(value)
  })
  return points.flatMap((u, i) => {
    const [before = 0, here = 0, after = 0] = [signs[i - 1], signs[i], signs[i + 1]]
    if (here === 0) return { u, stable: before < 0 && after > 0 }
    return here * after < 0 ? { u: bisected(pull, u, points[i + 1] as number), stable: after > 0 } : []
  })
}

/** Where a start at rest stays, from left to right. */
export function equilibria(force: Force): Equilibrium[] {
  return (isEven(force) ? evenPlaces(force) : oddPlaces(force)).map(({ u, stable }) => {
    return { u, stable, height: potential(force, u), rate: Math.sqrt(Math.abs(bend(force, u))) }
  })
}
