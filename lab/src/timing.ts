// A period that was timed by hand: what is typed, the statements of the module, and g with the normal g of the place beside it.

import type { Statements } from './model/exchange'
import type { PeriodGravity, PeriodModule } from './model/period-module'
import { degrees, parseNumber, parseQuantity, radians } from './number'

const UNITS = {
  time: 's',
  timeU: 's',
  swings: '',
  length: 'm',
  lengthU: 'm',
  swing: 'deg',
  swingU: 'deg',
  end: 'deg',
  endU: 'deg',
  latitude: 'deg',
  height: 'm',
} as const

export type TimingName = keyof typeof UNITS
export type TimingEntries = Readonly<Record<TimingName, string>>

const EMPTY = Object.fromEntries(Object.keys(UNITS).map((name) => [name, ''])) as TimingEntries

/** Ten swings of 1 m from 30 degrees where g is 9.81, timed by hand. */
export const EXAMPLE: Partial<TimingEntries> = {
  time: '20.41',
  timeU: '0.02',
  swings: '10',
  length: '1.000',
  lengthU: '0.001',
  swing: '30',
  swingU: '1',
  end: '',
  endU: '',
}

/** The number that an entry is, in SI units and radians; NaN if it is none. */
export function timingNumber(name: TimingName, text: string): number {
  const unit = UNITS[name]
  const value = unit === '' ? parseNumber(text) : parseQuantity(text, unit)
  return name === 'swings' && !(Number.isInteger(value) && value > 0) ? Number.NaN : value
}

export const isBadTiming = (name: TimingName, text: string): boolean =>
  text.trim() !== '' && Number.isNaN(timingNumber(name, text))

/** The statements of the module (wasm/period/src/period.rs). */
export function timingStatements(entries: TimingEntries): Statements {
  const number = (name: TimingName) => timingNumber(name, entries[name])
  const given = (name: TimingName) => entries[name].trim() !== ''
  const u = (name: 'timeU' | 'lengthU' | 'swingU' | 'endU') => (given(name) ? number(name) : 0)
  const out: [string, string][] = []
  const swings = given('swings') ? number('swings') : 1
  if (given('time')) out.push(['period', `${number('time') / swings} ${u('timeU') / swings}`])
  for (const name of ['length', 'swing', 'end'] as const)
    if (given(name)) out.push([name, `${number(name)} ${u(`${name}U`)}`])
  if (given('latitude')) {
    out.push(['latitude', String(number('latitude'))])
    if (given('height')) out.push(['height', String(number('height'))])
  }
  return out
}

/** g of the same period and length for every swing that could have been. */
export interface GravityCurve {
  readonly swing: Float64Array
  readonly g: Float64Array
}

/** Points of the curve. */
const POINTS = 81

export class Timing {
  entries: TimingEntries = EMPTY
  answer: PeriodGravity | null = null
  curve: GravityCurve | null = null
  /** The line of a refusal. */
  message = ''
  #module: PeriodModule | null = null

  constructor(private readonly changed: () => void) {}

  /** The module has come. */
  begin(module: PeriodModule): void {
    this.#module = module
    this.#weigh()
  }

  get waits(): boolean {
    return this.#module === null
  }

  /** The first text that is no number where one belongs. */
  get bad(): string | null {
    const name = (Object.keys(UNITS) as TimingName[]).find((each) => isBadTiming(each, this.entries[each]))
    return name ? this.entries[name] : null
  }

  enter(patch: Partial<TimingEntries>): void {
    this.entries = { ...this.entries, ...patch }
    this.#weigh()
  }

  #weigh(): void {
    Object.assign(this, { answer: null, curve: null, message: '' })
    if (this.#module && this.bad === null) {
      try {
        this.answer = this.#module.gravity(timingStatements(this.entries))
        if (this.answer.found) this.curve = this.#curve(this.#module)
      } catch (error) {
        this.message = error instanceof Error ? error.message : String(error)
      }
    }
    this.changed()
  }

  #curve(module: PeriodModule): GravityCurve {
    const stated = timingStatements({ ...this.entries, swing: '', end: '', latitude: '' })
    const largest = Math.max(...(['swing', 'end'] as const).map((name) => timingNumber(name, this.entries[name]) || 0))
    // A swing beyond 175 degrees is not timed by hand.
    const most = Math.min(Math.max(60, 1.5 * degrees(largest)), 175)
    const swing = Float64Array.from({ length: POINTS }, (_, i) => radians((most * i) / (POINTS - 1)))
    const g = swing.map((each) => module.gravity([...stated, ['swing', `${each} 0`]]).found?.g.value ?? Number.NaN)
    return { swing, g }
  }
}
