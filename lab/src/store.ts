// The one state of the page, what passes with the visit, and the redrawing of the page when either changes.

import { Clock } from './clock'
import { isRefused } from './embedding'
import type { Opened } from './link'
import type { Fault, State } from './state'

/** A bar below the tabs. */
export interface Message {
  readonly key: string
  readonly faults?: readonly Fault[]
  readonly text?: string
  /** Goes back to the state before. */
  readonly undo?: State
}

export type DialogName = 'share' | 'keys' | 'convergence' | 'film'

/** What is not in a link: drafts of fields, what is open, what is held. */
export interface Session {
  /** Text being typed, by field, while it is not a value or has the focus. */
  readonly drafts: Readonly<Record<string, string>>
  readonly messages: readonly Message[]
  readonly dialog: DialogName | null
  readonly menu: string | null
  /** The control that is being dragged. */
  readonly held: string | null
  /** Key of the curve that is pointed at. */
  readonly pointed: string | null
  readonly tables: readonly string[]
  readonly wholeTables: readonly string[]
  readonly sounding: string | null
  readonly copied: boolean
  readonly copyFailed: boolean
  readonly singleKeys: boolean
  readonly hint: string | null
  /** Whether play stopped because the system asks for reduced motion. */
  readonly reduced: boolean
}

const SESSION: Session = {
  drafts: {},
  messages: [],
  dialog: null,
  menu: null,
  held: null,
  pointed: null,
  tables: [],
  wholeTables: [],
  sounding: null,
  copied: false,
  copyFailed: false,
  singleKeys: true,
  hint: null,
  reduced: false,
}

export class Store {
  #state: State
  #session: Session = SESSION
  readonly clock: Clock
  #kept: Opened['kept']
  readonly #listeners = new Set<() => void>()

  constructor(opened: Opened, read?: () => number) {
    this.#state = opened.state
    this.#kept = opened.kept
    this.clock = new Clock(opened.state.t, opened.state.speed, read)
  }

  get state(): State {
    return this.#state
  }

  get session(): Session {
    return this.#session
  }

  /** Pairs of the link that are not ours. */
  get kept(): Opened['kept'] {
    return this.#kept
  }

  /** The state as it is now, with the time of the clock: what a link says. */
  get moment(): State {
    return { ...this.#state, t: Number(this.clock.t.toFixed(3)), speed: this.clock.speed }
  }

  /** Nothing changes where the sender of the page has locked a part of it. */
  set(patch: Partial<State>): void {
    if (!isRefused(this.#state, patch)) this.open(patch)
  }

  /** What a link says, whatever is locked. */
  open(patch: Partial<State>): void {
    this.#state = { ...this.#state, ...patch }
    if (patch.t !== undefined) this.clock.seek(patch.t)
    if (patch.speed !== undefined) this.clock.speed = patch.speed
    // The row of a curve may go from under the pointer, which then never leaves it.
    if ('view' in patch || 'curves' in patch || 'periods' in patch) this.#session = { ...this.#session, pointed: null }
    this.changed()
  }

  /** Another link in the page that is open. What was typed, open or to be undone was of the state before, and may say what this one hides. */
  openLink({ state, faults, kept }: Opened): void {
    const others = this.#session.messages.filter(({ key, undo }) => key !== 'link' && !undo)
    const messages = faults.length > 0 ? [...others, { key: 'link', faults }] : others
    this.#session = { ...this.#session, drafts: {}, dialog: null, menu: null, messages }
    this.#kept = kept
    this.clock.pause()
    this.open(state)
  }

  setSession(patch: Partial<Session>): void {
    this.#session = { ...this.#session, ...patch }
    this.changed()
  }

  /** Another picture, with one line to go back. */
  replace(state: State, message: Message): void {
    if (isRefused(this.#state, state)) return
    const undo = this.moment
    const messages = [...this.#session.messages.filter((each) => each.key !== message.key), { ...message, undo }]
    this.#session = { ...this.#session, drafts: {}, messages }
    this.clock.pause()
    this.set(state)
  }

  draft(field: string, text: string | null): void {
    const { [field]: _, ...others } = this.#session.drafts
    this.setSession({ drafts: text === null ? others : { ...others, [field]: text } })
  }

  dismiss(key: string): void {
    this.setSession({ messages: this.#session.messages.filter((each) => each.key !== key) })
  }

  seek(t: number): void {
    this.clock.seek(t)
    this.changed()
  }

  play(): void {
    this.clock.play()
    this.setSession({ reduced: false })
  }

  pause(): void {
    this.clock.pause()
    this.changed()
  }

  listen(listener: () => void): void {
    this.#listeners.add(listener)
  }

  changed(): void {
    for (const listener of this.#listeners) listener()
  }
}
