// What the page and the worker of the fit say to each other, and the answers of the worker: no part of it knows a browser.

import { type Fit, FitModule, FitRefusal, type Fitted, type Statements, type Understood } from './fit-module'

export type { Estimate, Fit, ModelName, Statements, Understood } from './fit-module'

/** A file as it was understood, its numbers in columns as they are drawn. */
export interface Reading extends Omit<Understood, 'x' | 'y'> {
  readonly x: Float64Array
  readonly y: Float64Array
}

/** A result with what is drawn: the samples, the curve at them, what is left. */
export interface Result extends Omit<Fitted, 'fit'> {
  readonly fit: Omit<Fit, 'residuals'>
  readonly x: Float64Array
  readonly measured: Float64Array
  readonly fitted: Float64Array
  readonly residual: Float64Array
}

export interface Asked {
  readonly module: WebAssembly.Module
  readonly bytes: Uint8Array
  readonly stated: Statements
}

/** In this order: what was understood, steps, the result; or at any place the end by a refusal or a failure. */
export type Told =
  | { readonly kind: 'read'; readonly reading: Reading }
  | { readonly kind: 'step'; readonly step: number; readonly of: number }
  | { readonly kind: 'fitted'; readonly result: Result }
  | { readonly kind: 'refused'; readonly message: string }
  | { readonly kind: 'failed'; readonly message: string }

function resultOf({ fit, ...others }: Fitted): Result {
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
  return { ...others, fit: rest, x, measured, fitted, residual }
}

/** Reads and fits; tells each stage as it is reached. */
export async function measure({ module, bytes, stated }: Asked, tell: (told: Told) => void): Promise<void> {
  try {
    const fits: FitModule = await FitModule.start(module, (step) => tell({ kind: 'step', step, of: fits.steps.length }))
    const { x, y, ...understood } = fits.read(bytes, stated)
    tell({ kind: 'read', reading: { ...understood, x: Float64Array.from(x), y: Float64Array.from(y) } })
    tell({ kind: 'fitted', result: resultOf(fits.fit(stated)) })
  } catch (error) {
    const message = error instanceof Error ? error.message : String(error)
    tell({ kind: error instanceof FitRefusal ? 'refused' : 'failed', message })
  }
}
