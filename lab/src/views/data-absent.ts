// Data in the offline file, which has no fit. The view says so; bundle/one-file.ts takes this file for data.ts.

import { html, type TemplateResult } from 'lit-html'
import { absentWords } from '../language/data-absent'
import type { Live } from './page'

function body({ words }: Live): TemplateResult {
  return html`<p class="refusal" id="data-absent">${absentWords[words.language].notHere}</p>`
}

function sentence({ words }: Live): string {
  return absentWords[words.language].sentenceEmpty
}

export const part = { sentence, body }
