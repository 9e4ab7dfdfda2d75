// Data in the offline file, which has no fit: it would be twice as long with one. The view says so.

import { html, type TemplateResult } from 'lit-html'
import type { Live } from './page'

export function data({ words }: Live): TemplateResult {
  return html`<p class="refusal" id="data-absent">${words.say.data.notHere}</p>`
}

export function dataSentence({ words }: Live): string {
  return words.say.data.sentenceEmpty
}
