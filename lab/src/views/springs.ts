// Springs: the force and the start, potential and phase portrait on one axis, the motion over time and the equilibria.

import '../language/springs'
import '../style/springs.css'
import { html, nothing, type TemplateResult } from 'lit-html'
import { switches } from '../controls/parts'
import { rich } from '../language/rich'
import type { SpringOrbit } from '../model/spring'
import { SPRING_KINDS } from '../state'
import { motionsReady } from './motions-module'
import type { Live } from './page'
import { player } from './player'
import { potentialChart, rangeWords, regimeWords, springPortrait } from './spring-portrait'
import { springPresets } from './spring-presets'
import { springTime } from './spring-time'
import { orbitOf, type SpringView, shortNumber, springView } from './spring-view'
import { numberValue, type Slide } from './values'

const EQUATIONS = {
  duffing: "_u''_ + _p_ _u_ + _q_ _u_³ = 0",
  'helmholtz-duffing': "_u''_ + _p_ _u_ + _r_ _u_² + _q_ _u_³ = _c_",
  'cubic-quintic': "_u''_ + _p_ _u_ + _q_ _u_³ + _s_ _u_⁵ = 0",
} as const

const COEFFICIENTS = {
  duffing: ['p', 'q'],
  'helmholtz-duffing': ['p', 'r', 'q', 'c'],
  'cubic-quintic': ['p', 'q', 's'],
} as const

/** Ends of a slider about a value, which may lie beyond them. */
const slide = (most: number): Slide => ({
  least: -most,
  most,
  step: most / 50,
  grain: most / 100,
  origin: 0,
  ticks: [0],
})
const SLIDES = {
  p: slide(5),
  r: slide(5),
  q: slide(5),
  c: slide(5),
  s: slide(5),
  u0: slide(4),
  springVelocity0: slide(5),
} as const

function force(page: Live): TemplateResult {
  const { words, state, store } = page
  const { spring } = words.say
  return html`<div class="spring-force"><div class="head">${switches(
    spring.kind,
    SPRING_KINDS.map((value) => ({ value, text: spring.kinds[value] })),
    state.spring,
    (kind) => store.set({ spring: kind }),
  )}${springPresets(page)}</div>
    <p class="equation">${rich(EQUATIONS[state.spring])}</p></div>
    <div class="spring-values">${([...COEFFICIENTS[state.spring], 'u0', 'springVelocity0'] as const).map((name) =>
      numberValue(page, name, spring.values[name], SLIDES[name]),
    )}</div>`
}

/** A time with its decimals, or with as many digits where they would be zeros or say nothing. */
const timeWords = ({ words }: Live, value: number, decimals: number): string =>
  value > 0 && (value < 0.1 || value >= 1e6) ? words.significant(value, decimals) : words.fixed(value, decimals)

const endless = (page: Live, value: number): string =>
  Number.isFinite(value) ? timeWords(page, value, 4) : page.words.say.spring.facts.infinite

function facts(page: Live, orbit: SpringOrbit): TemplateResult {
  const { words } = page
  const { spring } = words.say
  const { facts: say } = spring
  const escapes = Number.isFinite(orbit.escapeTime)
  const row = (name: string, value: string, id = '', big = '') =>
    html`<dt class=${big}>${rich(name)}</dt><dd class=${big} id=${id === '' ? nothing : id}>${rich(value)}</dd>`
  const from = orbit.escapeTimeBackward
  return html`<dl class="facts">
    ${escapes ? row(say.escape, timeWords(page, orbit.escapeTime, 4), 'spring-escape', 'big') : row(say.period, endless(page, orbit.period), 'spring-period', 'big')}
    ${row(say.regime, regimeWords(page, orbit), 'spring-regime')}
    ${row(say.energy, shortNumber(words, orbit.energy), 'spring-energy')}
    ${row(say.range, rangeWords(page, orbit), 'spring-range')}
    ${Number.isFinite(from) ? row(say.from, timeWords(page, from, 4), 'spring-from') : nothing}</dl>`
}

function equilibriaTable({ page, orbit }: SpringView): TemplateResult {
  const { words } = page
  const { spring } = words.say
  return html`<table class="data" id="spring-equilibria" aria-labelledby="equilibria-title"><thead><tr><th scope="col">${rich(spring.place)}</th><th scope="col">${rich(spring.height)}</th><th scope="col">${spring.stability}</th></tr></thead>
    <tbody>${orbit.equilibria.map(
      ({ u, height, stable }) =>
        html`<tr><th scope="row">${rich(shortNumber(words, u))}</th><td>${rich(shortNumber(words, height))}</td><td>${stable ? spring.stable : spring.unstable}</td></tr>`,
    )}${orbit.equilibria.length === 0 ? html`<tr><th scope="row">${spring.none}</th><td></td><td></td></tr>` : nothing}</tbody></table>`
}

function body(page: Live): TemplateResult {
  const { spring } = page.words.say
  const waiting = motionsReady(page, spring)
  if (waiting) return waiting
  const view = springView(page)
  const { axes } = view
  return html`<div class="spring-columns"><div class="column left">${force(page)}${facts(page, view.orbit)}</div>
    <div class="column middle">${potentialChart(view)}${springPortrait(view)}</div>
    <div class="column right">${springTime(view)}${player(view.page, { from: 0, to: axes.span }, [], html``)}
      <section class="spring-places"><h2 id="equilibria-title">${spring.equilibria}</h2>${equilibriaTable(view)}<p class="soft small">${spring.help}</p></section></div>
  </div>`
}

function sentence(page: Live): string {
  const { words, state } = page
  const { spring, sentence: first } = words.say
  if (motionsReady(page, spring)) return first.waiting
  const orbit = orbitOf(state)
  const { regime, period, low, high, escapeTime, escapeTimeBackward, u0, equilibria } = orbit
  const short = (value: number) => shortNumber(words, value)
  const values = {
    name: spring.names[orbit.name],
    low: short(low),
    high: short(high),
    period: timeWords(page, period, 3),
    time: timeWords(page, Number.isFinite(escapeTime) ? escapeTime : escapeTimeBackward, 3),
    u: short(u0),
  }
  switch (regime) {
    case 'rest':
      // Without a force it rests anywhere.
      return words.fill(
        orbit.name === 'free' || equilibria.some(({ u, stable }) => stable && Math.abs(u - u0) <= 1e-9 * Math.abs(u))
          ? spring.rests
          : spring.balances,
        values,
      )
    case 'libration':
      return words.fill(orbit.even ? spring.between : spring.swings, values)
    case 'well':
      return words.fill(orbit.even ? spring.oneWell : spring.well, values)
    case 'escape':
      if (!Number.isFinite(escapeTime)) return words.fill(spring.came, values)
      return words.fill(orbit.escapesTo > 0 ? spring.escapes : spring.escapesDown, values)
    case 'linear':
      if (Number.isFinite(period)) return words.fill(orbit.even ? spring.between : spring.swings, values)
      return words.fill(orbit.name === 'free' ? spring.even : spring.runs, values)
    default:
      return words.fill(spring[regime], values)
  }
}

export const part = { sentence, body }
