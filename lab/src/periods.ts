// The formulas of the period that can be drawn: names as in libration's registry, what N may be, and what each wears.
//
// A formula is written `lima-arun` or `agm:1`: the name, then N. The plain dash of a family belongs to its usual member.

import type { Fault } from './state'

interface PeriodKind {
  readonly clothes: string
  readonly orders?: { readonly least: number; readonly most: number; readonly step: number; readonly usual: number }
}

const kind = (clothes: string, orders?: PeriodKind['orders']): PeriodKind =>
  orders ? { clothes, orders } : { clothes }

export const PERIOD_KINDS = {
  linear: kind('c-linear'),
  bernoulli: kind('c-polynomial'),
  series: kind('c-polynomial second', { least: 2, most: 200, step: 2, usual: 4 }),
  denman: kind('c-polynomial third'),
  'kidd-fogg': kind('c-harmonic'),
  molina: kind('c-harmonic second'),
  'ganley-parwani': kind('c-fourier second'),
  'lima-arun': kind('c-fourier'),
  agm: kind('c-integrator second', { least: 1, most: 8, step: 1, usual: 1 }),
  belendez: kind('c-integrator'),
  cromer: kind('c-euler'),
  chachiyo: kind('c-euler second'),
  'salas-26': kind('c-trigonometric second'),
  'salas-27': kind('c-trigonometric'),
  'salas-28': kind('c-trigonometric third'),
} as const satisfies Record<string, PeriodKind>

export type PeriodName = keyof typeof PERIOD_KINDS
export const PERIOD_NAMES = Object.keys(PERIOD_KINDS) as PeriodName[]

/** What is drawn if a link does not say otherwise: one of each family, and the first that names a range. */
export const USUAL_PERIODS: readonly string[] = [
  'linear',
  'bernoulli',
  'kidd-fogg',
  'lima-arun',
  'belendez',
  'cromer',
  'salas-27',
]

export function periodKind(name: PeriodName): PeriodKind {
  return PERIOD_KINDS[name]
}

function isPeriodName(name: string): name is PeriodName {
  return Object.hasOwn(PERIOD_KINDS, name)
}

/** The name without N. */
export function baseOf(key: string): PeriodName {
  return key.split(':')[0] as PeriodName
}

/** `agm:1` of `agm`: with its usual N. */
function usualKey(name: PeriodName): string {
  const { orders } = periodKind(name)
  return orders ? `${name}:${orders.usual}` : name
}

/** A formula as it is written, or what is wrong with it. */
export function readPeriod(text: string): string | Fault {
  const [name = '', given, ...rest] = text.split(':')
  if (!isPeriodName(name) || rest.length > 0) {
    return { kind: 'not-one-of', name: 'periods', value: text, allowed: PERIOD_NAMES }
  }
  const { orders } = periodKind(name)
  if (given === undefined) return usualKey(name)
  const n = Number(given)
  if (!orders) return { kind: 'not-one-of', name: 'periods', value: text, allowed: PERIOD_NAMES }
  const holds = /^\d+$/.test(given) && n >= orders.least && n <= orders.most && (n - orders.least) % orders.step === 0
  return holds ? `${name}:${n}` : { kind: 'argument', value: text, least: orders.least, most: orders.most }
}

export interface PeriodRow {
  readonly name: PeriodName
  /** With N. */
  readonly key: string
  readonly on: boolean
}

/** Every formula of the registry, in its order, and whether it is drawn. */
export function periodRows(periods: readonly string[] | null): PeriodRow[] {
  const on = periods ?? USUAL_PERIODS
  return PERIOD_NAMES.map((name) => {
    const key = on.find((each) => baseOf(each) === name)
    return { name, key: key ?? usualKey(name), on: key !== undefined }
  })
}

/** The list with a formula switched on or off, or with another N; in the order of the registry. */
export function withPeriod(periods: readonly string[] | null, key: string, on: boolean): string[] {
  const name = baseOf(key)
  return periodRows(periods).flatMap((row) => (row.name === name ? (on ? [key] : []) : row.on ? [row.key] : []))
}
