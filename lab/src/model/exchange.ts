// What the page and a module of the reader, the fit or a period exchange (wasm/fit/src/abi/exchange.rs): statements and columns in, JSON and
// columns out.

import { doubleOf, withDigits } from './digits'

/** What is stated: pairs of a name and a value. */
export type Statements = readonly (readonly [name: string, value: string])[]

/** Why there is no record or no fit: the line that the command prints. */
export class FitRefusal extends Error {
  override readonly name = 'FitRefusal'
}

/** What every module exports. */
interface CommonExports {
  memory: WebAssembly.Memory
  room(text: number, length: number): number
  answer(): number
  answer_length(): number
  column(number: number): number
  column_length(number: number): number
}

const BYTES = 0
const STATED = 1

/** Marks the bits of a double in JSON (wasm/fit/src/json.rs). */
const NUMBER = '\u0003'

/** A number from its text; NaN where it is none. */
export const numberOf = (text: string): number => (text.trim() === '' ? Number.NaN : Number(text))

function doubled(_: string, value: unknown): unknown {
  if (typeof value !== 'string') return value
  return value.startsWith(NUMBER) ? doubleOf(value.slice(1)) : withDigits(value)
}

/** A module at work. */
export class Exchange<Own extends object> {
  readonly exports: Own
  readonly #own: CommonExports

  /** What WebAssembly exports. */
  constructor(exports: WebAssembly.Exports) {
    this.exports = exports as unknown as Own
    this.#own = exports as unknown as CommonExports
  }

  /** Asks with bytes and statements; a FitRefusal where the answer is one. */
  asked<Answer>(work: () => number, stated: Statements, bytes?: Uint8Array): Answer {
    if (bytes) this.write(bytes)
    // A line is one statement, so a value has no line of its own.
    const lines = stated.map(([name, value]) => `${name}\t${value.replace(/[\r\n]+/g, ' ')}`)
    this.#write(STATED, new TextEncoder().encode(lines.join('\n')))
    const kept = work()
    const answer = this.answer()
    if (kept === 0) throw new FitRefusal(withDigits(answer))
    return answer === '' ? (undefined as Answer) : JSON.parse(answer, doubled)
  }

  /** Writes the bytes of a file or a column. */
  write(bytes: Uint8Array): void {
    this.#write(BYTES, bytes)
  }

  #write(text: number, bytes: Uint8Array): void {
    const at = this.#own.room(text, bytes.length)
    new Uint8Array(this.#own.memory.buffer, at, bytes.length).set(bytes)
  }

  answer(): string {
    return this.text(this.#own.answer(), this.#own.answer_length())
  }

  text(at: number, length: number): string {
    return new TextDecoder().decode(new Uint8Array(this.#own.memory.buffer, at, length))
  }

  /** A column of the answer; none of it has no rows. */
  column(number: number): Float64Array {
    const rows = this.#own.column_length(number)
    return rows === 0
      ? new Float64Array()
      : new Float64Array(this.#own.memory.buffer, this.#own.column(number), rows).slice()
  }
}
