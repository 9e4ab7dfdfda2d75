// The modules of the reader, the fit and a period, for tests without a worker.

import { readFile } from 'node:fs/promises'
import { createRequire } from 'node:module'
import { FitRefusal, type Statements } from '../src/model/exchange'
import { FitModule, type Fitted } from '../src/model/fit-module'
import type { Modules } from '../src/model/fit-protocol'
import { PeriodModule } from '../src/model/period-module'
import { ReaderModule, type Reading } from '../src/model/reader-module'

const place = createRequire(import.meta.url)
const compiled = async (name: string) =>
  WebAssembly.compile(await readFile(place.resolve(`libration/libration-${name}.wasm`)))

export const modules: Modules = { reader: await compiled('reader'), fit: await compiled('fit') }
const period = await compiled('period')

export const startedPeriod = (): Promise<PeriodModule> => PeriodModule.start(period)

/** Reads files and fits them, as the worker does. */
export class Measuring {
  private constructor(
    private readonly reader: ReaderModule,
    private readonly fits: FitModule,
  ) {}

  static async start(): Promise<Measuring> {
    return new Measuring(await ReaderModule.start(modules.reader), await FitModule.start(modules.fit))
  }

  read(file: Uint8Array, stated: Statements): Reading {
    const reading = this.reader.read(file, stated)
    this.fits.give(reading, stated)
    return reading
  }

  fit(stated: Statements): Fitted {
    return this.fits.fit(stated)
  }

  /** The line of a refusal; empty where there is none. */
  refusal(file: Uint8Array, stated: Statements): string {
    try {
      this.read(file, stated)
      this.fit(stated)
    } catch (error) {
      if (error instanceof FitRefusal) return error.message
      throw error
    }
    return ''
  }
}
