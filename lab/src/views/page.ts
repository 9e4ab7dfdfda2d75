// What every view is given: the state, the words, the exact motion, the time, and the ways to change them.

import type { Words } from '../language'
import type { Model, Motion } from '../model'
import { inRange, RANGES, type RangeName, type State } from '../state'
import type { Session, Store } from '../store'

export interface Page {
  readonly store: Store
  readonly state: State
  readonly session: Session
  readonly words: Words
  /** None while the core is loading, and where it did not start. */
  readonly model: Model | null
  readonly motion: Motion | null
  readonly t: number
  /** Pixels of 1 rem. */
  readonly rem: number
}

/** A page once the core is there. */
export interface Live extends Page {
  readonly model: Model
  readonly motion: Motion
}

export function isLive(page: Page): page is Live {
  return page.motion !== null
}

/** A number with the unit of its quantity, as the language writes it. */
export function quantityText(words: Words, name: RangeName, value: number): string {
  const { unit } = RANGES[name]
  if (unit === 'deg') return words.angle(value)
  return unit === '' ? words.given(value) : words.with(words.given(value), words.say.units[unit])
}

/** Sets a number of the state if it may stand there; else nothing changes. */
export function setNumber(store: Store, name: RangeName, value: number): boolean {
  if (!inRange(name, value)) return false
  store.set({ [name]: value })
  return true
}

let said: ReturnType<typeof setTimeout> | undefined

/** Copies a text and says so; where the browser forbids it the text is selected instead. */
export async function copyText({ store }: Pick<Page, 'store'>, text: string, place: string): Promise<void> {
  try {
    await navigator.clipboard.writeText(text)
    store.setSession({ copied: true, copyFailed: false })
    clearTimeout(said)
    said = setTimeout(() => store.setSession({ copied: false }), 2000)
  } catch {
    store.setSession({ copyFailed: true })
    const shown = document.querySelector(place)
    if (shown instanceof HTMLTextAreaElement) shown.select()
    else if (shown) getSelection()?.selectAllChildren(shown)
  }
}
