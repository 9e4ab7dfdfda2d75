// Fields of the view Data: a text that counts when it is left or Enter is pressed, and a choice of few.

import { html, nothing, type TemplateResult } from 'lit-html'
import { afterRelease } from '../controls/release'
import { icon } from '../draw/icons'
import { rich } from '../language/rich'
import type { Live } from './page'

interface EntryField {
  readonly id: string
  readonly label: string
  readonly text: string
  readonly bad?: boolean
  readonly unit?: string
  /** At every key. */
  readonly type: (text: string) => void
  /** When what was typed counts. */
  readonly enter?: () => void
}

export function entryField({
  id,
  label,
  text,
  bad = false,
  unit = '',
  type,
  enter = () => {},
}: EntryField): TemplateResult {
  const value = (event: Event) => (event.target as HTMLInputElement).value
  return html`<span class="field ${bad ? 'bad' : ''}"><input id=${id} .value=${text} aria-label=${label}
    aria-invalid=${bad ? 'true' : 'false'} aria-describedby=${bad ? 'data-fault' : nothing}
    autocomplete="off" spellcheck="false" @input=${(event: Event) => type(value(event))} @change=${() => afterRelease(enter)}>${
      unit === '' ? nothing : html`<span class="unit">${unit}</span>`
    }</span>`
}

export function select<T extends string>(
  id: string,
  label: string,
  all: readonly T[],
  now: T,
  say: (each: T) => string,
  set: (each: T) => void,
): TemplateResult {
  return html`<select id=${id} aria-label=${label} @change=${(event: Event) => set((event.target as HTMLSelectElement).value as T)}>${all.map(
    (each) => html`<option value=${each} ?selected=${each === now}>${say(each)}</option>`,
  )}</select>`
}

/** A label with what stands at its right. */
export const entryLine = (label: string, fields: TemplateResult): TemplateResult =>
  html`<div class="entry"><span aria-hidden="true">${rich(label)}</span>${fields}</div>`

/** A value ± its uncertainty. */
export const entryPair = (value: TemplateResult, u: TemplateResult): TemplateResult =>
  html`<span class="pair">${value}±${u}</span>`

/** What is typed and is no number. */
export function notANumber({ words }: Live, text: string | null): TemplateResult | typeof nothing {
  if (text === null) return nothing
  return html`<p class="fault" id="data-fault" role="alert">${icon('warn')}<span>${words.fill(words.say.data.notANumber, { value: text })}</span></p>`
}
