// The module of the fit: columns of a record in, the result out.
//
// A WebAssembly module of its own (wasm/fit), with 128-bit vectors. A fit takes up to seconds and does not let go in between: it is
// called in a worker.

import { Exchange, numberOf, type Statements } from './exchange'
import type { Reading } from './reader-module'

/** A value with its standard uncertainty and the parts of it. */
export interface Estimate {
  readonly value: number
  readonly u: number
  readonly expanded: number
  readonly statistical: number
  readonly model: number
  readonly calibration: number
}

export type ModelName = 'none' | 'linear' | 'quadratic' | 'dry' | 'presliding'

/** What `libration fit --json` prints of one record; null where it is not known. */
export interface Fit {
  readonly model: ModelName
  readonly rms: number
  readonly omega0: Estimate
  readonly g: Estimate | null
  readonly length: Estimate | null
  readonly length_given: boolean
  readonly offset: Estimate | null
  readonly friction: Readonly<Record<Exclude<ModelName, 'none'>, Estimate | null>>
  readonly swing: number | null
  readonly verdicts: readonly string[]
  readonly window: readonly [number, number]
  readonly window_reason: string
  readonly samples: number
  readonly ladder: readonly { readonly model: ModelName; readonly rms: number; readonly omega0: number }[]
  readonly budget: readonly { readonly source: string; readonly u: number }[]
  readonly corrections: readonly { readonly name: string; readonly relative_period: number; readonly made: boolean }[]
  readonly diagnostics: Readonly<Record<string, number | null>>
}

/** A result with the grades of its verdicts, in their order. */
export interface Fitted {
  readonly fit: Fit
  readonly grades: readonly ('note' | 'warning' | 'refuted')[]
  /** Whether no verdict forbids to quote it. */
  readonly stands: boolean
  /** Times in s or turning angles in rad, what was measured, and that less what was fitted: as `--json` prints them. */
  readonly t: Float64Array
  readonly measured: Float64Array
  readonly residual: Float64Array
  /** Of periods: the turning angle of each by the fit, in rad; else empty. */
  readonly swings: Float64Array
}

/** What several records share, as `libration fit --json` prints it, without the records. */
export interface Together {
  readonly omega0: Estimate | null
  readonly g: Estimate | null
  readonly length: Estimate | null
  /** What must be added to every stated length, in m. */
  readonly length_offset: Estimate | null
  readonly chi_squared: readonly [number, number]
  readonly budget: readonly { readonly source: string; readonly u: number }[]
  readonly corrections: Fit['corrections']
  readonly verdicts: readonly string[]
}

/** Several records together, each with what it is alone. */
export interface FittedTogether extends Pick<Fitted, 'grades' | 'stands'> {
  readonly together: Together
  readonly records: readonly Fitted[]
}

/** What the module exports: wasm/fit/src/abi.rs. */
interface FitExports {
  give_column(): void
  give_record(): number
  fit_data(): number
  steps(): void
}

type Graded = Pick<Fitted, 'fit' | 'grades' | 'stands'>

/** A module at work. It holds the records that it was given. */
export class FitModule {
  /** Names of the steps of a fit, in their order. */
  readonly steps: readonly string[]
  readonly #exchange: Exchange<FitExports>

  private constructor(exchange: Exchange<FitExports>) {
    this.#exchange = exchange
    exchange.exports.steps()
    this.steps = exchange.answer().split('\n')
  }

  /**
   * Starts a compiled module.
   *
   * @param told Called with the number of each step of a fit when it begins.
   */
  static async start(module: WebAssembly.Module, told: (step: number) => void = () => {}): Promise<FitModule> {
    const number = (at: number, length: number): number => numberOf(exchange.text(at, length))
    const { exports } = await WebAssembly.instantiate(module, { page: { step: told, number } })
    const exchange = new Exchange<FitExports>(exports)
    return new FitModule(exchange)
  }

  /** Gives a record as it was read, beside those before where `beside` is stated. */
  give({ measured, x, y, dark }: Pick<Reading, 'measured' | 'x' | 'y' | 'dark'>, stated: Statements): void {
    const { exports } = this.#exchange
    for (const column of dark.length > 0 ? [x, y, dark] : [x, y]) {
      this.#exchange.write(new Uint8Array(column.buffer, column.byteOffset, column.byteLength))
      exports.give_column()
    }
    this.#exchange.asked(() => exports.give_record(), [...stated, ['measured', measured]])
  }

  /** Fits what was given last; a FitRefusal where it holds no motion. */
  fit(stated: Statements): Fitted {
    return this.#withColumns(
      this.#exchange.asked<Graded>(() => this.#exchange.exports.fit_data(), stated),
      0,
    )
  }

  /** Fits all records that were given, each after the first with a statement `beside`. */
  fitTogether(stated: Statements): FittedTogether {
    const found = this.#exchange.asked<Omit<FittedTogether, 'records'> & { readonly records: readonly Graded[] }>(
      () => this.#exchange.exports.fit_data(),
      stated,
    )
    return { ...found, records: found.records.map((record, i) => this.#withColumns(record, i)) }
  }

  #withColumns(record: Graded, place: number): Fitted {
    const column = (number: number) => this.#exchange.column(4 * place + number)
    return { ...record, t: column(0), measured: column(1), residual: column(2), swings: column(3) }
  }
}
