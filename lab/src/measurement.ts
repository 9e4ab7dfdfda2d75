// The measurement of the view Data: the file, what is stated about it, and how far its fit is. It stays with the visit; nothing of
// it is in a link, and nothing leaves the machine.

import type { Reading, Result, Statements, Told } from './model/fit-protocol'
import type { Fitter } from './model/fitter'
import { parseNumber, parseQuantity } from './number'

export const ROLES = ['angle', 'velocity', 'acceleration', 'x', 'y', 'period'] as const
export type RoleName = (typeof ROLES)[number]
export const MODELS = ['auto', 'none', 'linear', 'quadratic', 'dry', 'presliding'] as const

/** What the reader of the page types beside the file: texts, empty where nothing is stated. */
export interface Entries {
  readonly time: string
  readonly role: RoleName
  readonly column: string
  readonly unit: string
  readonly rate: string
  readonly run: string
  readonly known: 'length' | 'gravity'
  readonly length: string
  readonly lengthU: string
  readonly gravity: string
  readonly gravityU: string
  readonly model: (typeof MODELS)[number]
}

export type EntryName = keyof Entries

const NOTHING: Entries = {
  time: '',
  role: 'angle',
  column: '',
  unit: '',
  rate: '',
  run: '',
  known: 'length',
  length: '',
  lengthU: '',
  gravity: '',
  gravityU: '',
  model: 'auto',
}

export type Phase = 'empty' | 'reading' | 'fitting' | 'fitted' | 'refused' | 'failed' | 'cancelled'

/** The number that an entry is, in SI units; NaN if it is none. */
export function entryNumber(name: EntryName, text: string): number {
  if (name === 'length' || name === 'lengthU') return parseQuantity(text, 'm')
  if (name === 'gravity' || name === 'gravityU') return parseQuantity(text, 'm/s2')
  return parseNumber(text)
}

const NUMBERS: readonly EntryName[] = ['rate', 'run', 'length', 'lengthU', 'gravity', 'gravityU']

/** Whether what is typed is no number where one belongs. */
export function isBad(name: EntryName, text: string): boolean {
  return NUMBERS.includes(name) && text.trim() !== '' && Number.isNaN(entryNumber(name, text))
}

/** The entries as the module takes them. */
export function statementsOf(file: string, entries: Entries): Statements {
  const { time, role, column, unit, rate, run, known, model } = entries
  const out: [string, string][] = [['file', file]]
  if (time.trim() !== '') out.push(['column', `time=${time}`])
  if (column.trim() !== '') out.push(['column', `${role}=${column}`])
  if (unit.trim() !== '') out.push(['unit', `${role}=${unit}`])
  for (const [name, text] of [
    ['rate', rate],
    ['run', run],
  ] as const)
    if (text.trim() !== '') out.push([name, String(entryNumber(name, text))])
  if (entries[known].trim() !== '') {
    const u = entries[`${known}U`].trim()
    out.push([known, `${entryNumber(known, entries[known])} ${u === '' ? 0 : entryNumber(`${known}U`, u)}`])
  }
  if (model !== 'auto') out.push(['model', model])
  return out
}

export class Measurement {
  phase: Phase = 'empty'
  file: { readonly name: string; readonly bytes: Uint8Array } | null = null
  entries: Entries = NOTHING
  reading: Reading | null = null
  result: Result | null = null
  /** The line of a refusal or a failure. */
  message = ''
  /** Part of the steps of the fit that have begun. */
  progress = 0
  /** What was stated when the last fit began. */
  #begun = ''

  constructor(
    private readonly fitter: Fitter,
    private readonly changed: () => void,
  ) {}

  /** The view has opened: the module is asked for. */
  open(): void {
    this.fitter.load().catch(() => {
      // It is asked for again with the first file, and what is wrong is said then.
    })
  }

  /** Another file; what was stated about columns was for the one before, the pendulum may be the same. */
  take(name: string, bytes: Uint8Array): void {
    this.file = { name, bytes }
    this.entries = { ...this.entries, time: '', column: '', unit: '', rate: '', run: '' }
    this.begin()
  }

  /** What is being typed: it counts once it is entered, or with the next file. */
  type(patch: Partial<Entries>): void {
    this.entries = { ...this.entries, ...patch }
    this.changed()
  }

  enter(patch: Partial<Entries>): void {
    this.entries = { ...this.entries, ...patch }
    if (this.file && this.#statements() !== this.#begun) this.begin()
    else this.changed()
  }

  /** What is stated, to be compared. */
  #statements(): string {
    return JSON.stringify(statementsOf(this.file?.name ?? '', this.entries))
  }

  cancel(): void {
    this.fitter.cancel()
    this.phase = 'cancelled'
    this.changed()
  }

  /** Reads and fits what is there. */
  begin(): void {
    const { file, entries } = this
    const bad = (Object.keys(entries) as EntryName[]).some((name) => isBad(name, entries[name]))
    if (!file || bad) {
      this.changed()
      return
    }
    this.#begun = this.#statements()
    Object.assign(this, { phase: 'reading', reading: null, result: null, message: '', progress: 0 })
    void this.fitter.begin(file.bytes, statementsOf(file.name, entries), (told) => this.#hear(told))
    this.changed()
  }

  #hear(told: Told): void {
    switch (told.kind) {
      case 'read':
        this.reading = told.reading
        this.phase = 'fitting'
        break
      case 'step':
        this.progress = told.step / told.of
        break
      case 'fitted':
        this.result = told.result
        this.phase = 'fitted'
        break
      default:
        this.phase = told.kind
        this.message = told.message
    }
    this.changed()
  }
}
