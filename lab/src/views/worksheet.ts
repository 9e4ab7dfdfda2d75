// The worksheet: what is chosen of it, and its pages as they are printed: exercises, charts, a table to fill in, the answers.

import { html, nothing, type TemplateResult } from 'lit-html'
import { switches } from '../controls/parts'
import { icon } from '../draw/icons'
import { type Answers, answersOf, type Exercises, exercisesOf, GRAVITY } from '../handouts/exercises'
import { rich } from '../language/rich'
import { writeLink } from '../link'
import { parseNumber } from '../number'
import { DEFAULTS, inRange, PAPERS, RANGES } from '../state'
import type { Live } from './page'
import { blank, motionChart, portraitSheet, ratioChart } from './sheet-charts'

type ExerciseName = keyof Live['words']['say']['handouts']['exercises']

const { least, most } = RANGES.seed
const isSeed = (value: number): boolean => Number.isInteger(value) && inRange('seed', value)

function choices(page: Live): TemplateResult {
  const { words, state, store, session } = page
  const { handouts } = words.say
  const draft = session.drafts.seed
  const bad = draft !== undefined && draft.trim() !== '' && !isSeed(parseNumber(draft))
  const typed = (event: Event) => {
    const text = (event.target as HTMLInputElement).value
    store.draft('seed', text)
    if (isSeed(parseNumber(text))) store.set({ seed: parseNumber(text) })
  }
  return html`<div class="column handout-choices">
    <div class="entry"><label for="seed">${handouts.seed}</label><span class="field ${bad ? 'bad' : ''}"><input id="seed" inputmode="numeric" autocomplete="off" .value=${draft ?? String(state.seed)}
      aria-invalid=${bad ? 'true' : 'false'} aria-describedby=${bad ? 'seed-fault' : 'seed-help'} @input=${typed} @blur=${() => !bad && store.draft('seed', null)}></span></div>
    ${bad ? html`<p class="fault" id="seed-fault" role="alert">${icon('warn')}<span>${words.fill(handouts.seedFault, { least: words.given(least), most: words.given(most) })}</span></p>` : nothing}
    <p class="soft small" id="seed-help">${handouts.seedHelp}</p>
    <button type="button" class="button" id="another" @click=${() => {
      store.draft('seed', null)
      store.set({ seed: state.seed < most ? state.seed + 1 : least })
    }}>${handouts.another}</button>
    <div class="entry"><span aria-hidden="true">${handouts.paper}</span>${switches(
      handouts.paper,
      PAPERS.map((value) => ({ value, text: handouts.papers[value] })),
      state.paper,
      (paper) => store.set({ paper }),
    )}</div>
    <label class="check"><input type="checkbox" id="key" .checked=${state.key} @change=${(event: Event) => store.set({ key: (event.target as HTMLInputElement).checked })}> ${handouts.key}</label>
    <p class="soft small">${handouts.keyHelp}</p>
    <button type="button" class="button primary" id="print" @click=${() => window.print()}>${handouts.print}</button></div>`
}

/** The texts of the exercises, with their numbers as this language writes them. */
function textsOf({ words }: Live, exercises: Exercises): Readonly<Record<ExerciseName, string>> {
  const { handouts, units } = words.say
  const { small, large, error, measured, portrait, top, energy } = exercises
  const centimetres = (value: number) => words.with(words.given(value), 'cm')
  const degrees = (value: number) => `${words.typed(value)}°`
  const texts = handouts.exercises
  return {
    small: words.fill(texts.small, { length: centimetres(small.length), angle: degrees(small.angle) }),
    large: words.fill(texts.large, { angle: degrees(large.angle) }),
    error: words.fill(texts.error, { angle: degrees(error.angle) }),
    measured: words.fill(texts.measured, {
      length: centimetres(measured.length),
      angle: degrees(measured.angle),
      time: words.with(words.fixed(measured.time / 100, 2), units.s),
    }),
    portrait: words.fill(texts.portrait, { length: centimetres(portrait.length) }),
    top: words.fill(texts.top, { length: centimetres(top.length), angle: degrees(top.angle) }),
    energy: words.fill(texts.energy, {
      length: centimetres(energy.length),
      angle: degrees(energy.angle),
      at: degrees(energy.at),
    }),
    reading: texts.reading,
  }
}

/** The answers as text, with as many digits as the sheet asks for. */
function answerTexts(
  { words }: Pick<Live, 'words'>,
  answers: Answers,
  exercises: Exercises,
): Readonly<Record<ExerciseName, string>> {
  const { handouts, units } = words.say
  const seconds = (value: number) => words.with(words.fixed(value, 3), units.s)
  const speed = (value: number) => words.with(words.fixed(value, 3), units['rad/s'])
  const g = (value: number) => words.with(words.fixed(value, 3), units['m/s2'])
  const percent = (value: number, digits: number) => words.with(words.fixed(100 * value, digits), '%')
  // Both formulas give less than the exact period.
  const short = (value: number, digits: number) => words.fill(handouts.tooShort, { percent: percent(-value, digits) })
  const { small, large, error, measured, portrait, top, energy, reading } = answers
  return {
    small: `_T_{0} = ${seconds(small)}`,
    large: `_T_/_T_{0} = ${words.fixed(large.ratio, 3)}, _T_ = ${seconds(large.period)}`,
    error: `${handouts.linear}: ${short(error.linear, 2)}; ${handouts.first}: ${short(error.first, 3)}`,
    measured: `${handouts.uncorrected} _g_ = ${g(measured.uncorrected)}; ${handouts.corrected} _g_ = ${g(measured.corrected)}`,
    portrait: portrait.map(({ name, turns }) => `${name}: ${turns ? handouts.turnsOver : handouts.swings}`).join('; '),
    top: `_θ'_ = ${speed(top)}`,
    energy: `${handouts.potential} ${percent(energy.potential, 1)}, _θ'_ = ${speed(energy.velocity)}`,
    reading: `${handouts.amplitude} ${words.typed(exercises.reading.angle)}°, _T_ = ${seconds(reading.period)}, _L_ = ${words.with(words.fixed(reading.length, 2), units.m)}`,
  }
}

const FIRST: readonly ExerciseName[] = ['small', 'large', 'error', 'measured']
const SECOND: readonly ExerciseName[] = ['portrait', 'top', 'energy', 'reading']
const LETTERS = 'abcdefgh'

function exercise({ words }: Live, name: ExerciseName, text: string): TemplateResult {
  const letter = LETTERS[[...FIRST, ...SECOND].indexOf(name)]
  return html`<li class="exercise" data-exercise=${name}><b>${letter})</b><div><p>${rich(text)}</p><p class="answer-line"><span>${words.say.handouts.answer}</span>${blank()}</p></div></li>`
}

function measurements({ words }: Live): TemplateResult {
  const { columns, measurements: title } = words.say.handouts
  const heads = [columns.amplitude, '_L_, m', columns.time, columns.period, columns.ratio, columns.g]
  const rows = Array.from({ length: 6 }, (_, i) => i)
  return html`<h3>${title}</h3><table class="empty-table"><thead><tr>${heads.map((head) => html`<th scope="col">${rich(head)}</th>`)}</tr></thead>
    <tbody>${rows.map(() => html`<tr>${heads.map(() => html`<td></td>`)}</tr>`)}</tbody></table>`
}

function head(page: Live, title: string): TemplateResult {
  const { words, state } = page
  const { handouts } = words.say
  return html`<div class="sheet-head"><h2>${title}</h2><span>${words.fill(handouts.sheet, { seed: state.seed })}</span></div>`
}

function pages(page: Live): TemplateResult {
  const { words, model, state } = page
  const { handouts, units } = words.say
  const { seed, paper } = state
  const exercises = exercisesOf(model, seed)
  const texts = textsOf(page, exercises)
  const answers = state.key ? answerTexts(page, answersOf(model, exercises), exercises) : null
  // Who scans or types it has the sheet and not the answers.
  const link =
    location.href.replace(/#.*$/, '') +
    writeLink({ ...DEFAULTS, view: 'handouts', seed, paper, language: words.language })
  const person = [handouts.name, handouts.course, handouts.date]
  return html`<section class="sheet" data-page="1">${head(page, handouts.title)}
      <p class="person">${person.map((each) => html`<span>${each}</span>${blank()}`)}</p>
      <p>${rich(words.fill(handouts.take, { g: words.with(words.given(GRAVITY), units['m/s2']) }))}</p>
      <ol class="exercises">${FIRST.map((name) => exercise(page, name, texts[name]))}</ol>${ratioChart(page)}</section>
    <section class="sheet" data-page="2">${head(page, handouts.title)}
      <ol class="exercises">${SECOND.map((name) => exercise(page, name, texts[name]))}</ol>
      <div class="sheet-pair">${portraitSheet(page, exercises)}${motionChart(page, exercises)}</div>
      ${measurements(page)}<p class="made">${words.fill(handouts.made, { link: '' })}<span class="sheet-link">${link}</span></p></section>
    ${
      answers
        ? html`<section class="sheet" data-page="key">${head(page, handouts.answers)}<p>${rich(handouts.answersOf)}</p>
      <ol class="exercises">${[...FIRST, ...SECOND].map((name, i) => html`<li class="exercise" data-answer=${name}><b>${LETTERS[i]})</b><p>${rich(answers[name])}</p></li>`)}</ol></section>`
        : nothing
    }`
}

export function worksheet(page: Live): TemplateResult {
  const { words, model, state } = page
  const { handouts, plots } = words.say
  // The size of the paper is not a matter of the style: the reader chooses it.
  const paper = html`<style>@page { size: ${state.paper}; margin: 14mm; }</style>`
  return html`<div class="handout-columns">${choices(page)}
    <div class="sheets ${state.paper}" tabindex="0" role="region" aria-label=${handouts.preview}>${paper}${
      model.complete ? pages(page) : html`<p class="waiting-line" role="status">${plots.loadingView}</p>`
    }</div></div>`
}
