// Amplitude, modulus and parameter as values of the page: three ways to say how far the pendulum swings.

import { html, type TemplateResult } from 'lit-html'
import { hint } from '../controls/parts'
import { type ValueSpec, value } from '../controls/value'
import { amplitudeOfModulus, amplitudeOfParameter, type Swing } from '../ellipse'
import { parseNumber } from '../number'
import { amplitudeValue } from './amplitude'
import type { Live } from './page'

function partValue(
  page: Live,
  key: 'modulus' | 'parameter',
  number: number,
  amplitude: (value: number) => number,
): TemplateResult {
  const { words, store, session } = page
  const { functions, faults } = words.say
  const draft = session.drafts[key]
  const read = draft === undefined || draft.trim() === '' ? null : parseNumber(draft)
  const valid = read === null || (read >= 0 && read < 1)
  const set = (next: number) => store.set({ theta0: amplitude(next), velocity0: 0 })
  const shown = words.fixed(number, 4)
  const fault = valid
    ? null
    : words.fill(faults[Number.isNaN(read) ? 'not-a-number' : 'out-of-range'], {
        name: functions[key],
        value: draft?.trim() ?? '',
        kept: shown,
        least: '0',
        most: '1',
      })
  const spec: ValueSpec = {
    key,
    label: functions[key],
    symbol: words.formula(key === 'modulus' ? '_k_ = sin(_θ_{max}/2)' : '_m_ = _k_²'),
    unit: '',
    value: number,
    least: 0,
    most: 1,
    step: 0.01,
    grain: 0.001,
    origin: 0,
    ticks: [0, 0.5, 1],
    text: shown,
    spoken: shown,
    draft,
    fault,
    onText: (text) => {
      store.draft(key, text)
      const next = parseNumber(text)
      if (next >= 0 && next < 1) set(next)
    },
    onDone: () => valid && store.draft(key, null),
    onSlide: (next) => {
      store.draft(key, null)
      set(Math.min(next, 0.9999))
    },
    onHold: (held) => store.setSession({ held: held ? key : null }),
  }
  return value(spec)
}

export function ellipseValues(page: Live, swing: Swing | null): TemplateResult {
  const { words, session, store } = page
  const { functions, hints } = words.say
  const word = hint('modulus', functions.which, hints.modulus, session.hint === 'modulus', (open) =>
    store.setSession({ hint: open ? 'modulus' : null }),
  )
  return html`<div class="ellipse-values">${amplitudeValue(page)}${partValue(page, 'modulus', swing?.k ?? 1, amplitudeOfModulus)}${partValue(page, 'parameter', swing?.parameter.m ?? 1, amplitudeOfParameter)}
    <p class="soft small">${word}</p></div>`
}
