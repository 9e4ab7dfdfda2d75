// The formulas of the period as a list: line, author, formula, error at the amplitude; sorted as the registry or by that error.

import { html, nothing, type TemplateResult } from 'lit-html'
import { icon } from '../draw/icons'
import type { Words } from '../language'
import { plain, rich } from '../language/rich'
import { degrees } from '../number'
import type { PeriodResult } from '../period-study'
import { PERIOD_NAMES, type PeriodName, periodKind, USUAL_PERIODS, withPeriod } from '../periods'
import type { Live } from './page'

/** `+11.5 %`: with its sign, and three digits where it is small. */
export function signedPercent(words: Words, error: number): string {
  if (Number.isNaN(error)) return '–'
  if (!Number.isFinite(error)) return '∞'
  const percent = 100 * error
  if (percent === 0) return '0'
  const text = words.significant(percent, Math.abs(percent) >= 1 && Math.abs(percent) < 10 ? 2 : 3)
  return `${percent > 0 ? '+' : ''}${words.with(text, '%')}`
}

/** Names of people and formulas of letters are the same in every language. */
const SAID: Readonly<Partial<Record<PeriodName, readonly [string, string]>>> = {
  linear: ['', '1'],
  bernoulli: ['Bernoulli', '1 + _θ_²/16'],
  denman: ['Denman 1959', '1/(1 − _θ_²/16)'],
  'kidd-fogg': ['Kidd & Fogg 2002', '_a_^{−1/2}'],
  molina: ['Molina 1997', '(sin _θ_/_θ_)^{−3/8}'],
  'ganley-parwani': ['Ganley 1985, Parwani 2004', '√(_s_/sin _s_), _s_ = √3 _θ_/2'],
  'lima-arun': ['Lima & Arun 2006', 'ln _a_/(_a_ − 1)'],
  belendez: ['Beléndez et al. 2009', '4/(1 + √_a_)²'],
  cromer: ['Cromer 1995', '(2/π) ln(4/_a_)'],
  chachiyo: ['Chachiyo 2025', '(2/_n_π) ln((4/_a_)^{n} + _b_)'],
  'salas-26': ['Salas 2019 (26)', '(5_m_ − 16)/(9_m_ − 16)'],
  'salas-27': ['Salas 2019 (27)', ''],
  'salas-28': ['Salas 2019 (28)', ''],
}

/** Author and year; with N where there is one. */
export function formulaName({ words }: Pick<Live, 'words'>, name: PeriodName, key: string): string {
  const { formulas } = words.say.period
  const own = SAID[name]?.[0]
  if (own) return own
  return words.fill(formulas[name as 'linear' | 'series' | 'agm'], { n: key.split(':')[1] ?? '' })
}

export function formulaShort({ words }: Pick<Live, 'words'>, name: PeriodName): string {
  const { formulas } = words.say.period
  const own = SAID[name]?.[1]
  if (own) return words.formula(own)
  return name === 'series' ? formulas.seriesWhat : name === 'agm' ? formulas.agmWhat : formulas.rational
}

function stepper(page: Live, { name, key }: PeriodResult): TemplateResult | typeof nothing {
  const { orders } = periodKind(name)
  if (!orders) return nothing
  const { words, store, state } = page
  const n = Number(key.split(':')[1])
  const said = { name: plain(formulaName(page, name, key)) }
  const change = (by: number) => {
    const next = Math.min(orders.most, Math.max(orders.least, n + by))
    store.set({ periods: withPeriod(state.periods, `${name}:${next}`, true) })
  }
  return html`<span class="stepper"><button type="button" aria-label=${words.fill(words.say.compare.fewer, said)} @click=${() => change(-orders.step)}>−</button><span class="count">${n}</span><button type="button" aria-label=${words.fill(words.say.compare.moreTerms, said)} @click=${() => change(orders.step)}>+</button></span>`
}

/** Formulas of the registry as markup: θ_max and a_(n+1) with their indices. */
export function formulaMarkup(text: string): string {
  return text.replace(/(\p{L})_(max|\([^)]*\)|\p{L})/gu, (_, letter: string, index: string) => {
    return `_${letter}_{${index.replace(/[()]/g, '')}}`
  })
}

/** The range for which its author offers it, in words; empty where none is stated. */
function statedText(page: Live, name: PeriodName): string {
  const { words, model } = page
  const { stated } = words.say.period
  const said = stated[name as keyof typeof stated]
  if (said) return said
  const most = model.periods.find((each) => each.name === name)?.statedRange?.[1]
  return most === undefined
    ? ''
    : words.fill(stated.upTo, { angle: `${words.given(Number(degrees(most).toFixed(1)))}°` })
}

/** Second line of a row: the formula, and that it is beyond its stated range. */
function remark(page: Live, { name }: PeriodResult): string {
  const { words, model, motion } = page
  const { stated } = words.say.period
  const formula = formulaShort(page, name)
  const range = model.periods.find((each) => each.name === name)?.statedRange
  if (!range || motion.regime === 'rotation' || motion.thetaMax <= range[1]) return formula
  return words.fill(stated.beyond, { formula, angle: `${words.given(Number(degrees(range[1]).toFixed(1)))}°` })
}

function row(page: Live, result: PeriodResult): TemplateResult {
  const { store, state, session, words } = page
  const { name, key, on, error } = result
  const said = plain(formulaName(page, name, key))
  const text = remark(page, result)
  const stated = statedText(page, name)
  const point = (pointed: string | null) => store.setSession({ pointed })
  const percent = signedPercent(words, error)
  return html`<li class="row ${on ? '' : 'off'} ${session.pointed === name ? 'pointed' : ''}" @pointerenter=${() => point(name)} @pointerleave=${() => point(null)}>
    <input type="checkbox" id="period-${name}" .checked=${on} aria-label="${said}: ${plain(percent)}. ${plain(text)}${stated ? `. ${plain(stated)}` : ''}"
      @change=${(event: Event) => store.set({ periods: withPeriod(state.periods, key, (event.target as HTMLInputElement).checked) })}
      @focus=${() => point(name)} @blur=${() => point(null)}>
    <svg class="key framed" viewBox="0 0 44 22" aria-hidden="true"><path class="c ${periodKind(name).clothes}" d="M4 11H40"/></svg>
    <span class="name"><span>${rich(formulaName(page, name, key))}</span>${stepper(page, result)}<small>${rich(text)}</small></span>
    <span class="result">${rich(percent)}</span>
  </li>`
}

/** What is known of the formula that is pointed at: all of it, where from, for which range. */
function details(page: Live, results: readonly PeriodResult[]): TemplateResult {
  const { words, model, session } = page
  const { period } = words.say
  const name = results.find((each) => each.name === session.pointed)?.name
  const known = model.periods.find((each) => each.name === name)
  if (!name || !known) return html`<p class="soft small formula-details">${period.help}</p>`
  const full = words.formula(period.full[name as keyof typeof period.full] ?? formulaMarkup(known.formula))
  const source = period.sources[name as keyof typeof period.sources] ?? known.source
  const stated = statedText(page, name)
  return html`<p class="soft small formula-details">${rich(full)}. ${rich(source)}${stated ? html`; ${rich(stated)}` : nothing}.</p>`
}

/** The rows that are listed: all, or the usual ones and what is drawn. */
const ALL = 'formulas'

export function formulaList(page: Live, results: readonly PeriodResult[], at: string | null): TemplateResult {
  const { words, state, store, session } = page
  const { period, compare } = words.say
  const whole = session.wholeTables.includes(ALL)
  const listed = results.filter(({ name, on }) => whole || on || USUAL_PERIODS.includes(name))
  const count = PERIOD_NAMES.length - listed.length
  const byError = state.periodOrder === 'error'
  const sort = () => store.set({ periodOrder: byError ? 'registry' : 'error' })
  const toggle = () =>
    store.setSession({
      wholeTables: whole ? session.wholeTables.filter((each) => each !== ALL) : [...session.wholeTables, ALL],
    })
  const head = at === null ? period.errorColumn : words.fill(period.errorAt, { angle: at })
  return html`<section class="formulas ${whole ? 'whole' : ''}" aria-labelledby="formulas-title"><div class="head"><h2 id="formulas-title">${period.formulasTitle} <span class="unit">${rich(words.formula(period.letters))}</span></h2></div>
    <div class="caption"><span>${rich(period.column)}</span><button type="button" class="sort" id="sort-formulas" aria-pressed=${byError ? 'true' : 'false'} title=${byError ? period.sortRegistry : period.sortError} @click=${sort}>${head}${icon('down')}</button></div>
    <ul class="rows"><li class="row exact"><svg class="key" viewBox="0 0 44 22" aria-hidden="true"><path class="c c-exact" d="M4 11H40"/></svg><span class="name">${compare.exact}<small>${rich(period.exactBy)}</small></span><span class="result">0</span></li>
    ${listed.map((result) => row(page, result))}</ul>
    <div class="foot"><button type="button" class="button quiet" id="more-formulas" aria-expanded=${whole ? 'true' : 'false'} @click=${toggle}>${whole ? nothing : icon('plus')}${whole ? period.fewer : words.fill(period.more, { count })}</button></div>
    ${details(page, results)}
  </section>`
}
