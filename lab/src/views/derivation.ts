// Derivation: from the force diagram to θ(t) in three ways, each equality with the numbers of the reader's own pendulum. The words
// stand beside the pendulum; every number goes on with its time.

import '../language/derivation'
import '../style/derivation.css'
import { html, type TemplateResult } from 'lit-html'
import { switches } from '../controls/parts'
import { type Block, LESSONS, type Step } from '../derivation/lessons'
import { Moment } from '../derivation/moment'
import { angleOf, CIRCLE_BOX, circle } from '../draw/circle'
import { FORCES_BOX, forces } from '../draw/forces'
import { icon } from '../draw/icons'
import { plain, rich } from '../language/rich'
import { remember } from '../memory'
import type { Model, Motion } from '../model'
import { ENTRIES, type EntryName } from '../state'
import { windowOf } from '../study'
import { bench } from './bench'
import { errorText, shownEquality, shownErratum, shownTable } from './derivation-numbers'
import type { Live } from './page'
import { player } from './player'

interface StepWords {
  readonly title: string
  readonly text: readonly string[]
}

const momentOf = remember((model: Model, motion: Motion, t: number) => new Moment(model, motion, t))

const stepsOf = (entry: EntryName): readonly Step[] => LESSONS[entry]

function wordsOf({ words }: Live, entry: EntryName, name: string): StepWords {
  const found = (words.say.derivation.lessons[entry] as Readonly<Record<string, StepWords>>)[name]
  if (!found) throw new Error(`no words for ${name}`)
  return found
}

/** The step of the link: a way through may have fewer. */
const stepAt = ({ state }: Live): number => Math.min(state.step, stepsOf(state.entry).length)

/** What the view was last brought to, so that it goes there once. */
let brought = ''

function bringTo(step: number): void {
  const still = matchMedia('(prefers-reduced-motion: reduce)').matches
  document.getElementById(`step-${step}`)?.scrollIntoView({ behavior: still ? 'auto' : 'smooth', block: 'start' })
}

/** Scrolls to the step of the state after it is drawn, unless the reader is in it already. */
function follow(page: Live): void {
  const wanted = `${page.state.entry} ${stepAt(page)}`
  // The view has just been opened.
  if (!document.querySelector('.lesson')) brought = ''
  if (brought === wanted) return
  const first = brought === '' && stepAt(page) === 1
  brought = wanted
  if (!first) queueMicrotask(() => bringTo(stepAt(page)))
}

function go({ store, state }: Live, step: number): void {
  const most = stepsOf(state.entry).length
  if (step < 1 || step > most) return
  // To the step that is current too, which the reader may have scrolled away from.
  brought = 'elsewhere'
  store.set({ step })
}

/** The reader has put the focus or the pointer into a step: it is the current one where it is. */
function enter(page: Live, step: number): void {
  brought = `${page.state.entry} ${step}`
  if (stepAt(page) !== step) page.store.set({ step })
}

function bar(page: Live): TemplateResult {
  const { words, state, store } = page
  const { derivation: say } = words.say
  const entries = ENTRIES.map((value) => ({ value, text: say.entries[value] }))
  const steps = stepsOf(state.entry).map(({ name }, i) => ({
    value: i + 1,
    text: String(i + 1),
    name: words.fill(say.stepName, { step: i + 1, title: plain(wordsOf(page, state.entry, name).title) }),
  }))
  const at = stepAt(page)
  const arrow = (name: string, key: 'back' | 'next', to: number) =>
    html`<button type="button" class="icon" data-step=${key} title=${name} aria-label=${name} ?disabled=${to < 1 || to > steps.length}
      @click=${() => go(page, to)}>${icon(key === 'next' ? 'next' : 'before')}</button>`
  return html`<div class="lesson-bar"><span class="soft option"><span class="for">${say.entry}</span> ${switches(say.entry, entries, state.entry, (entry) => store.set({ entry, step: 1 }))}</span>
    <span class="step-list">${arrow(say.back, 'back', at - 1)}${switches(say.steps, steps, at, (step) => go(page, step))}${arrow(say.next, 'next', at + 1)}</span></div>`
}

/** What a paragraph may speak of. */
function values(page: Live, now: Moment): Record<string, string> {
  const { words, state, motion, model: core } = page
  const swings = motion.regime === 'libration'
  const off = (name: string) =>
    swings
      ? words.percent(100 * Math.abs(core.periodError(name, Float64Array.of(motion.thetaMax))[0] ?? Number.NaN))
      : '–'
  return {
    exact: words.angle(now.theta, 3),
    linear: words.angle(now.approximate({ name: 'linear', on: true }), 3),
    seriesError: off('series:4'),
    salasError: off('salas-28'),
    harmonicError: state.entry === 'lima' ? errorText(page, 'harmonic', 'lima') : '–',
  }
}

function kindOfMotion(page: Live, now: Moment): TemplateResult {
  const { words, motion } = page
  const text = words.fill(words.say.derivation.kind[now.regime], {
    m: words.fixed(now.m, 4),
    angle: words.angle(motion.thetaMax, 1),
  })
  return html`<p class="kind-of-motion" id="kind-of-motion">${rich(text)}</p>`
}

function figure(page: Live, name: 'forces' | 'circle', now: Moment): TemplateResult {
  const { words } = page
  const { derivation } = words.say
  const fixed = (value: number) => words.fixed(value, 4)
  if (name === 'circle') {
    const { x, s } = now.now
    const swings = now.regime === 'libration'
    const place = words.fill(derivation.circle.caption, { x: fixed(x), s: fixed(s), kappa: fixed(now.kappa) })
    const angle = words.fill(derivation.circle.angle, { phi: words.angle(angleOf(x, s), 1) })
    const caption = swings ? `${place} ${angle}` : place
    const spec = {
      x,
      s,
      kappa: now.kappa,
      swings,
      width: "_θ'_/(2_ω_{0})",
      height: words.formula('sin(_θ_/2)'),
    }
    return html`<figure class="lesson-figure drawing"><svg viewBox="0 0 ${CIRCLE_BOX.width} ${CIRCLE_BOX.height}" role="img" aria-label=${derivation.circle.name}>${circle(spec)}</svg>
      <figcaption class="soft small">${rich(words.formula(caption))}</figcaption></figure>`
  }
  const newton = (value: number) => words.with(words.fixed(value, 3), 'N')
  const { weight, along, across, pull } = now.forces
  const say = derivation.forces
  const caption = words.fill(say.caption, {
    weight: newton(weight),
    along: newton(along),
    across: newton(across),
    pull: newton(pull),
  })
  const spec = { ...say, along: words.formula(say.along) }
  return html`<figure class="lesson-figure drawing"><svg viewBox="0 0 ${FORCES_BOX.width} ${FORCES_BOX.height}" role="img" aria-label=${say.name}>${forces(spec)}</svg>
    <figcaption class="soft small">${caption}</figcaption></figure>`
}

function shownBlock(page: Live, block: Block, now: Moment, paragraph: () => string): TemplateResult {
  switch (block.kind) {
    case 'p':
      return html`<p>${rich(page.words.formula(paragraph()))}</p>`
    case 'kind-of-motion':
      return kindOfMotion(page, now)
    case 'figure':
      return figure(page, block.name, now)
    case 'table':
      return shownTable(page, block.name, now)
    case 'equality':
      return shownEquality(page, block.equality, now)
    case 'erratum':
      return shownErratum(page, block.name, now)
  }
}

function shownStep(
  page: Live,
  { name, blocks }: Step,
  number: number,
  now: Moment,
  filled: Record<string, string>,
): TemplateResult {
  const { words, state } = page
  const { title, text } = wordsOf(page, state.entry, name)
  const on = stepAt(page) === number
  let at = 0
  const paragraph = () => words.fill(text[at++] ?? '', filled)
  return html`<section class="step ${on ? 'on' : ''}" id="step-${number}" aria-labelledby="step-title-${number}" aria-current=${on ? 'step' : 'false'}
    @click=${() => enter(page, number)} @focusin=${() => enter(page, number)}>
    <h2 id="step-title-${number}"><span class="step-number">${number}</span>${rich(title)}</h2>
    ${blocks.map((block) => shownBlock(page, block, now, paragraph))}</section>`
}

function body(page: Live): TemplateResult {
  const { model: core, motion, t, state, words } = page
  const { period } = motion
  const now = momentOf(core, motion, t)
  const window = windowOf(Number.isFinite(period) ? period : 8, t)
  const filled = values(page, now)
  follow(page)
  const last = html`<span class="soft option"><span>${rich(!Number.isFinite(period) ? '' : now.regime === 'rotation' ? words.say.functions.oneTurn : words.say.functions.onePeriod)}</span></span>`
  return html`<div class="derivation-columns"><div class="lesson">${bar(page)}
      ${stepsOf(state.entry).map((step, i) => shownStep(page, step, i + 1, now, filled))}</div>
    ${bench(page, [])}</div>${player(page, window, [], last)}`
}

function sentence(page: Live): string {
  const { words, state } = page
  const steps = stepsOf(state.entry)
  const step = stepAt(page)
  const title = wordsOf(page, state.entry, steps[step - 1]?.name ?? '').title
  return words.fill(words.say.derivation.sentence, { step, count: steps.length, title })
}

/** The letters of the formulas, which would else come when one is first seen. */
export async function formulaFont(): Promise<void> {
  await document.fonts.load('1em "Libration Formulas"')
}

export const part = { sentence, body }
