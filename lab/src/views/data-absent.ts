// Data in the offline file, which has no fit: it would be two thirds longer with one. The view says so.

import { html, type TemplateResult } from 'lit-html'
import type { Live } from './page'

export function data({ words }: Live): TemplateResult {
  return html`<p class="refusal" id="data-absent">${words.say.data.notHere}</p>`
}

export function dataSentence({ words }: Live): string {
  return words.say.data.sentenceEmpty
}
