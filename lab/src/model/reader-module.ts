// The module of the reader: bytes of a file in, what was understood and its numbers out. A WebAssembly module of its own (wasm/reader).

import { Exchange, numberOf, type Statements } from './exchange'

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
}

/** A file as it was understood. */
export interface Reading extends Understood {
  /** Times in s, or turning angles in rad; what is fitted, in SI units. */
  readonly x: Float64Array
  readonly y: Float64Array
  /** Of a light gate, how long it was dark at each time, where that is known; else empty. */
  readonly dark: Float64Array
}

export class ReaderModule {
  readonly #exchange: Exchange<{ read_file(): number }>

  private constructor(exports: WebAssembly.Exports) {
    this.#exchange = new Exchange(exports)
  }

  /** Starts a compiled module. */
  static async start(module: WebAssembly.Module): Promise<ReaderModule> {
    const number = (at: number, length: number): number => numberOf(reader.#exchange.text(at, length))
    const reader: ReaderModule = new ReaderModule((await WebAssembly.instantiate(module, { page: { number } })).exports)
    return reader
  }

  /** Reads a file, with statements of wasm/reader/src/stated.rs; a FitRefusal where it cannot be read, or leaves a question open. */
  read(file: Uint8Array, stated: Statements): Reading {
    const { exports } = this.#exchange
    const understood = this.#exchange.asked<Understood>(() => exports.read_file(), stated, file)
    const [x, y, dark] = [0, 1, 2].map((number) => this.#exchange.column(number)) as [
      Float64Array,
      Float64Array,
      Float64Array,
    ]
    return { ...understood, x, y, dark }
  }
}
