// The module of springs and friction as their views see it: asked for when one opens; until it has come, a line says so.

import { html, type TemplateResult } from 'lit-html'
import { forgetFailure, motionsPhase } from '../model/motions'
import { keepForLater } from '../second-visit'
import { MOTIONS } from '../sources'
import type { Live } from './page'

interface WaitingWords {
  readonly loading: string
  readonly failed: string
  readonly again: string
}

/** What to show instead of the view; null once the module is there. */
export function motionsReady({ store }: Live, words: WaitingWords): TemplateResult | null {
  const phase = motionsPhase(MOTIONS, (now) => {
    store.changed()
    // With the module, a second visit works without a network too.
    if (now === 'ready' && !store.state.embed) void keepForLater()
  })
  if (phase === 'ready') return null
  if (phase === 'waiting') return html`<p class="waiting-line" role="status">${words.loading}</p>`
  const again = () => {
    forgetFailure()
    store.changed()
  }
  return html`<p class="refusal" role="alert">${words.failed} <button type="button" class="button" @click=${again}>${words.again}</button></p>`
}
