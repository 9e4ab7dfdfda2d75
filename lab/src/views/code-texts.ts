// Code for the reader's own pendulum, and the difference between modulus and parameter in numbers.

import { html, nothing, type TemplateResult } from 'lit-html'
import { switches } from '../controls/parts'
import { icon } from '../draw/icons'
import { CODE_NAMES, codeText, losesDigits } from '../handouts/code'
import { MODULUS_MOST, MODULUS_NAMES, type Modulus, type ModulusName, mistakes, modulusOf } from '../handouts/modulus'
import { plain, rich } from '../language/rich'
import { degrees, parseQuantity } from '../number'
import { CODES } from '../state'
import { copyText, type Live } from './page'

function texts(page: Live): TemplateResult {
  const { words, state, store, session, motion } = page
  const { handouts } = words.say
  const text = codeText(state.code, motion, handouts.comments)
  return html`<div class="column code-column"><div class="head">${switches(
    handouts.languages,
    CODES.map((value) => ({ value, text: CODE_NAMES[value] })),
    state.code,
    (code) => store.set({ code }),
    'codes',
  )}</div>
    <div class="code-about"><p class="soft small">${handouts.codeFor[motion.regime]} ${handouts.prints}</p>
      <button type="button" class="button primary" id="copy-code" @click=${() => copyText(page, text, '#code-text')}>${session.copied ? handouts.copied : handouts.copy}</button></div>
    ${losesDigits(state.code, motion) ? html`<p class="refusal" id="near">${icon('warn')}<span>${handouts.near}</span></p>` : nothing}
    ${session.copyFailed ? html`<p class="soft small" role="status">${handouts.copyFailed}</p>` : nothing}
    <pre class="code" id="code-text" tabindex="0" role="region" aria-label=${CODE_NAMES[state.code]}><code lang="zxx" translate="no">${text}</code></pre>
    <span class="unseen" role="status">${session.copied ? handouts.copied : ''}</span></div>`
}

/** What was typed last, and where. */
let typed: { readonly name: ModulusName; readonly text: string } | null = null

const isAngle = (name: ModulusName): boolean => name === 'alpha' || name === 'theta0'

function numberOf(name: ModulusName, text: string): number {
  const value = parseQuantity(text, isAngle(name) ? 'deg' : '')
  return value >= 0 && value <= MODULUS_MOST[name] ? value : Number.NaN
}

/** As typed; before that, of the motion of the page where it swings. */
function current(page: Live): Modulus {
  const value = typed ? numberOf(typed.name, typed.text) : Number.NaN
  if (typed && !Number.isNaN(value)) return modulusOf(typed.name, value)
  const { thetaMax, regime } = page.motion
  return modulusOf('theta0', regime === 'libration' ? Math.min(thetaMax, MODULUS_MOST.theta0) : Math.PI / 2)
}

function field(page: Live, name: ModulusName, now: Modulus): TemplateResult {
  const { words, store } = page
  const { handouts } = words.say
  const own = typed?.name === name ? typed.text : null
  const bad = own !== null && own.trim() !== '' && Number.isNaN(numberOf(name, own))
  const number = name === 'theta0' ? 2 * now.alpha : now[name]
  const shown = words.typed(Number((isAngle(name) ? degrees(number) : number).toPrecision(7)))
  const most = isAngle(name) ? `${words.typed(degrees(MODULUS_MOST[name]))}°` : words.typed(MODULUS_MOST[name])
  const fault = words.fill(handouts.modulusFault, {
    name: handouts.labels[name],
    value: own ?? '',
    least: isAngle(name) ? '0°' : '0',
    most,
  })
  return html`<div class="entry"><label for="modulus-${name}">${rich(words.formula(handouts.symbols[name]))}</label><span class="field ${bad ? 'bad' : ''}"><input id="modulus-${name}" inputmode="decimal" autocomplete="off" spellcheck="false"
      .value=${own ?? shown} aria-label=${handouts.labels[name]} aria-invalid=${bad ? 'true' : 'false'} aria-describedby=${bad ? 'modulus-fault' : nothing}
      @input=${(event: Event) => {
        typed = { name, text: (event.target as HTMLInputElement).value }
        store.changed()
      }}>${isAngle(name) ? html`<span class="unit">°</span>` : nothing}</span>
    ${bad ? html`<p class="fault" id="modulus-fault" role="alert">${icon('warn')}<span>${plain(fault)}</span></p>` : nothing}</div>`
}

function converter(page: Live): TemplateResult {
  const { words, model } = page
  const { handouts } = words.say
  const now = current(page)
  const { kForM, mForK } = mistakes(model, now)
  const said = (text: string, error: number) =>
    rich(words.fill(text, { error: `${error > 0 ? '+' : ''}${words.percent(100 * error, 3)}` }))
  return html`<div class="column converter"><h2>${handouts.modulus}</h2><p class="soft small">${handouts.modulusHelp}</p>
    ${MODULUS_NAMES.map((name) => field(page, name, now))}
    <p id="k-for-m" data-exact=${String(kForM)}>${said(handouts.givenK, kForM)}</p><p id="m-for-k" data-exact=${String(mForK)}>${said(handouts.givenM, mForK)}</p>
    <p class="soft small">${rich(handouts.takeM)}</p><p class="soft small">${rich(handouts.takeK)}</p></div>`
}

export function codeTexts(page: Live): TemplateResult {
  return html`<div class="handout-columns code-columns">${texts(page)}${page.model.complete ? converter(page) : nothing}</div>`
}
