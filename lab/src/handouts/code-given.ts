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

/** A line; false where the text has none. */
type Line = string | false

/** The lines of a text, one for each that is said. */
export function lines(...all: readonly Line[]): string {
  return `${all.filter((line) => line !== false).join('\n')}\n`
}

/** A text of a language: how it comments, what stands before the motion, the motion of each kind, and what it prints. */
interface Parts {
  readonly comment: (text: string) => string
  /** Before a swing or a turn: the convention of the parameter, what is loaded, the start, the parameter. */
  readonly elliptic: readonly Line[]
  /** Before what needs no elliptic functions. */
  readonly elementary: readonly Line[]
  readonly libration: readonly Line[]
  readonly rotation: readonly Line[]
  readonly separatrix: readonly Line[]
  readonly rest: readonly Line[]
  readonly shown: readonly Line[]
}

export function textOf({ kind, say }: Given, parts: Parts): string {
  const plain = kind === 'separatrix' || kind === 'rest'
  const before = plain ? [parts.comment(say[kind]), ...parts.elementary] : parts.elliptic
  return lines(parts.comment(say.equation), ...before, ...parts[kind], ...parts.shown)
}
