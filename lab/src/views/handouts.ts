// Hand-outs: a worksheet to print, code for the pendulum of the page, and the page in a page of others.

import '../language/handouts'
import '../style/handouts.css'
import { html, type TemplateResult } from 'lit-html'
import { switches } from '../controls/parts'
import { HANDOUTS } from '../state'
import { codeTexts } from './code-texts'
import { embedForm } from './embed-form'
import type { Live } from './page'
import { worksheet } from './worksheet'

const BODIES = { worksheet, code: codeTexts, embed: embedForm } as const

function body(page: Live): TemplateResult {
  const { words, state, store } = page
  const { handouts } = words.say
  return html`<div class="handout-tabs">${switches(
    handouts.sections,
    HANDOUTS.map((value) => ({ value, text: handouts.names[value] })),
    state.handout,
    (handout) => {
      store.setSession({ copied: false, copyFailed: false })
      store.set({ handout })
    },
  )}</div>${BODIES[state.handout](page)}`
}

function sentence({ words, state }: Live): string {
  return words.say.handouts[`${state.handout}Sentence`]
}

export const part = { sentence, body }
