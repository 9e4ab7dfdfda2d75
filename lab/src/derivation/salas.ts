// Equalities of Salas's way: u = tan(θ/2) obeys Duffing's equation, whose solution is a cn; any start in one formula (Salas 2019).

import { type Equality, MOVING, SWING, square } from './equality'
import type { Half, Moment } from './moment'
import { MOTION } from './motion'
import { STEPS } from './steps'

/** Salas's variable and its velocity. */
export function duffingOf({ s, c, x }: Half, omega0: number): { readonly u: number; readonly v: number } {
  return { u: s / c, v: (omega0 * x) / square(c) }
}

/** p and q of ü + p u + q u³ = 0 by the energy: without a difference where the energy is next to that of the top. */
export function coefficientsOf({ omega0, m, mc }: Moment): { readonly p: number; readonly q: number } {
  return { p: square(omega0) * (1 - 2 * m), q: 2 * square(omega0) * mc }
}

/** At the top u is infinite. */
const atTop = ({ start, now }: Moment): boolean => Math.abs(start.c) < 1e-3 || Math.abs(now.c) < 1e-3
const startAtTop = ({ start }: Moment): boolean => Math.abs(start.c) < 1e-3

/** p and q by the start, Salas (10). */
export function byStart({ start, omega0 }: Moment): { readonly p: number; readonly q: number } {
  const { u, v } = duffingOf(start, omega0)
  const w = square(omega0)
  return {
    p: -((u ** 4 - 1) * w + 2 * square(v)) / square(square(u) + 1),
    q: (2 * ((square(u) + 1) * w - square(v))) / square(square(u) + 1),
  }
}

/** Left side of the first line of (9) without ω². */
export function firstOfNine({ u, v }: { readonly u: number; readonly v: number }, now: Moment): number {
  const { p, q } = coefficientsOf(now)
  return 2 * p * square(u) + p + q * u ** 4 + 2 * square(v)
}

/** cn and sn dn of the start's own clock, with the parameter m of any size. */
function ownClock(now: Moment) {
  const { sn, cn, dn } = now.jacobi(now.omega0 * now.t, { m: now.m, mc: now.mc })
  return { sn, cn, dn }
}

/** Amplitude and phase of the cn form. */
const amplitude = (now: Moment): number => Math.sqrt(now.m / now.mc)

/** b with the whole turns that bring it next to a. */
const beside = (a: number, b: number): number => b + 2 * Math.PI * Math.round((a - b) / (2 * Math.PI))

/** (23), both parts of the fraction multiplied by cos²(θ₀/2), so that 180° has a value; the one below without a difference. */
function salas23(now: Moment): number {
  const { s, c, x } = now.start
  const { sn, cn, dn } = ownClock(now)
  return 2 * Math.atan2(s * c * cn + x * dn * sn, square(c * cn) + now.mc * square(sn))
}

/** An equality of the other ways in Salas's letters. */
function again(id: string, name: string, tag = 'Salas (25)'): Equality {
  const found = [...STEPS, ...MOTION].find((each) => each.id === id)
  if (!found) throw new Error(`no equality ${id}`)
  return { ...found, id: name, tag }
}

const rational = (name: string, of: (m: number) => number): Equality => ({
  id: name,
  tag: `Salas (${name.slice(-2)})`,
  unit: '',
  of: SWING,
  left: ({ model, motion }) => model.periodRatio(name, Float64Array.of(motion.thetaMax))[0] ?? Number.NaN,
  right: ({ m }) => of(m),
})

export const RATIONAL = {
  'salas-26': (m: number) => (5 * m - 16) / (9 * m - 16),
  'salas-27': (m: number) => (409 * m ** 2 - 3984 * m + 4864) / (1025 * m ** 2 - 5200 * m + 4864),
  'salas-28': (m: number) =>
    (540191 * m ** 3 - 10617024 * m ** 2 + 32584960 * m - 24653824) /
    (1708091 * m ** 3 - 16837184 * m ** 2 + 38748416 * m - 24653824),
} as const

export const SALAS: readonly Equality[] = [
  {
    id: 'duffing',
    tag: 'Salas (6)',
    unit: '1/s²',
    of: MOVING,
    left: ({ acceleration, velocity, now }) => {
      const { u } = duffingOf(now, 1)
      return (acceleration / 2 + (square(velocity) / 2) * u) / square(now.c)
    },
    right: (now) => {
      const { p, q } = coefficientsOf(now)
      const { u } = duffingOf(now.now, now.omega0)
      return -p * u - q * u ** 3
    },
    size: ({ velocity, now, strongest }) =>
      (strongest + (square(velocity) * Math.abs(now.s / now.c)) / 2) / square(now.c),
    undefinedAt: atTop,
  },
  {
    id: 'duffing-energy',
    tag: 'Salas (7)',
    unit: '1/s²',
    of: MOVING,
    left: (now) => duffingEnergy(now, now.now).value,
    right: (now) => duffingEnergy(now, now.start).value,
    size: (now) => duffingEnergy(now, now.now).size + duffingEnergy(now, now.start).size,
    undefinedAt: atTop,
  },
  {
    id: 'nine-first',
    tag: 'Salas (9)',
    unit: '1/s²',
    of: MOVING,
    left: (now) => firstOfNine(duffingOf(now.start, now.omega0), now),
    right: ({ omega0 }) => square(omega0),
    size: (now) => {
      const { u, v } = duffingOf(now.start, now.omega0)
      const { p, q } = coefficientsOf(now)
      return 2 * Math.abs(p) * u * u + Math.abs(q) * u ** 4 + 2 * v * v
    },
    undefinedAt: startAtTop,
  },
  {
    id: 'nine-second',
    tag: 'Salas (9)',
    unit: '1/s²',
    of: MOVING,
    left: (now) => coefficientsOf(now).q - coefficientsOf(now).p,
    right: ({ omega0 }) => square(omega0),
    size: (now) => Math.abs(coefficientsOf(now).p),
  },
  {
    id: 'ten-p',
    tag: 'Salas (10), (23)',
    unit: '1/s²',
    of: MOVING,
    left: (now) => coefficientsOf(now).p,
    right: (now) => byStart(now).p,
    size: ({ omega0, m }) => square(omega0) * (1 + m),
    undefinedAt: startAtTop,
  },
  {
    id: 'ten-q',
    tag: 'Salas (10), (23)',
    unit: '1/s²',
    of: MOVING,
    left: (now) => coefficientsOf(now).q,
    right: (now) => byStart(now).q,
    size: ({ omega0, m }) => square(omega0) * (1 + m),
    undefinedAt: startAtTop,
  },
  {
    id: 'duffing-rate',
    tag: 'Salas (13)',
    unit: '1/s²',
    of: SWING,
    left: (now) => coefficientsOf(now).q * square(amplitude(now)) + coefficientsOf(now).p,
    right: ({ omega0 }) => square(omega0),
  },
  {
    id: 'duffing-parameter',
    tag: 'Salas (13)',
    unit: '',
    of: SWING,
    left: (now) => {
      const { p, q } = coefficientsOf(now)
      const qc = q * square(amplitude(now))
      return qc / (2 * (qc + p))
    },
    right: ({ m }) => m,
  },
  {
    id: 'duffing-solution',
    tag: 'Salas (5), (13)',
    unit: '',
    of: SWING,
    left: ({ now }) => now.s / now.c,
    right: (now) => {
      const { quarter, u, parameter } = now.elliptic
      return amplitude(now) * now.jacobi(u - quarter, parameter).cn
    },
    size: amplitude,
  },
  {
    id: 'any-start',
    tag: 'Salas (23)',
    unit: 'rad',
    of: MOVING,
    left: ({ theta }) => theta,
    right: (now) => beside(now.theta, salas23(now)),
    size: () => Math.PI,
  },
  again('period', 'salas-period'),
  again('turn-period', 'salas-turn'),
  again('turn-theta', 'salas-turn-theta', ''),
  again('limit-theta', 'salas-limit-theta', ''),
  rational('salas-26', RATIONAL['salas-26']),
  rational('salas-27', RATIONAL['salas-27']),
  rational('salas-28', RATIONAL['salas-28']),
  {
    id: 'trigonometric',
    tag: 'Salas (35)',
    unit: 'rad',
    of: SWING,
    left: (now) => now.approximate({ name: 'trigonometric', on: true }),
    right: ({ motion: { thetaMax }, omega0, t, turned }) => {
      const x = square(thetaMax)
      const rate = omega0 * Math.sqrt(1 - (10 * x) / 81 + square(x) / 262)
      const flattening = (243 * square(x) - 2620 * x) / (243 * square(x) - 7860 * x + 63666)
      const angle = rate * (t - turned.last)
      return (turned.side * thetaMax * Math.cos(angle)) / Math.sqrt(1 + flattening * square(Math.sin(angle)))
    },
    size: ({ motion }) => motion.thetaMax,
  },
]

function duffingEnergy(now: Moment, half: Half): { readonly value: number; readonly size: number } {
  const { p, q } = coefficientsOf(now)
  const { u, v } = duffingOf(half, now.omega0)
  const [kinetic, linear, cubic] = [square(v), p * square(u), (q / 2) * u ** 4]
  return { value: kinetic + linear + cubic, size: kinetic + Math.abs(linear) + Math.abs(cubic) }
}
