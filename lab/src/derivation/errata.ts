// Lines of the papers that are wrong as printed, put to the reader's own pendulum: what the printed line gives, what the corrected one
// gives, and what is true. docs/errata.md has all of them with their reasons.

import { type Equality, square } from './equality'
import type { Moment } from './moment'
import { byStart, coefficientsOf, duffingOf, firstOfNine, RATIONAL } from './salas'
import { legendreF } from './second-route'

export interface Reading {
  readonly printed: number
  readonly corrected: number
  readonly truth: number
  /** Argument of an arcsine that has no real value. */
  readonly argument?: number
  /** The corrected formula where it is another one for this motion. */
  readonly formula?: string
}

export type ErratumName =
  | 'salas-9'
  | 'salas-10'
  | 'salas-25'
  | 'salas-26'
  | 'salas-27'
  | 'salas-28'
  | 'lima-16'
  | 'horsley-3'

export interface Erratum {
  readonly id: ErratumName
  readonly place: string
  readonly symbol: string
  readonly unit: Equality['unit']
  /** Null where the line is not about this motion. */
  readonly of: (now: Moment) => Reading | null
}

/** 2 arcsin of a number that may be too large for it. */
function doubled(argument: number): Pick<Reading, 'printed' | 'argument'> {
  return { printed: 2 * Math.asin(argument), ...(Math.abs(argument) > 1 && { argument }) }
}

function period(id: 'salas-26' | 'salas-27' | 'salas-28'): Erratum {
  return {
    id,
    place: `Salas (${id.slice(-2)})`,
    symbol: '_T_',
    unit: 's',
    of: ({ motion, m, regime }) => {
      if (regime !== 'libration') return null
      const corrected = motion.smallPeriod * RATIONAL[id](m)
      return { printed: corrected / 4, corrected, truth: motion.period }
    },
  }
}

export const ERRATA: readonly Erratum[] = [
  {
    id: 'salas-9',
    place: 'Salas (9)',
    symbol: '_ω_{0}²',
    unit: '1/s²',
    of: (now) => {
      if (now.regime === 'rest' || Math.abs(now.start.c) < 1e-3) return null
      const { u, v } = duffingOf(now.start, now.omega0)
      const { p, q } = coefficientsOf(now)
      // The dots stand on the wrong letters.
      const printed = 2 * p * square(v) + p + q * u ** 4 + 2 * square(u)
      return { printed, corrected: firstOfNine({ u, v }, now), truth: square(now.omega0) }
    },
  },
  {
    id: 'salas-10',
    place: 'Salas (10)',
    symbol: '_p_',
    unit: '1/s²',
    of: (now) => {
      if (now.regime === 'rest' || Math.abs(now.start.c) < 1e-3) return null
      const { u, v } = duffingOf(now.start, now.omega0)
      const printed = -((v ** 4 - 1) * square(now.omega0) + 2 * square(u)) / square(square(v) + 1)
      return { printed, corrected: byStart(now).p, truth: coefficientsOf(now).p }
    },
  },
  {
    id: 'salas-25',
    place: 'Salas (25)',
    symbol: '_T_',
    unit: 's',
    of: (now) => {
      if (now.regime !== 'libration' && now.regime !== 'rotation') return null
      const { quarter, k } = now.elliptic
      const truth = now.motion.period
      // K has no real value beyond 1.
      if (now.regime === 'rotation')
        return { printed: Number.NaN, corrected: (2 * k * quarter) / now.omega0, truth, formula: 'salas-turn' }
      return { printed: quarter / now.omega0, corrected: (4 * quarter) / now.omega0, truth }
    },
  },
  period('salas-26'),
  period('salas-27'),
  period('salas-28'),
  {
    id: 'lima-16',
    place: 'Lima (16)',
    symbol: '_θ_(_t_)',
    unit: 'rad',
    of: (now) => {
      if (now.regime !== 'libration') return null
      const { elliptic, omega0, kappa, motion, t, theta } = now
      const u = omega0 * (t - motion.turned) + elliptic.quarter
      const { sn, dn } = now.jacobi(u, elliptic.parameter)
      return {
        ...doubled(kappa * Math.sin(u)),
        corrected: 2 * Math.atan2(kappa * sn, dn),
        truth: theta,
      }
    },
  },
  {
    id: 'horsley-3',
    place: 'Horsley (3)',
    symbol: '_θ_(_t_)',
    unit: 'rad',
    of: (now) => {
      const { start, kappa, omega0, t, theta, regime } = now
      if (regime !== 'libration' || start.s === 0) return null
      const { parameter } = now.elliptic
      const [sine, side] = [Math.abs(start.s), start.s < 0 ? -1 : 1]
      const phase = legendreF(sine / kappa, Math.abs(start.x) / kappa, parameter)
      // γ₀/√k: the root of k is the sine, and γ₀ is κ over it.
      const printed = (kappa / square(sine)) * Math.sin(phase + (start.x > 0 ? 1 : -1) * omega0 * t)
      const { sn, dn } = now.jacobi(phase + (side * start.x > 0 ? 1 : -1) * omega0 * t, parameter)
      return { ...doubled(printed), corrected: side * 2 * Math.atan2(kappa * sn, dn), truth: theta }
    },
  },
]
