// What a text of code is about: the start of a pendulum in words of a language of programs, and what the comments say.

import type { Regime } from '../model'

/** What the comments of the texts say, in the reader's language. */
export interface Comments {
  readonly equation: string
  readonly parameter: string
  readonly energy: string
  readonly complement: string
  readonly incomplete: string
  readonly ownFunctions: string
  readonly turns: string
  readonly separatrix: string
  readonly unit: string
  readonly rest: string
}

/** The start of a pendulum as the texts write it. */
export interface Given {
  readonly kind: Regime
  /** In degrees where a short number of them is the angle, else in radians. */
  readonly angle: { readonly degrees: string } | { readonly radians: string }
  readonly velocity: string
  readonly length: string
  readonly gravity: string
  /** Of the velocity. */
  readonly sign: 1 | -1
  readonly times: readonly string[]
  readonly say: Comments
}

/** The lines of a text, one for each that is said. */
export function lines(...all: readonly (string | false)[]): string {
  return `${all.filter((line) => line !== false).join('\n')}\n`
}
