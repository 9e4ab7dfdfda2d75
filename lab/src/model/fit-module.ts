// The module of the reader and the fit: bytes of a file in, what was understood and the result out.
//
// A WebAssembly module of its own (wasm/fit), with 128-bit vectors. A fit takes up to seconds and does not let go in between: it is
// called in a worker.

/** What is stated about a file and its pendulum: pairs of a name and a value (wasm/fit/src/stated.rs). */
export type Statements = readonly (readonly [name: string, value: string])[]

/** What was understood of a file. */
export interface Understood {
  readonly kind: 'samples' | 'gate' | 'swings'
  readonly measured: 'angle' | 'velocity' | 'acceleration' | 'gate' | 'swings'
  /** The run that was read, from 1, and how many there are. */
  readonly run: readonly [number, number]
  /** Each guess as one sentence. */
  readonly understood: readonly string[]
  /** What was left out, a sentence each. */
  readonly dropped: readonly string[]
  readonly columns: readonly { readonly what: string; readonly name: string }[]
  /** Times in s, or turning angles in rad; what is fitted, in SI units. */
  readonly x: readonly number[]
  readonly y: readonly number[]
}

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
  readonly residuals: {
    readonly t: readonly number[]
    readonly measured: readonly number[]
    readonly residual: readonly number[]
  }
}

/** A result with the grades of its verdicts, in their order. */
export interface Fitted {
  readonly fit: Fit
  readonly grades: readonly ('note' | 'warning' | 'refuted')[]
  /** Whether no verdict forbids to quote it. */
  readonly stands: boolean
  /** Of periods: the turning angle of each by the fit, in rad. */
  readonly swings: readonly number[]
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

/** g from a period, and the normal g of a place, in m/s^2; null where nothing was stated for it. */
export interface PeriodGravity {
  readonly found: { readonly g: Estimate; readonly budget: Fit['budget']; readonly small_swings: number } | null
  readonly normal: number | null
}

/** Why there is no record or no fit: the line that the command prints. */
export class FitRefusal extends Error {
  override readonly name = 'FitRefusal'
}

/** What the module exports: wasm/fit/src/abi.rs. */
interface Exports {
  memory: WebAssembly.Memory
  room(text: number, length: number): number
  answer(): number
  answer_length(): number
  read_file(): number
  fit_data(): number
  gravity(): number
  steps(): void
}

const FILE = 0
const STATED = 1

/** A module at work. It holds the record that was read last. */
export class FitModule {
  /** Names of the steps of a fit, in their order. */
  readonly steps: readonly string[]
  readonly #exports: Exports

  private constructor(exports: Exports) {
    this.#exports = exports
    exports.steps()
    this.steps = this.#answer().split('\n')
  }

  /**
   * Starts a compiled module.
   *
   * @param told Called with the number of each step of a fit when it begins.
   */
  static async start(module: WebAssembly.Module, told: (step: number) => void = () => {}): Promise<FitModule> {
    const { exports } = await WebAssembly.instantiate(module, { page: { step: told } })
    return new FitModule(exports as unknown as Exports)
  }

  /** Reads a file; a FitRefusal where it cannot be read, or leaves a question open. */
  read(file: Uint8Array, stated: Statements): Understood {
    this.#write(FILE, file)
    return this.#asked(stated, () => this.#exports.read_file())
  }

  /** Fits what was read last; a FitRefusal where it holds no motion. */
  fit(stated: Statements): Fitted {
    return this.#asked(stated, () => this.#exports.fit_data())
  }

  /** Fits all records that were read, each after the first with a statement `beside`. */
  fitTogether(stated: Statements): FittedTogether {
    return this.#asked(stated, () => this.#exports.fit_data())
  }

  /** g from a period and of a place (wasm/fit/src/period.rs); a FitRefusal where a value is out of its range. */
  gravity(stated: Statements): PeriodGravity {
    return this.#asked(stated, () => this.#exports.gravity())
  }

  #asked<Answer>(stated: Statements, work: () => number): Answer {
    // A line is one statement, so a value has no line of its own.
    const lines = stated.map(([name, value]) => `${name}\t${value.replace(/[\r\n]+/g, ' ')}`)
    this.#write(STATED, new TextEncoder().encode(lines.join('\n')))
    const kept = work()
    const answer = this.#answer()
    if (kept === 0) throw new FitRefusal(answer)
    return JSON.parse(answer)
  }

  #write(text: number, bytes: Uint8Array): void {
    const at = this.#exports.room(text, bytes.length)
    new Uint8Array(this.#exports.memory.buffer, at, bytes.length).set(bytes)
  }

  #answer(): string {
    const { memory } = this.#exports
    return new TextDecoder().decode(
      new Uint8Array(memory.buffer, this.#exports.answer(), this.#exports.answer_length()),
    )
  }
}
