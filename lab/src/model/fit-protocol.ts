// What the page and the worker of the fit say to each other, and the answers of the worker: no part of it knows a browser.

import {
  type Fit,
  FitModule,
  FitRefusal,
  type Fitted,
  type FittedTogether,
  type Statements,
  type Understood,
} from './fit-module'

export type { Estimate, Fit, ModelName, Statements, Together, Understood } from './fit-module'

/** A file as it was understood, its numbers in columns as they are drawn. */
export interface Reading extends Omit<Understood, 'x' | 'y'> {
  readonly x: Float64Array
  readonly y: Float64Array
}

/** A result with what is drawn: the samples, the curve at them, what is left. */
export interface Result extends Omit<Fitted, 'fit' | 'swings'> {
  readonly fit: Omit<Fit, 'residuals'>
  readonly x: Float64Array
  readonly measured: Float64Array
  readonly fitted: Float64Array
  readonly residual: Float64Array
  /** Of periods: the turning angle of each by the fit, in rad; else empty. */
  readonly swings: Float64Array
}

/** What several records share. */
export type Joint = Omit<FittedTogether, 'records'>

export interface AskedFile {
  readonly bytes: Uint8Array
  readonly stated: Statements
}

/** One file, or several that are fitted together, and what is stated for the fit. */
export interface Asked {
  readonly module: WebAssembly.Module
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

function resultOf({ fit, swings: angles, ...others }: Fitted): Result {
  const { residuals, ...rest } = fit
  // A table of periods may have its rows in any order; a curve goes from left to right.
  const order = residuals.t.map((_, i) => i).sort((a, b) => (residuals.t[a] as number) - (residuals.t[b] as number))
  const sorted = (values: readonly number[]) => Float64Array.from(order, (i) => values[i] as number)
  const [x, measured, residual] = [residuals.t, residuals.measured, residuals.residual].map(sorted) as [
    Float64Array,
    Float64Array,
    Float64Array,
  ]
  const fitted = measured.map((each, i) => each - (residual[i] as number))
  const swings = angles.length > 0 ? sorted(angles) : new Float64Array()
  return { ...others, fit: rest, x, measured, fitted, residual, swings }
}

/** Reads and fits; tells each stage as it is reached. */
export async function measure({ module, files, stated }: Asked, tell: (told: Told) => void): Promise<void> {
  try {
    // Every record goes through the steps, or through none.
    let steps = 0
    const fits: FitModule = await FitModule.start(module, (step) => {
      const { length } = fits.steps
      if (step === 0) steps++
      tell({ kind: 'step', step: (steps - 1) * length + step, of: files.length * length })
    })
    files.forEach(({ bytes, stated: said }, i) => {
      const { x, y, ...understood } = fits.read(bytes, i === 0 ? said : [...said, ['beside', '']])
      tell({ kind: 'read', reading: { ...understood, x: Float64Array.from(x), y: Float64Array.from(y) } })
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
