// The module of a period that was timed: a WebAssembly module of its own (wasm/period).

import { Exchange, numberOf, type Statements } from './exchange'
import type { Estimate, Fit } from './fit-module'

/** g from a period, and the normal g of a place, in m/s^2; null where nothing was stated for it. */
export interface PeriodGravity {
  readonly found: { readonly g: Estimate; readonly budget: Fit['budget']; readonly small_swings: number } | null
  readonly normal: number | null
}

export class PeriodModule {
  readonly #exchange: Exchange<{ gravity(): number }>

  private constructor(exchange: Exchange<{ gravity(): number }>) {
    this.#exchange = exchange
  }

  /** Starts a compiled module. */
  static async start(module: WebAssembly.Module): Promise<PeriodModule> {
    const number = (at: number, length: number): number => numberOf(exchange.text(at, length))
    const { exports } = await WebAssembly.instantiate(module, { page: { number } })
    const exchange = new Exchange<{ gravity(): number }>(exports)
    return new PeriodModule(exchange)
  }

  /** g from a period and of a place (wasm/period/src/period.rs); a FitRefusal where a value is out of its range. */
  gravity(stated: Statements): PeriodGravity {
    return this.#exchange.asked(() => this.#exchange.exports.gravity(), stated)
  }
}
