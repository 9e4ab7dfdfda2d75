// Equalities of Lima's way: the equation of z, the harmonic form with the exact period, and the Fourier series of sn (Lima 2019).

import { remember } from '../memory'
import type { Model, Parameter } from '../model'
import { type Equality, one, SWING, square } from './equality'
import type { Moment } from './moment'

/** Terms that Lima's series is shown with. */
export const TERMS = 4

interface Series {
  readonly q: number
  /** b₁, b₃, b₅ …, down to what a double does not see. */
  readonly b: readonly number[]
  /** b₁ as the integral (19), by the sum over even places of a period, which converges as fast as the series. */
  readonly first: number
}

/** Places of that sum: enough for a nome of 0.9, which no start in doubles exceeds. */
const PLACES = 512

const seriesOf = remember((model: Model, m: number, mc: number): Series => {
  const parameter: Parameter = { m, mc }
  const quarter = model.completeK(parameter)
  const q = model.nome(parameter)
  const b: number[] = []
  for (let n = 1; n === 1 || (b.at(-1) as number) > 1e-17 * (b[0] as number); n++) b.push(coefficient(n, q, m, quarter))
  const x = Float64Array.from({ length: PLACES }, (_, i) => (2 * Math.PI * i) / PLACES)
  const { sn } = model.jacobi(
    x.map((each) => (2 * quarter * each) / Math.PI),
    parameter,
  )
  const first = (2 / PLACES) * x.reduce((sum, each, i) => sum + (sn[i] as number) * Math.sin(each), 0)
  return { q, b, first }
})

function coefficient(n: number, q: number, m: number, quarter: number): number {
  return ((2 * Math.PI) / (Math.sqrt(m) * quarter)) * (q ** (n - 0.5) / (1 - q ** (2 * n - 1)))
}

export const seriesAt = ({ model, m, mc }: Moment): Series => seriesOf(model, m, mc)

/** The first terms of (20) at an argument; all of them without a number. */
function partial(now: Moment, u: number, terms?: number): number {
  const { b } = seriesAt(now)
  const x = (Math.PI * u) / (2 * now.elliptic.quarter)
  return b.slice(0, terms).reduce((sum, each, i) => sum + each * Math.sin((2 * i + 1) * x), 0)
}

const fourier = { name: 'fourier', argument: TERMS, on: true } as const

export const LIMA: readonly Equality[] = [
  {
    id: 'z-equation',
    tag: 'Lima (14)',
    unit: '1/s²',
    of: SWING,
    left: (now) => {
      const { theta, velocity } = now.track
      return now.slope(velocity.map((each, i) => (each * Math.cos((theta[i] as number) / 2)) / (2 * now.kappa)))
    },
    right: ({ omega0, now, kappa, m }) => {
      const z = now.s / kappa
      return -square(omega0) * ((1 + m) * z - 2 * m * z ** 3)
    },
    size: ({ omega0 }) => square(omega0),
  },
  {
    id: 'ratio',
    tag: 'Lima (10)',
    unit: '',
    of: SWING,
    left: ({ motion }) => motion.period / motion.smallPeriod,
    right: ({ elliptic }) => (2 / Math.PI) * elliptic.quarter,
  },
  {
    id: 'period-series',
    tag: '',
    unit: '',
    of: SWING,
    left: (now) => now.model.periodRatio('series:4', Float64Array.of(now.motion.thetaMax))[0] ?? Number.NaN,
    right: ({ motion: { thetaMax } }) => 1 + square(thetaMax) / 16 + (11 * thetaMax ** 4) / 3072,
  },
  {
    id: 'harmonic',
    tag: 'Lima (17)',
    unit: 'rad',
    of: SWING,
    left: (now) => now.approximate({ name: 'harmonic', on: true }),
    right: ({ motion, t, turned }) => motion.thetaMax * Math.cos((2 * Math.PI * (t - turned.right)) / motion.period),
    size: ({ motion }) => motion.thetaMax,
  },
  {
    id: 'nome',
    tag: 'Lima, after (20)',
    unit: '',
    of: SWING,
    left: (now) => seriesAt(now).q,
    right: ({ model, m, mc, elliptic }) => Math.exp((-Math.PI * model.completeK({ m: mc, mc: m })) / elliptic.quarter),
  },
  {
    id: 'coefficient',
    tag: 'Lima (19), (20)',
    unit: '',
    of: SWING,
    left: (now) => seriesAt(now).first,
    right: (now) => seriesAt(now).b[0] ?? Number.NaN,
  },
  {
    id: 'series',
    tag: 'Lima (20)',
    unit: '',
    of: SWING,
    left: ({ elliptic }) => elliptic.sn,
    right: (now) => partial(now, now.elliptic.u),
    size: one,
  },
  {
    id: 'fourier',
    tag: 'Lima (22)',
    unit: 'rad',
    of: SWING,
    left: (now) => now.approximate(fourier),
    right: (now) => 2 * Math.asin(now.kappa * partial(now, now.elliptic.u, TERMS)),
    size: ({ motion }) => motion.thetaMax,
    // Where the terms make the sine larger than 1.
    undefinedAt: (now) => Math.abs(now.kappa * partial(now, now.elliptic.u, TERMS)) > 1,
  },
  {
    id: 'series-sum',
    tag: 'Lima, after (23)',
    unit: '',
    of: SWING,
    left: (now) => {
      const { q, b } = seriesAt(now)
      return b.reduce((sum, _, i) => sum + ((i % 2 === 0 ? 1 : -1) * q ** (i + 0.5)) / (1 - q ** (2 * i + 1)), 0)
    },
    right: ({ kappa, elliptic }) => (kappa * elliptic.quarter) / (2 * Math.PI),
  },
]
