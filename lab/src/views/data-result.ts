// The right column of Data: what came out with its uncertainty, where that comes from, the friction models, what speaks against it.

import { html, nothing, type TemplateResult } from 'lit-html'
import { smallPeriod } from '../against-swing'
import type { Words } from '../language'
import { rich } from '../language/rich'
import { inLanguage } from '../language/sentences'
import type { Measurement } from '../measurement'
import type { Estimate, Fit, Joint, Result } from '../model/fit-protocol'
import { DEGREES } from '../number'
import type { Live } from './page'

/** Two digits of the uncertainty, and the value as far as it goes. */
export function withUncertainty(words: Words, { value, u }: Pick<Estimate, 'value' | 'u'>, factor = 1): string {
  const size = Math.abs(u * factor)
  // What is not known is null, and no exact value.
  if (!Number.isFinite(u)) return `${words.significant(value * factor, 3)} ± ?`
  if (!(size > 0)) return words.significant(value * factor, 6)
  const decimals = Math.max(0, 1 - Math.floor(Math.log10(Number(size.toPrecision(2)))))
  return `${words.fixed(value * factor, decimals)} ± ${words.fixed(size, decimals)}`
}

const INDEPENDENT = 'as if residuals were independent'
const TERMS = ['linear', 'quadratic', 'dry', 'presliding'] as const
const TERM_UNITS = { linear: '1/s', quadratic: '1/rad', dry: 'rad/s²', presliding: 'rad' } as const

interface Quoted {
  readonly of: Estimate
  readonly unit: string
  readonly what: 'g' | 'length' | 'omega0'
}

type Found = Pick<Fit, 'g' | 'length' | 'length_given' | 'omega0'>

/** g, or the length, or ω₀: what the budget is of. */
export function quotedOf({ words }: Live, { g, length, length_given: given, omega0 }: Found): Quoted {
  const { units } = words.say
  if (g && given) return { of: g, unit: units['m/s2'], what: 'g' }
  if (length && !given) return { of: length, unit: units.m, what: 'length' }
  return { of: omega0, unit: units['rad/s'], what: 'omega0' }
}

function values(page: Live, { fit }: Result, measured: string): TemplateResult {
  const { words } = page
  const { data, units } = words.say
  const row = (name: string, text: string, unit: string, id = '', note = '', big = false) =>
    html`<dt class=${big ? 'big' : ''}>${rich(name)}</dt><dd class=${big ? 'big' : ''} id=${id === '' ? nothing : id}>${rich(words.with(text, unit))}${note === '' ? nothing : html` <span class="soft small">${note}</span>`}</dd>`
  const { g, length, omega0, offset, friction } = fit
  const byLength = fit.length_given
  const inDegrees = measured === 'angle'
  return html`<dl class="facts">
    ${g ? row('_g_', withUncertainty(words, g), units['m/s2'], 'data-g', byLength ? '' : data.given, byLength) : nothing}
    ${length ? row('_L_', withUncertainty(words, length), units.m, 'data-length-found', byLength ? data.given : '', !byLength) : nothing}
    ${row(data.omega0, withUncertainty(words, omega0), units['rad/s'], 'data-omega0')}
    ${row('_T_{0}', withUncertainty(words, smallPeriod(omega0)), units.s, 'data-period0')}
    ${measured === 'gate' && fit.swing !== null ? row(data.largestSwing, words.fixed(fit.swing * DEGREES, 1), '°', 'data-swing') : nothing}
    ${TERMS.map((term) => {
      const found = friction[term]
      return found ? row(data.terms[term], withUncertainty(words, found), TERM_UNITS[term]) : nothing
    })}
    ${offset && inDegrees ? row(data.rest, withUncertainty(words, offset, DEGREES), '°') : nothing}
    ${row(data.rms, words.significant(fit.rms * (inDegrees || measured === 'velocity' ? DEGREES : 1)), unitOf(measured, page))}</dl>`
}

const unitOf = (measured: string, { words }: Live): string =>
  words.say.data.plain[measured as keyof typeof words.say.data.plain]

/** Where the uncertainty of the quoted quantity comes from. */
export function budget({ words }: Live, rows: Fit['budget'], { of, unit }: Omit<Quoted, 'what'>): TemplateResult {
  const { data } = words.say
  const sources: Readonly<Record<string, string>> = data.sources
  // What a spreadsheet would state is no part of it.
  const parts = rows.filter(({ source }) => source !== INDEPENDENT)
  const independent = rows.find(({ source }) => source === INDEPENDENT)
  const part = (u: number) => {
    if (!Number.isFinite(u)) return '?'
    return u > 1e-9 * of.u ? words.significant(u, 2) : '0'
  }
  const line = (name: string, u: number, className = '') =>
    html`<tr class=${className}><th scope="row">${rich(name)}</th><td>${rich(part(u))}</td></tr>`
  return html`<h2 id="data-budget-title">${data.budget}</h2>
    <table class="data" id="data-budget" aria-labelledby="data-budget-title"><thead><tr><th scope="col">${data.budgetSource}</th><th scope="col">${rich(words.fill(data.budgetColumn, { unit }))}</th></tr></thead>
    <tbody>${parts.map(({ source, u }) => line(sources[source] ?? source, u))}
      ${line(data.combined, of.u, 'sum')}${line(data.expanded, of.expanded)}
      ${independent ? line(data.independent, independent.u, 'aside') : nothing}</tbody></table>`
}

/** What bob, wire and air do to the period. */
export function corrections({ words }: Live, rows: Fit['corrections']): TemplateResult | typeof nothing {
  if (rows.length === 0) return nothing
  const { data } = words.say
  const names: Readonly<Record<string, string>> = data.effects
  return html`<h2 id="data-corrections-title">${data.corrections}</h2>
    <table class="data" id="data-corrections" aria-labelledby="data-corrections-title"><thead><tr><th scope="col">${data.effect}</th><th scope="col">${rich(data.effectColumn)}</th></tr></thead>
    <tbody>${rows.map(({ name, relative_period: share }) => html`<tr><th scope="row">${names[name] ?? name}</th><td>${rich(words.percent(100 * share, 2))}</td></tr>`)}</tbody></table>`
}

function ladder(page: Live, { fit }: Result, measured: string): TemplateResult {
  const { words } = page
  const { data } = words.say
  const factor = measured === 'angle' || measured === 'velocity' ? DEGREES : 1
  const rms = (value: number) => rich(words.significant(value * factor))
  const sine = fit.diagnostics.linear_equation_rms
  return html`<h2 id="data-ladder-title">${data.ladder}</h2>
    <table class="data" id="data-ladder" aria-labelledby="data-ladder-title"><thead><tr><th scope="col">${data.ladderModel}</th><th scope="col">rms, ${unitOf(measured, page)}</th><th scope="col">${rich(data.omega0)}, ${words.say.units['rad/s']}</th></tr></thead>
    <tbody>${fit.ladder.map(
      ({ model, rms: left, omega0 }) =>
        html`<tr class=${model === fit.model ? 'chosen' : ''}><th scope="row">${data.models[model]}${model === fit.model ? html` <span class="unseen">(${data.chosen})</span>` : nothing}</th><td>${rms(left)}</td><td>${words.fixed(omega0, 5)}</td></tr>`,
    )}
    ${sine ? html`<tr id="data-sine"><th scope="row">${data.sine}</th><td>${rms(sine)}</td><td>–</td></tr>` : nothing}</tbody></table>
    ${sine ? html`<p class="soft small">${data.sineHelp}</p>` : nothing}`
}

type Told = Pick<Joint, 'grades'> & { readonly verdicts: readonly string[] }

export function verdicts({ words }: Live, { verdicts: all, grades }: Told): TemplateResult {
  const { data } = words.say
  if (all.length === 0)
    return html`<h2>${data.verdicts}</h2><p class="soft small" id="data-verdicts">${data.noVerdicts}</p>`
  return html`<h2>${data.verdicts}</h2><ul id="data-verdicts">${all.map((each, i) => {
    const grade = grades[i] ?? 'note'
    const told = inLanguage(each, words.language)
    return html`<li class="verdict ${grade}"><b>${data.grades[grade]}:</b> <span lang=${told === each ? 'en' : nothing}>${told}</span></li>`
  })}</ul>`
}

/** Of one record alone. */
export function dataResult(page: Live, { result, reading }: Measurement): TemplateResult | typeof nothing {
  if (!result || !reading) return nothing
  const { data } = page.words.say
  const { fit, grades, stands } = result
  const told = verdicts(page, { verdicts: fit.verdicts, grades })
  return html`<h2>${data.result}</h2>${stands ? nothing : told}${values(page, result, reading.measured)}${budget(page, fit.budget, quotedOf(page, fit))}
    ${stands ? told : nothing}${corrections(page, fit.corrections)}${fit.ladder.length > 0 ? ladder(page, result, reading.measured) : nothing}`
}
