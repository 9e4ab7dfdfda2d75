// What the page and the worker of the fit say to each other, and the answers of the worker: no part of it knows a browser.

import { FitRefusal, type Statements } from './exchange'
import { type Fit, FitModule, type Fitted, type FittedTogether } from './fit-module'
import { ReaderModule, type Reading } from './reader-module'

export type { Statements } from './exchange'
export type { Estimate, Fit, ModelName, Together } from './fit-module'
export type { Reading } from './reader-module'

/** A result with what is drawn: the samples, the curve at them, what is left. */
export interface Result extends Pick<Fitted, 'grades' | 'stands' | 'measured' | 'residual' | 'swings'> {
  readonly fit: Fit
  readonly x: Float64Array
  readonly fitted: Float64Array
}

/** What several records share. */
export type Joint = Omit<FittedTogether, 'records'>

/** The modules that a fit needs. */
export interface Modules {
  readonly reader: WebAssembly.Module
  readonly fit: WebAssembly.Module
}

export interface AskedFile {
  readonly bytes: Uint8Array
  readonly stated: Statements
}

/** One file, or several that are fitted together, and what is stated for the fit. */
export interface Asked {
  readonly modules: Modules
  readonly files: readonly AskedFile[]
  readonly stated: Statements
}

/** In this order: what was understood of each file, steps, the result; or at any place the end by a refusal or a failure. */
export type Told =
  | { readonly kind: 'read'; readonly reading: Reading }
  | { readonly kind: 'step'; readonly step: number; readonly of: number }
  | { readonly kind: 'fitted'; readonly results: readonly Result[]; readonly joint: Joint | null }
  | { readonly kind: 'refused'; readonly message: string }
  | { readonly kind: 'failed'; readonly message: string }

function resultOf({ t, ...found }: Fitted): Result {
  // A table of periods may have its rows in any order; a curve goes from left to right.
  const order = Uint32Array.from(t, (_, i) => i).sort((a, b) => (t[a] as number) - (t[b] as number))
  const sorted = (values: Float64Array) => Float64Array.from(order, (i) => values[i] as number)
  const [x, measured, residual] = [sorted(t), sorted(found.measured), sorted(found.residual)]
  const fitted = measured.map((each, i) => each - (residual[i] as number))
  const swings = found.swings.length > 0 ? sorted(found.swings) : found.swings
  return { ...found, x, measured, fitted, residual, swings }
}

/** Reads and fits; tells each stage as it is reached. */
export async function measure({ modules, files, stated }: Asked, tell: (told: Told) => void): Promise<void> {
  try {
    // Every record goes through the steps, or through none.
    let steps = 0
    const fits: FitModule = await FitModule.start(modules.fit, (step) => {
      const { length } = fits.steps
      if (step === 0) steps++
      tell({ kind: 'step', step: (steps - 1) * length + step, of: files.length * length })
    })
    const reader = await ReaderModule.start(modules.reader)
    files.forEach(({ bytes, stated: said }, i) => {
      const reading = reader.read(bytes, said)
      fits.give(reading, i === 0 ? said : [...said, ['beside', '']])
      tell({ kind: 'read', reading })
    })
    if (files.length === 1) tell({ kind: 'fitted', results: [resultOf(fits.fit(stated))], joint: null })
    else {
      const { records, ...joint } = fits.fitTogether(stated)
      tell({ kind: 'fitted', results: records.map(resultOf), joint })
    }
  } catch (error) {
    const message = error instanceof Error ? error.message : String(error)
    tell({ kind: error instanceof FitRefusal ? 'refused' : 'failed', message })
  }
}
