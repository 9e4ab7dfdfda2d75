// Data: from a file of measurements to g. The file and what is known, the data with the curve and the residuals, the result.

import '../language/data'
import '../style/data.css'
import { html, nothing, type TemplateResult } from 'lit-html'
import { switches } from '../controls/parts'
import { afterRelease, press } from '../controls/release'
import { icon } from '../draw/icons'
import { inLanguage, refusalInLanguage } from '../language/sentences'
import { Measurement } from '../measurement'
import FitWorker from '../model/fit-worker?worker&inline'
import { Fitter } from '../model/fitter'
import { PeriodModule } from '../model/period-module'
import { degrees } from '../number'
import { keepMore } from '../second-visit'
import { FIT, PERIOD, READER } from '../sources'
import { DATA_FROM } from '../state'
import type { Store } from '../store'
import { Timing } from '../timing'
import { dataCharts } from './data-charts'
import { sentenceOfTiming, timingBody } from './data-period'
import { dataResult, quotedOf, withUncertainty } from './data-result'
import { dataSource } from './data-source'
import { dataTogether, sharedOf } from './data-together'
import type { Live } from './page'

interface Visit {
  readonly fitter: Fitter
  readonly measurement: Measurement
  readonly timing: Timing
}

let visit: Visit | null = null

/** What is measured in this visit. A module that has come is there for a second visit too. */
function current(store: Store): Visit {
  if (visit) return visit
  const sources = { reader: READER, fit: FIT, period: PERIOD }
  const fitter = new Fitter(
    sources,
    () => new FitWorker(),
    () => void keepMore(),
    // What it tells may move what is being clicked.
    afterRelease,
  )
  const changed = () => store.changed()
  visit = { fitter, measurement: new Measurement(fitter, changed), timing: new Timing(changed) }
  return visit
}

/** The module of the part that is open: the reader is there when a file comes, and a period needs no worker. */
async function opened({ fitter, timing }: Visit, from: 'file' | 'period'): Promise<void> {
  if (from === 'period' && !timing.waits) return
  try {
    if (from === 'file') await fitter.load('reader')
    else {
      const module = await PeriodModule.start(await fitter.load('period'))
      if (timing.waits) timing.begin(module)
    }
  } catch {
    // It is asked for again with the first file, or with the next change, and what is wrong is said then.
  }
}

const isBusy = ({ phase }: Measurement): boolean => phase === 'reading' || phase === 'fitting'

/** What is going on, and what was refused: a line that is spoken. */
function status(page: Live, now: Measurement): TemplateResult {
  const { words } = page
  const { data } = words.say
  const busy = isBusy(now)
  const refused = now.phase === 'refused' || now.phase === 'failed'
  const percent = words.percent(100 * now.progress, 2)
  const working = html`<div class="working"><span>${now.phase === 'reading' ? data.reading : words.fill(data.fitting, { percent })}</span>
    <progress max="1" .value=${now.progress} aria-label=${data.progress}></progress>
    <button type="button" class="button" id="data-cancel" @click=${() => now.cancel()}>${data.cancel}</button></div>`
  const told = refusalInLanguage(
    now.message,
    now.files.map(({ name }) => name),
    words.language,
  )
  const options = now.asks
  const message =
    now.phase === 'failed'
      ? html`<span>${words.fill(data.failed, { why: now.message })}</span>`
      : html`<span id="data-refusal" lang=${told === now.message && words.language !== 'en' ? 'en' : nothing}>${told}</span>`
  const again = html`<button type="button" class="button" id="data-again" @click=${() => now.begin()}>${data.again}</button>`
  return html`${busy ? working : nothing}<div role="status">${refused ? html`<p class="refusal">${icon('warn')}${message}</p>` : nothing}
    ${options ? html`<p class="soft small">${data.optionsHelp}</p>` : nothing}
    ${now.phase === 'cancelled' ? html`<p class="working"><span>${data.cancelled}</span>${again}</p>` : nothing}</div>`
}

let height = 0

/** While a fit is made the columns are as high as before: what is above their end keeps its place. */
function keptHeight(now: Measurement): string | typeof nothing {
  if (!isBusy(now)) height = 0
  else height ||= document.querySelector<HTMLElement>('.data-columns')?.offsetHeight ?? 0
  return height > 0 ? `min-height:${height}px;align-content:start` : nothing
}

function fromFile(page: Live, now: Measurement): TemplateResult {
  const charts = dataCharts(page, now)
  return html`<div class="column left">${dataSource(page, now)}</div>
    <div class="column middle">${status(page, now)}${charts ?? html`<p class="soft">${page.words.say.data.plotWaiting}</p>`}</div>
    ${
      now.result
        ? html`<div class="column right" tabindex="0" role="region" aria-label=${page.words.say.data.result}>${now.joint ? dataTogether(page, now, now.joint) : nothing}${now.joint ? nothing : dataResult(page, now)}</div>`
        : nothing
    }`
}

function body(page: Live): TemplateResult {
  const visit = current(page.store)
  const { measurement, timing } = visit
  const { from } = page.state
  void opened(visit, from)
  const { data } = page.words.say
  const choice = switches(
    data.from,
    DATA_FROM.map((value) => ({ value, text: data.froms[value] })),
    from,
    (each) => page.store.set({ from: each }),
    'data-from',
  )
  return html`${choice}<div class="data-columns" style=${keptHeight(measurement)} @pointerdown=${press}>${from === 'period' ? timingBody(page, timing) : fromFile(page, measurement)}</div>`
}

function sentence(page: Live): string {
  const { words, store } = page
  const { data } = words.say
  const { measurement, timing } = current(store)
  if (page.state.from === 'period') return sentenceOfTiming(page, timing)
  const { phase, result, joint, results } = measurement
  if (isBusy(measurement)) return data.sentenceBusy
  if (phase === 'refused' || phase === 'failed') return data.sentenceRefused
  if (!result) return phase === 'empty' ? data.sentenceEmpty : data.sentenceRead
  if (joint && !joint.stands) return data.sentenceRefutedTogether
  if (joint) {
    const { of, unit, what } = sharedOf(page, joint)
    const forms = { g: data.sentenceG, length: data.sentenceL, omega0: data.sentenceW } as const
    return words.fill(forms[what], { value: words.with(withUncertainty(words, of), unit), count: results.length })
  }
  const { fit, stands } = result
  // A star would be a mark of bold letters.
  const verdict = inLanguage(fit.verdicts[0] ?? '', words.language).replace(/[*_^]/g, ' ')
  if (!stands) return words.fill(data.sentenceRefuted, { verdict })
  const { of, unit } = quotedOf(page, fit)
  const text = words.with(withUncertainty(words, of), unit)
  const angle = `${words.fixed(degrees(fit.swing ?? Number.NaN), 0)}°`
  const swing = fit.swing === null ? '' : ` ${words.fill(data.ofSwings, { angle })}`
  const measured = measurement.reading?.measured
  const each = measured === 'gate' || measured === 'swings' ? data.periods : data.samples
  const counted = words.fill(each, { count: fit.samples })
  const values = { g: text, length: text, omega: text, counted, swing, model: data.frictions[fit.model] }
  const form = fit.length ? (fit.length_given ? data.sentence : data.sentenceLength) : data.sentenceOmega
  return words.fill(form, values)
}

export const part = { sentence, body }
