// The measurement of the view Data: the files, what is stated about them, and how far their fit is. It stays with the visit; nothing
// of it is in a link, and nothing leaves the machine.

import {
  badText,
  type Entries,
  isBad,
  knownOf,
  lengthOf,
  NOTHING,
  NOTHING_OF_FILE,
  readingOf,
  statementsOf,
} from './entries'
import type { AskedFile, Joint, Reading, Result, Statements, Told } from './model/fit-protocol'
import type { Fitter } from './model/fitter'

/** A file, with a length of its own where the pendulum was not the same. */
interface MeasuredFile {
  readonly name: string
  readonly bytes: Uint8Array
  readonly length: string
  readonly lengthU: string
}

export type Phase = 'empty' | 'reading' | 'fitting' | 'fitted' | 'refused' | 'failed' | 'cancelled'

/** What the periods of a light gate are drawn against. */
export type Axis = 'swing' | 'time'

export class Measurement {
  phase: Phase = 'empty'
  files: readonly MeasuredFile[] = []
  entries: Entries = NOTHING
  readings: readonly Reading[] = []
  results: readonly Result[] = []
  /** What several records share. */
  joint: Joint | null = null
  /** The record that is drawn. */
  shown = 0
  axis: Axis = 'swing'
  /** The line of a refusal or a failure. */
  message = ''
  /** Whether the refusal asks what the fields of “Say otherwise” can answer: they are the options of the command. */
  get asks(): boolean {
    return this.phase === 'refused' && /--(column|unit|rate|run)/.test(this.message)
  }

  /** Whether it ever did: the fields stay open while they are filled. */
  asked = false
  /** Part of the steps of the fit that have begun. */
  progress = 0
  /** What was stated when the last fit began. */
  #begun = ''
  /** Files that have been read since then: of the others stands what was understood before, so that the page keeps its place. */
  #read = 0

  constructor(
    private readonly fitter: Fitter,
    private readonly changed: () => void,
  ) {}

  get file(): MeasuredFile | null {
    return this.files[this.shown] ?? null
  }

  get reading(): Reading | null {
    return this.readings[this.shown] ?? null
  }

  get result(): Result | null {
    return this.results[this.shown] ?? null
  }

  /** Other files; what was stated about columns was for those before, the pendulum may be the same. */
  take(...files: readonly (readonly [name: string, bytes: Uint8Array])[]): void {
    if (files.length === 0) return
    this.files = []
    this.entries = { ...this.entries, ...NOTHING_OF_FILE }
    this.add(...files)
  }

  /** Files beside those that are there. */
  add(...files: readonly (readonly [name: string, bytes: Uint8Array])[]): void {
    this.files = [...this.files, ...files.map(([name, bytes]) => ({ name, bytes, length: '', lengthU: '' }))]
    this.#others()
  }

  remove(place: number): void {
    this.files = this.files.filter((_, i) => i !== place)
    this.#others()
  }

  /** Files that cannot be read. */
  fail(message: string): void {
    this.fitter.cancel()
    Object.assign(this, { phase: 'failed', message })
    this.changed()
  }

  /** What was found, or is still being found, was of the files before, also where what is stated has yet to be mended. */
  #others(): void {
    this.fitter.cancel()
    Object.assign(this, { phase: 'empty', readings: [], results: [], joint: null, message: '' })
    this.begin()
  }

  show(place: number): void {
    this.shown = place
    this.changed()
  }

  draw(axis: Axis): void {
    this.axis = axis
    this.changed()
  }

  /** What is being typed: it counts once it is entered, or with the next file. */
  type(patch: Partial<Entries>): void {
    this.entries = { ...this.entries, ...patch }
    this.changed()
  }

  enter(patch: Partial<Entries>): void {
    this.entries = { ...this.entries, ...patch }
    this.entered()
  }

  typeLength(place: number, patch: Partial<Pick<MeasuredFile, 'length' | 'lengthU'>>): void {
    this.files = this.files.map((each, i) => (i === place ? { ...each, ...patch } : each))
    this.changed()
  }

  /** What was typed counts. */
  entered(): void {
    if (this.files.length > 0 && JSON.stringify(this.#statements()) !== this.#begun) this.begin()
    else this.changed()
  }

  /** Whether each file has a length of its own. */
  get #apart(): boolean {
    const { files, entries } = this
    return entries.known === 'length' && files.length > 1 && files.some(({ length }) => length.trim() !== '')
  }

  /** Of each file by itself: with the common length where it has none of its own. */
  #length({ length, lengthU }: MeasuredFile): Statements {
    return length.trim() !== '' ? lengthOf(length, lengthU) : lengthOf(this.entries.length, this.entries.lengthU)
  }

  /** What is stated for the reading of each file and for the fit. */
  #statements(): { readonly reading: readonly Statements[]; readonly fit: Statements } {
    const { files, entries } = this
    const [first] = files
    if (!first || !this.#apart) {
      const fit = statementsOf(first?.name ?? '', entries)
      return { reading: files.map(({ name }) => statementsOf(name, entries)), fit }
    }
    const known = knownOf(entries)
    const reading = files.map(
      (each): Statements => [['file', each.name], ...readingOf(entries), ...this.#length(each), ...known],
    )
    return { reading, fit: [...files.flatMap((each) => this.#length(each)), ...known] }
  }

  /** The first text that is no number where one belongs. */
  get bad(): string | null {
    const own = this.files.flatMap(({ length, lengthU }) => [length, lengthU])
    return badText(this.entries) ?? (this.files.length > 1 ? own : []).find((each) => isBad('length', each)) ?? null
  }

  cancel(): void {
    this.fitter.cancel()
    this.phase = 'cancelled'
    this.#onlyRead()
    this.changed()
  }

  /** Reads and fits what is there. */
  begin(): void {
    const { files } = this
    this.shown = Math.min(this.shown, Math.max(files.length - 1, 0))
    if (files.length === 0 || this.bad !== null) {
      this.changed()
      return
    }
    const stated = this.#statements()
    this.#begun = JSON.stringify(stated)
    this.#read = 0
    Object.assign(this, { phase: 'reading', results: [], joint: null, message: '', progress: 0 })
    const asked = files.map(({ bytes }, i): AskedFile => ({ bytes, stated: stated.reading[i] as Statements }))
    void this.fitter.begin(asked, stated.fit, (told) => this.#hear(told))
    this.changed()
  }

  /** Nothing is said of files that could not be read. */
  #onlyRead(): void {
    this.readings = this.readings.slice(0, this.#read)
  }

  #hear(told: Told): void {
    switch (told.kind) {
      case 'read':
        this.readings = this.readings.toSpliced(this.#read++, 1, told.reading)
        if (this.#read === this.files.length) this.phase = 'fitting'
        break
      case 'step':
        this.progress = told.step / told.of
        break
      case 'fitted':
        this.results = told.results
        this.joint = told.joint
        this.phase = 'fitted'
        break
      default:
        this.phase = told.kind
        this.message = told.message
        this.#onlyRead()
        this.asked ||= this.asks
    }
    this.changed()
  }
}
