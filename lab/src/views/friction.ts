// Friction: what acts on the pendulum, its angle and energy over time, the spiral and the section, and what becomes of it in words.

import '../language/friction'
import '../style/friction.css'
import { html, nothing, type TemplateResult } from 'lit-html'
import { plain, rich } from '../language/rich'
import type { DampedMotion } from '../model/friction'
import { LONGEST } from '../model/section'
import { degrees } from '../number'
import type { RangeName } from '../state'
import { dampedAngle, dampedEnergy, halfOf } from './friction-charts'
import { sectionChart, spiralChart } from './friction-phase'
import { frictionPresets } from './friction-presets'
import { dampedOf, type FrictionView, frictionView, sectionOf } from './friction-view'
import { motionsReady } from './motions-module'
import type { Live } from './page'
import { player } from './player'
import { numberEntry, numberValue, type Slide, slideOf } from './values'

const slide = (most: number, least = 0): Slide => {
  return { least, most, step: most / 50, grain: most / 200, origin: 0, ticks: [0] }
}
const ACTING = {
  linear: slide(1),
  quadratic: slide(1),
  dry: slide(2),
  torque: slide(2, -2),
  drive: slide(4),
  driveFrequency: { ...slide(4), least: 0.02 },
} as const
type ActingName = keyof typeof ACTING
const START = ['theta0', 'velocity0', 'length', 'gravity'] as const

function left(page: Live): TemplateResult {
  const { words } = page
  const { damped, values } = words.say
  const names = Object.keys(ACTING) as ActingName[]
  return html`<div class="column left"><div class="friction-force"><div class="head">${frictionPresets(page)}</div>
    <p class="equation">${rich(words.formula(damped.equation))}</p></div>
    <div class="friction-values">${names.map((name) => numberValue(page, name, damped.values[name], ACTING[name]))}</div>
    <div class="friction-start">${START.map((name) => numberEntry(page, name, values[name], slideOf(page, name as RangeName)))}
    ${numberEntry(page, 'until', damped.values.until, { ...slide(600), least: 1, step: 1, grain: 1 })}</div></div>`
}

function facts(page: Live, { damped, section }: FrictionView): TemplateResult {
  const { words, state, motion } = page
  const { damped: say, units } = words.say
  const { facts: names } = say
  const seconds = (value: number) => words.with(words.fixed(value, 2), units.s)
  const row = (id: string, name: string, value: string) =>
    html`<dt>${rich(name)}</dt><dd id="friction-${id}">${rich(value)}</dd>`
  const half = halfOf(damped)
  const rest = damped.rests.at(-1)
  const stopped = rest !== undefined && rest[1] === damped.reach && !damped.driven
  const repeats = section?.repeats ?? null
  const end = words.percent(100 * damped.energyAt(damped.reach))
  return html`<dl class="facts">
    ${Number.isNaN(half) ? nothing : row('half', names.half, seconds(half))}
    ${stopped ? html`${row('rest', names.rest, seconds(rest[0]))}${row('rest-angle', names.restAngle, `${words.fixed(degrees(damped.at(damped.reach).theta), 3)}°`)}` : nothing}
    ${section ? row('repeats', names.repeats, repeats === null ? names.none : repeats === 1 ? names.one : words.fill(names.periods, { count: repeats })) : nothing}
    ${row('turns', names.turns, words.given(damped.turnsOver))}
    ${section ? nothing : html`${row('swings', names.swings, words.given(damped.turning.t.length))}${row('end', names.end, end)}`}
    ${state.linear > 0 ? row('quality', state.quadratic > 0 || state.dry > 0 ? names.qualityLinear : names.quality, words.significant(motion.omega0 / (2 * state.linear))) : nothing}</dl>`
}

/** Of a motion that takes long: how far it is, and the way to be content with that. */
function computing({ words, state, store }: Live, damped: DampedMotion): TemplateResult {
  const { damped: say } = words.say
  const end = () => {
    damped.end()
    store.changed()
  }
  return html`<div class="section-progress"><progress max=${state.until} .value=${damped.reach} aria-label=${plain(say.computing)}></progress>
    <button type="button" class="button" id="friction-end" @click=${end}>${say.endHere}</button></div>`
}

function body(page: Live): TemplateResult {
  const waiting = motionsReady(page, page.words.say.damped)
  if (waiting) return waiting
  const damped = dampedOf(page)
  if (!damped.done)
    return html`<div class="friction-columns">${left(page)}<div class="column middle">${computing(page, damped)}</div></div>`
  const view = frictionView(page)
  const { section } = view
  return html`<div class="friction-columns">${left(page)}
    <div class="column middle">${dampedAngle(view)}${dampedEnergy(view)}${player(view.page, { from: 0, to: page.state.until }, [], html``)}</div>
    <div class="column right">${spiralChart(view)}${section ? sectionChart(view, section) : nothing}${facts(page, view)}</div></div>`
}

/** Of a driven pendulum: after how many periods it repeats, as soon as that is known. */
function drivenSentence(page: Live): string {
  const { words, state } = page
  const { damped: say, units } = words.say
  const section = sectionOf(page)
  const { count = 0, most = 0, done = false, stopped = false, repeats = null } = section ?? {}
  if (repeats === 1)
    return words.fill(say.repeats, {
      period: words.with(words.fixed((2 * Math.PI) / state.driveFrequency, 3), units.s),
    })
  if (repeats !== null) return words.fill(say.repeatsMany, { count: repeats })
  return words.fill(stopped ? say.tooFast : done ? say.chaotic : say.driving, { count, most, longest: LONGEST })
}

function sentence(page: Live): string {
  const { words, state } = page
  const { damped: say, units } = words.say
  if (motionsReady(page, say)) return words.say.sentence.waiting
  const damped = dampedOf(page)
  if (!damped.done) return say.computing
  if (state.drive !== 0) return drivenSentence(page)
  const seconds = (value: number) => words.with(words.significant(value, 3), units.s)
  const until = words.with(words.given(damped.reach), units.s)
  const angle = (theta: number) => `${words.fixed(degrees(theta), 1)}°`
  const count = Math.abs(damped.turnsOver)
  const outcome = damped.outcome()
  const over =
    count === 0 || state.torque !== 0 || outcome.kind === 'exact'
      ? ''
      : words.fill(count === 1 ? say.turnsOnce : say.turns, { count })
  const then = (text: string) => `${over} ${text}`.trim()
  if (over !== '' && damped.turnsStill) return words.fill(say.turnsStill, { count, time: until })
  switch (outcome.kind) {
    case 'stops':
      return then(words.fill(say.stops, { angle: angle(outcome.theta), time: seconds(outcome.t) }))
    case 'halves':
      return then(words.fill(say.halves, { time: seconds(outcome.t) }))
    case 'keeps':
      return then(words.fill(say.keeps, { time: until, percent: words.percent(100 * outcome.part, 2) }))
    case 'rotates':
      return words.fill(say.rotates, { velocity: words.with(words.significant(outcome.velocity), units['rad/s']) })
    case 'settles':
      return words.fill(say.settles, { time: until, angle: angle(outcome.theta) })
    default:
      return say[outcome.kind]
  }
}

export const part = { sentence, body }
