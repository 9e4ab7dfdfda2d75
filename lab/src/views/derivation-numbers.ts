// The live parts of a step: an equality with both its sides, an erratum with what the printed line gives, the tables of numbers.

import { html, nothing, type TemplateResult } from 'lit-html'
import { unsafeHTML } from 'lit-html/directives/unsafe-html.js'
import type { Curve } from '../curves'
import { digitsOf, type Equality, type Sides, sidesOf } from '../derivation/equality'
import { ERRATA, type ErratumName, type Reading } from '../derivation/errata'
import FORMULAS from '../derivation/formulas.tex'
import type { TableName } from '../derivation/lessons'
import { seriesAt } from '../derivation/lima'
import type { Moment } from '../derivation/moment'
import { rich } from '../language/rich'
import { remember } from '../memory'
import type { EntryName } from '../state'
import type { Live } from './page'

/** Digits shown of a side. */
export const SHOWN = 12

/** Letters of a piece that is too long for a line of a phone. */
const LONG = 60

const translated = new Map<string, string>()

/** A formula with the functions as the language calls them, in pieces between which it may break. */
export function formula({ words }: Live, name: string): TemplateResult {
  const pieces = FORMULAS[name]
  if (!pieces) throw new Error(`no formula ${name}`)
  return html`<div class="formula">${pieces.map((piece, i) => {
    const key = `${words.language} ${name} ${i}`
    let text = translated.get(key)
    if (text === undefined) {
      text = words.formula(piece)
      translated.set(key, text)
    }
    // The longest is smaller on a phone; where it has no room even so, it can be scrolled, by keys too.
    return piece.replace(/<[^>]*>/g, '').length > LONG
      ? html`<span class="piece long" role="group" tabindex="0" aria-label=${words.say.derivation.formula}>${unsafeHTML(text)}</span>`
      : html`<span class="piece">${unsafeHTML(text)}</span>`
  })}</div>`
}

/** Zeros in front of a number that stands beside one of another size. */
const before = (value: number, size: number): number => Math.max(0, Math.floor(Math.log10(size / Math.abs(value))))

/** A number to the digits that its size has room for; those of which it is not sure are marked. */
function withDigits({ words }: Live, value: number, { size, apart }: Sides): TemplateResult {
  const room = SHOWN - before(value, size)
  if (value === 0 || room < 1) return html`<span class="side">0</span>`
  const sure = digitsOf(apart, SHOWN) - before(value, size)
  const [mantissa = '', power] = words.significant(value, room).split('\u00a0×')
  let at = 0
  for (let seen = 0; at < mantissa.length && seen < sure; at++) {
    const digit = mantissa[at] as string
    if (/[1-9]/.test(digit) || (seen > 0 && digit === '0')) seen++
  }
  const rest = mantissa.slice(at)
  return html`<span class="side">${mantissa.slice(0, at)}${rest === '' ? nothing : html`<span class="doubt">${rest}</span>`}${power === undefined ? nothing : rich(`\u00a0×${power}`)}</span>`
}

const unitText = (unit: string): string => (unit === '' ? '' : `\u00a0${unit}`)

/** Why an equality has no numbers here. */
function reason({ words }: Live, { of, id }: Equality, now: Moment): string {
  const { not } = words.say.derivation
  if (of.includes(now.regime)) return id === 'fourier' ? not.arcsine : not.value
  if (now.regime === 'rest') return not.rest
  if (of.length === 1 && of[0]) return not[of[0]]
  return of.length === 2 ? not.both : not.moving
}

/** Doubles below have fewer digits, and a quotient of them may be none. */
const LEAST = 1e-290

/** Whether the sides are numbers of which digits can be shown. */
const hold = ({ size, apart }: Sides): boolean => size === 0 || (size > LEAST && Number.isFinite(size + apart))

function numbers(page: Live, equality: Equality, sides: Sides): TemplateResult {
  const { words } = page
  const { derivation } = words.say
  const sure = digitsOf(sides.apart, SHOWN)
  return html`<span class="both">${withDigits(page, sides.left, sides)}<span class="equals">=</span>${withDigits(page, sides.right, sides)}${unitText(equality.unit)}</span>
    <span class="soft agree">${words.fill(derivation.digits, { count: sure })}</span>`
}

/** The equations of the papers; two words among them are the language's. */
function tagText({ words }: Live, tag: string): string {
  const { before, after } = words.say.derivation
  return tag.replace(/\bbefore\b/g, before).replace(/\bafter\b/g, after)
}

export function shownEquality(page: Live, equality: Equality, now: Moment): TemplateResult {
  const sides = sidesOf(equality, now)
  const { id, tag } = equality
  return html`<div class="equality" data-equality=${id} data-left=${sides ? String(sides.left) : nothing} data-right=${sides ? String(sides.right) : nothing}
    data-apart=${sides ? String(sides.apart) : nothing}>
    <div class="formula-line">${formula(page, id)}${tag === '' ? nothing : html`<span class="soft tag">${tagText(page, tag)}</span>`}</div>
    <div class="sides">${sides && hold(sides) ? numbers(page, equality, sides) : html`<span class="soft">${rich(sides ? page.words.say.derivation.not.small : reason(page, equality, now))}</span>`}</div>
  </div>`
}

/** A number of an erratum, or why it has none. */
function value(page: Live, reading: Reading, key: 'printed' | 'corrected' | 'truth', unit: string): TemplateResult {
  const { words } = page
  const { derivation } = words.say
  const number = reading[key]
  if (!Number.isNaN(number)) return html`${rich(words.significant(number, 7))}${unitText(unit)}`
  if (reading.argument === undefined) return html`${derivation.noReal}`
  return html`${rich(words.fill(derivation.noArcsine, { argument: words.significant(reading.argument, 5) }))}`
}

export function shownErratum(page: Live, name: ErratumName, now: Moment): TemplateResult {
  const { derivation } = page.words.say
  const erratum = ERRATA.find(({ id }) => id === name)
  if (!erratum) throw new Error(`no erratum ${name}`)
  const reading = erratum.of(now)
  const line = (key: 'printed' | 'corrected') =>
    html`<dt>${derivation[key]}</dt><dd>${formula(page, (key === 'corrected' && reading?.formula) || `${key}-${name}`)}${
      reading
        ? html`<span class="reading-value" data-reading=${key} data-exact=${String(reading[key])}>${rich(erratum.symbol)} = <b>${value(page, reading, key, erratum.unit)}</b></span>`
        : nothing
    }</dd>`
  return html`<aside class="erratum" data-erratum=${name} aria-label="${derivation.erratum} ${erratum.place}">
    <p><b class="badge">${derivation.erratum}</b> <b>${erratum.place}</b> ${rich(page.words.formula(derivation.errata[name]))}</p>
    <dl>${line('printed')}${line('corrected')}
      ${
        reading
          ? html`<dt>${derivation.truth}</dt><dd><span class="reading-value" data-reading="truth" data-exact=${String(reading.truth)}>${rich(erratum.symbol)} = <b>${value(page, reading, 'truth', erratum.unit)}</b></span></dd>`
          : html`<dt></dt><dd class="soft">${derivation.notThis}</dd>`
      }</dl></aside>`
}

function coefficients(page: Live, now: Moment): TemplateResult {
  const { words } = page
  const { coefficients: say, not } = words.say.derivation
  if (now.regime !== 'libration') return html`<p class="soft small">${not.libration}</p>`
  const { b } = seriesAt(now)
  let sum = 0
  const rows = b.slice(0, 5).map((each, i) => {
    sum += (i % 2 === 0 ? 1 : -1) * each
    return html`<tr><th scope="row">${i + 1}</th><td>${rich(words.significant(each, 6))}</td><td>${words.fixed(now.kappa * sum, 9)}</td></tr>`
  })
  return html`<table class="data lesson-table"><caption class="unseen">${say.name}</caption><thead><tr><th scope="col">${rich(say.order)}</th><th scope="col">${rich(say.value)}</th><th scope="col">${rich(say.sum)}</th></tr></thead>
    <tbody>${rows}<tr class="sum"><th scope="row" colspan="2">${rich(words.formula('sin(_θ_{max}/2)'))}</th><td>${words.fixed(now.kappa, 9)}</td></tr></tbody></table>`
}

const fourier = (argument: number): Curve => ({ name: 'fourier', argument, on: true })
const plain = (name: Curve['name']): Curve => ({ name, on: true })

/** The formulas whose errors each way through lists. */
const LISTED: Readonly<Record<EntryName, readonly Curve[]>> = {
  novice: [plain('linear'), plain('harmonic'), fourier(4), plain('trigonometric')],
  lima: [plain('linear'), plain('harmonic'), ...[1, 2, 3, 4, 6].map(fourier)],
  salas: [plain('linear'), plain('cubic'), plain('cubic-quintic'), plain('trigonometric')],
}

/** The largest errors in a period as parts of the turning angle; NaN where a formula has no value in a part of it, null where it is refused. */
const errorsOf = remember((now: Moment['motion'], entry: EntryName) =>
  LISTED[entry].map((curve) => {
    const solution = now.solution(curve, 0)
    const largest = 'refused' in solution || now.regime !== 'libration' ? null : solution.largest(1)
    if (!largest) return { curve, error: null }
    return { curve, error: Number.isNaN(largest.gone) ? largest.value / now.thetaMax : Number.NaN }
  }),
)

/** Of one formula, for a sentence. */
export function errorText(page: Live, name: Curve['name'], entry: EntryName): string {
  const found = errorsOf(page.motion, entry).find(({ curve }) => curve.name === name)
  return found?.error ? page.words.percent(100 * found.error) : '–'
}

function errors(page: Live): TemplateResult {
  const { words, state, motion } = page
  const { derivation, curves } = words.say
  const { errors: say } = derivation
  const rows = errorsOf(motion, state.entry).map(({ curve, error }) => {
    const name =
      curve.name === 'fourier'
        ? words.fill(say.fourier, { n: curve.argument ?? 0 })
        : `${curves[curve.name].name}, ${curves[curve.name].what}`
    const text = error === null ? say.refused : Number.isNaN(error) ? say.noValue : rich(words.percent(100 * error))
    return html`<tr><th scope="row">${rich(words.formula(name))}</th><td>${text}</td></tr>`
  })
  return html`<table class="data lesson-table"><caption class="unseen">${say.name}</caption><thead><tr><th scope="col">${say.formula}</th><th scope="col">${rich(say.error)}</th></tr></thead><tbody>${rows}</tbody></table>`
}

export function shownTable(page: Live, name: TableName, now: Moment): TemplateResult {
  return name === 'coefficients' ? coefficients(page, now) : errors(page)
}
