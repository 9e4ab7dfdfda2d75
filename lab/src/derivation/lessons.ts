// The three ways through the derivation and what stands in each step: a paragraph, a figure, a table, an equality or an erratum.

import type { Equality } from './equality'
import type { ErratumName } from './errata'
import { LIMA } from './lima'
import { MOTION } from './motion'
import { SALAS } from './salas'
import { STEPS } from './steps'

/** Every equality that is displayed somewhere. */
export const EQUALITIES: readonly Equality[] = [...STEPS, ...MOTION, ...LIMA, ...SALAS]

type FigureName = 'forces' | 'circle'
export type TableName = 'coefficients' | 'errors'

/** `p` is the next paragraph of the step's words. */
export type Block =
  | { readonly kind: 'p' }
  | { readonly kind: 'kind-of-motion' }
  | { readonly kind: 'figure'; readonly name: FigureName }
  | { readonly kind: 'table'; readonly name: TableName }
  | { readonly kind: 'equality'; readonly equality: Equality }
  | { readonly kind: 'erratum'; readonly name: ErratumName }

export interface Step<Name extends string = string> {
  readonly name: Name
  readonly blocks: readonly Block[]
}

const BY_NAME = new Map(EQUALITIES.map((each) => [each.id, each]))

/** `p`, `!` and an erratum, `figure:`, `table:`, or the name of an equality. */
function block(text: string): Block {
  if (text === 'p') return { kind: 'p' }
  if (text === 'kind-of-motion') return { kind: 'kind-of-motion' }
  if (text.startsWith('!')) return { kind: 'erratum', name: text.slice(1) as ErratumName }
  const [kind, name] = text.split(':')
  if (kind === 'figure' || kind === 'table') return { kind, name } as Block
  const equality = BY_NAME.get(text)
  if (!equality) throw new Error(`no equality ${text}`)
  return { kind: 'equality', equality }
}

function steps<Name extends string>(given: Readonly<Record<Name, string>>): Step<Name>[] {
  return (Object.keys(given) as Name[]).map((name) => ({ name, blocks: given[name].split(' ').map(block) }))
}

export const LESSONS = {
  novice: steps({
    force: 'p figure:forces p newton p omega0 pendulum p',
    energy: 'p multiplied p energy p half-angle',
    kind: 'p kappa circle figure:circle kind-of-motion turning separatrix p',
    substitution: 'p sine cosine p phi-rate p turn-angle turn-rate',
    integral: 'p time p quarter period !salas-25 p mean p turn-time turn-period',
    inversion: 'p sn cn dn p ellipse chord p',
    solution:
      'p start-sine start-cosine p theta velocity !horsley-3 p turn-theta turn-velocity p limit-theta limit-velocity',
    small: 'p small-sn small-period p small-theta p',
    dropped: 'p ratio period-series p harmonic p table:errors p',
  }),
  lima: steps({
    motion: 'p pendulum speed p turning',
    integral: 'p sine phi-rate time p quarter period ratio',
    inversion: 'p sn cn dn sn-slope sn-second p z-equation p',
    solution: 'p theta !lima-16 velocity p',
    harmonic: 'p harmonic p',
    series: 'p coefficient nome series table:coefficients p fourier p',
    errors: 'p series-sum p table:errors p',
  }),
  salas: steps({
    motion: 'p pendulum kappa circle kind-of-motion',
    duffing: 'p duffing p duffing-energy',
    coefficients: 'p nine-first nine-second !salas-9 p ten-p ten-q !salas-10 p',
    cosine: 'p duffing-rate duffing-parameter p duffing-solution p',
    start: 'p any-start p salas-turn-theta salas-limit-theta p',
    period: 'p salas-period salas-turn !salas-25 p salas-26 !salas-26 salas-27 !salas-27 salas-28 !salas-28 p',
    trigonometric: 'p trigonometric p table:errors',
  }),
} as const
