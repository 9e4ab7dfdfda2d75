// Data: from a file of measurements to g. The file and what is known, the data with the curve and the residuals, the result.

import '../language/data'
import '../style/data.css'
import { html, nothing, type TemplateResult } from 'lit-html'
import { icon } from '../draw/icons'
import { Measurement } from '../measurement'
import FitWorker from '../model/fit-worker?worker&inline'
import { Fitter } from '../model/fitter'
import { degrees } from '../number'
import { FIT } from '../sources'
import type { Store } from '../store'
import { dataCharts } from './data-charts'
import { dataResult, quotedOf, withUncertainty } from './data-result'
import { dataSource } from './data-source'
import type { Live } from './page'

let measurement: Measurement | null = null

/** The one measurement of the visit; its module is asked for when the view first opens. */
function current(store: Store): Measurement {
  if (measurement) return measurement
  measurement = new Measurement(new Fitter(FIT, () => new FitWorker()), () => store.changed())
  measurement.open()
  return measurement
}

/** What is going on, and what was refused: a line that is spoken. */
function status(page: Live, now: Measurement): TemplateResult {
  const { words } = page
  const { data } = words.say
  const busy = now.phase === 'reading' || now.phase === 'fitting'
  const refused = now.phase === 'refused' || now.phase === 'failed'
  const percent = words.percent(100 * now.progress, 2)
  const working = html`<div class="working"><span>${now.phase === 'reading' ? data.reading : words.fill(data.fitting, { percent })}</span>
    <progress max="1" .value=${now.progress} aria-label=${data.progress}></progress>
    <button type="button" class="button" id="data-cancel" @click=${() => now.cancel()}>${data.cancel}</button></div>`
  const message =
    now.phase === 'failed'
      ? html`<span>${words.fill(data.failed, { why: now.message })}</span>`
      : html`<span id="data-refusal" lang="en">${now.message}</span>`
  const again = html`<button type="button" class="button" id="data-again" @click=${() => now.begin()}>${data.again}</button>`
  return html`${busy ? working : nothing}<div role="status">${refused ? html`<p class="refusal">${icon('warn')}${message}</p>` : nothing}
    ${now.phase === 'cancelled' ? html`<p class="working"><span>${data.cancelled}</span>${again}</p>` : nothing}</div>`
}

function body(page: Live): TemplateResult {
  const now = current(page.store)
  const charts = dataCharts(page, now)
  return html`<div class="data-columns"><div class="column left">${dataSource(page, now)}</div>
    <div class="column middle">${status(page, now)}${charts ?? html`<p class="soft">${page.words.say.data.plotWaiting}</p>`}</div>
    ${
      now.result
        ? html`<div class="column right" tabindex="0" role="region" aria-label=${page.words.say.data.result}>${dataResult(page, now)}</div>`
        : nothing
    }</div>`
}

function sentence(page: Live): string {
  const { words, store } = page
  const { data } = words.say
  const { phase, result } = current(store)
  if (phase === 'reading' || phase === 'fitting') return data.sentenceBusy
  if (phase === 'refused' || phase === 'failed') return data.sentenceRefused
  if (!result) return phase === 'empty' ? data.sentenceEmpty : data.sentenceRead
  const { fit, stands } = result
  // A star would be a mark of bold letters.
  if (!stands) return words.fill(data.sentenceRefuted, { verdict: (fit.verdicts[0] ?? '').replace(/[*_^]/g, ' ') })
  const { of, unit } = quotedOf(page, result)
  const text = words.with(withUncertainty(words, of), unit)
  const angle = `${words.fixed(degrees(fit.swing ?? Number.NaN), 0)}°`
  const swing = fit.swing === null ? '' : ` ${words.fill(data.ofSwings, { angle })}`
  const values = { g: text, length: text, omega: text, count: fit.samples, swing, model: data.frictions[fit.model] }
  const form = fit.length ? (fit.length_given ? data.sentence : data.sentenceLength) : data.sentenceOmega
  return words.fill(form, values)
}

export const part = { sentence, body }
