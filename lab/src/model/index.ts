// The only room that knows the core: exact motions, curves and functions in the terms of the page. No formula of its own.

import { approx, elliptic, load, loadSecond, Pendulum } from 'libration'
import { type Curve, curveKey } from '../curves'
import { Motion, type Setup } from './motion'
import { secondIsLoaded, secondLoaded } from './second'

export type { Regime } from 'libration'
export { type Arrays, KeptArrays, newArrays } from './arrays'
export { type Energy, MOST_STEPS, Motion, type Setup } from './motion'
export type { Compared, Largest, Refusal, Solution, Track } from './solution'

/** What is known of a formula before it is asked anything. */
export interface Known {
  readonly name: string
  readonly formula: string
  readonly source: string
  readonly stated: string
  /** In rad; null where its author states none. */
  readonly statedRange: readonly [number, number] | null
  readonly orders: { readonly least: number; readonly most: number; readonly step: number } | null
}

function known(entries: readonly approx.Entry[]): Known[] {
  return entries.map((entry) => ({
    name: entry.name,
    formula: entry.formula,
    source: entry.source,
    stated: entry.stated,
    statedRange: entry.statedRange ?? null,
    orders: entry.orders ?? null,
  }))
}

/** The parameter of the elliptic functions and its complement 1 − m. */
export interface Parameter {
  readonly m: number
  readonly mc: number
}

const smaller = ({ m, mc }: Parameter): { m: number } | { mc: number } => (mc < m ? { mc } : { m })

export class Model {
  /** Whether formulas of the period and elliptic functions are there. */
  readonly complete = secondLoaded()

  /** Formulas of the angle and, once complete, of the period, in the order of the registry. */
  readonly angles: readonly Known[] = known(approx.angle.entries)
  readonly periods: readonly Known[] = secondLoaded() ? known(approx.period.entries) : []

  motion(setup: Setup): Motion {
    return new Motion(setup)
  }

  /** Largest angle for which the author offers the formula; null if none is stated. */
  statedMost(name: string): number | null {
    return this.angles.find((each) => each.name === name)?.statedRange?.[1] ?? null
  }

  readonly #ends = new Map<string, number>()

  /** Turning angle in rad from which a formula has no value somewhere in a swing, to 1e-6; found by halving, once. */
  undefinedAbove(curve: Curve): number {
    const key = curveKey(curve)
    const before = this.#ends.get(key)
    if (before !== undefined) return before
    const formula = approx.angle(key)
    let [low, high] = [0, Math.PI]
    while (high - low > 1e-6) {
      const middle = (low + high) / 2
      const { undefinedFrom } = formula.of(new Pendulum({ theta0: middle })).error(1)
      if (Number.isNaN(undefinedFrom)) low = middle
      else high = middle
    }
    this.#ends.set(key, high)
    return high
  }

  /** T/T₀ by a formula of the period, at turning angles in rad. */
  periodRatio(name: string, thetaMax: Float64Array): Float64Array {
    return approx.period(name).ratio({ thetaMax })
  }

  /** Its relative error, without cancellation. */
  periodError(name: string, thetaMax: Float64Array): Float64Array {
    return approx.period(name).error({ thetaMax })
  }

  jacobi(
    u: Float64Array,
    parameter: Parameter,
  ): { readonly sn: Float64Array; readonly cn: Float64Array; readonly dn: Float64Array; readonly am: Float64Array } {
    return elliptic.jacobi(u, smaller(parameter))
  }

  completeK(parameter: Parameter): number {
    return elliptic.completeK(smaller(parameter))
  }

  nome(parameter: Parameter): number {
    return elliptic.nome(smaller(parameter))
  }
}

/** Loads the core: the module with vectors where the browser has them, else the scalar one. */
export async function openModel(sources?: Parameters<typeof load>[0]): Promise<Model> {
  await load(sources)
  return new Model()
}

/** The model with all that is in the second module. */
export async function completedModel(source?: Parameters<typeof loadSecond>[0]): Promise<Model> {
  await loadSecond(source)
  secondIsLoaded()
  return new Model()
}
