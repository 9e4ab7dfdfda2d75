// Legend, switch and result in one list: the exact motion, then each curve with its largest error in the window.

import { html, nothing, type TemplateResult } from 'lit-html'
import type { Column } from '../columns'
import { menu } from '../controls/parts'
import { type Curve, type CurveName, curveKey, kindOf, usualCurve } from '../curves'
import { icon } from '../draw/icons'
import { isLocked } from '../embedding'
import { plain, rich } from '../language/rich'
import { curveFault, MOST_CURVES, missingCurves, withCurve } from '../state'
import { type Drawn, errorFactor, inPercent, type Row, type Study } from '../study'
import { openDialog } from './dialogs'
import { examples } from './examples'
import type { Live } from './page'

/** `Fourier 4`, `RK4, step 0.025 s`: a curve in words. */
export function curveName({ words }: Pick<Live, 'words'>, curve: Curve): string {
  const { name } = words.say.curves[curve.name]
  if (curve.argument === undefined) return plain(name)
  const { argument } = kindOf(curve.name)
  const base = plain(name).replace(/ N$/, '')
  if (argument?.of === 'order') return `${base} ${curve.argument}`
  return `${base} ${words.with(words.given(curve.argument), words.say.units.s)}`
}

/** What the table of a plot says of a curve, and of the exact motion without one. */
export function curveColumn(page: Pick<Live, 'words'>, drawn?: Drawn): Pick<Column, 'title' | 'clothes' | 'about'> {
  const { compare, curves } = page.words.say
  if (!drawn) return { title: compare.exact, clothes: 'c-exact', about: compare.exactBy }
  const { curve, clothes } = drawn
  return { title: curveName(page, curve), clothes, about: page.words.formula(curves[curve.name].what) }
}

function sample(clothes: string, framed: boolean): TemplateResult {
  return html`<svg class=${framed ? 'key framed' : 'key'} viewBox="0 0 44 22" aria-hidden="true"><path class="c ${clothes}" d="M4 11H40"/></svg>`
}

/** The next argument up or down: whole numbers for terms, 1 2 5 10 for steps. */
function nextArgument(curve: Curve, up: boolean): number {
  const { argument } = kindOf(curve.name)
  const value = curve.argument ?? 0
  if (!argument) return value
  const within = (next: number) => Math.min(argument.most, Math.max(argument.least, next))
  if (argument.of === 'order') return within(value + (up ? 1 : -1))
  const ladder = [0.0001, 0.0002, 0.0005, 0.001, 0.002, 0.005, 0.01, 0.025, 0.05, 0.1, 0.2, 0.5, 1]
  const found = up ? ladder.find((each) => each > value * 1.0001) : ladder.findLast((each) => each < value * 0.9999)
  return within(found ?? value)
}

function stepper(page: Live, curve: Curve): TemplateResult | typeof nothing {
  const { argument } = kindOf(curve.name)
  if (!argument || curve.argument === undefined) return nothing
  const { words, state, store } = page
  const { compare } = words.say
  const name = plain(words.say.curves[curve.name].name)
  const change = (up: boolean) => {
    const next = { ...curve, argument: nextArgument(curve, up) }
    if (curveFault(next) || state.curves.some((each) => curveKey(each) === curveKey(next))) return
    store.set({ curves: state.curves.map((each) => (each === curve ? next : each)) })
  }
  const [less, more] = argument.of === 'order' ? [compare.fewer, compare.moreTerms] : [compare.shorter, compare.longer]
  return html`<span class="stepper"><button type="button" aria-label=${words.fill(less, { name })} @click=${() => change(false)}>−</button><span class="count">${words.given(curve.argument)}</span><button type="button" aria-label=${words.fill(more, { name })} @click=${() => change(true)}>+</button></span>`
}

/** The largest error, or the word for why there is none. */
function result(page: Live, study: Study, { drawn }: Row): string {
  const { words, state } = page
  if (!drawn || drawn.largest === null) return drawn ? words.say.compare.hatched : words.say.compare.none
  if (!Number.isNaN(drawn.gone)) return words.say.compare.hatched
  const percent = inPercent(state, study)
  const size = drawn.largest.value * errorFactor(percent, study.motion)
  if (!Number.isFinite(size)) return '∞'
  return percent ? words.percent(size) : words.degrees(size)
}

/** Second line: what it is, or what must be known of it here. */
function remark(page: Live, study: Study, { drawn, refused, curve }: Row): string {
  const { words, model } = page
  const { curves, reasons, compare } = words.say
  if (refused !== null) return reasons[refused as keyof typeof reasons] ?? compare.refused
  const what = words.formula(curves[curve.name].what)
  if (drawn && Number.isFinite(drawn.solution.overTop) && drawn.solution.overTop <= study.window.to) {
    return words.fill(compare.overTop, { t: words.with(words.fixed(drawn.solution.overTop, 2), words.say.units.s) })
  }
  const stated = model.statedMost(curve.name)
  if (drawn && stated !== null && study.motion.thetaMax > stated) {
    return `${what}, ${words.fill(compare.stated, { range: words.angle(stated, 0) })}`
  }
  return what
}

function row(page: Live, study: Study, each: Row): TemplateResult {
  const { store, state, session, words } = page
  const { curve, key, clothes, refused } = each
  const drawnNow = state.curves.filter((one) => one.on).length
  const full = !curve.on && drawnNow >= MOST_CURVES
  const name = curveName(page, curve)
  const value = result(page, study, each)
  const text = remark(page, study, each)
  const toggle = (event: Event) => {
    const on = (event.target as HTMLInputElement).checked
    store.set({ curves: state.curves.map((one) => (one === curve ? { ...one, on } : one)) })
  }
  const remove = (event: KeyboardEvent) => {
    if (event.key === 'Delete') store.set({ curves: state.curves.filter((one) => one !== curve) })
  }
  return html`<li class="row ${curve.on && refused === null ? '' : 'off'} ${session.pointed === key ? 'pointed' : ''}"
    @pointerenter=${() => curve.on && store.setSession({ pointed: key })} @pointerleave=${() => store.setSession({ pointed: null })}>
    <input type="checkbox" id="curve-${key}" .checked=${curve.on} ?disabled=${refused !== null || full} aria-label="${name}: ${plain(value)}. ${plain(text)}" title=${full ? words.say.compare.full : nothing}
      @change=${toggle} @keydown=${remove} @focus=${() => curve.on && store.setSession({ pointed: key })} @blur=${() => store.setSession({ pointed: null })}>
    ${sample(clothes, true)}
    <span class="name"><span>${rich(words.say.curves[curve.name].name)}</span>${stepper(page, curve)}<small>${rich(text)}</small></span>
    <span class="result">${rich(value)}</span>
    <button type="button" class="icon remove" aria-label=${words.fill(words.say.compare.remove, { name })} title=${words.fill(words.say.compare.remove, { name })}
      @click=${() => store.set({ curves: state.curves.filter((one) => one !== curve) })}>${icon('close')}</button>
  </li>`
}

/** A curve of this kind that the list does not have. */
function fresh(curves: readonly Curve[], name: CurveName): Curve {
  let curve = usualCurve(name)
  for (let tries = 0; tries < 12 && curves.some((each) => curveKey(each) === curveKey(curve)); tries++) {
    curve = { ...curve, argument: nextArgument(curve, true) }
  }
  return curve
}

function addMenu(page: Live): TemplateResult {
  const { store, state, session, words } = page
  return menu({
    key: 'add',
    label: html`${icon('plus')}${words.say.compare.add}`,
    name: words.say.compare.add,
    open: session.menu === 'add',
    toggle: (open) => store.setSession({ menu: open ? 'add' : null }),
    up: state.curves.length > 4,
    items: missingCurves(state.curves).map((name) => ({
      text: words.say.curves[name].name,
      note: words.formula(words.say.curves[name].what),
      act: () => store.set({ curves: withCurve(state.curves, fresh(state.curves, name)) }),
    })),
  })
}

function heading({ words, state }: Live, { window, motion }: Study): TemplateResult {
  const { compare, units } = words.say
  const whole = state.span === 'T' && Number.isFinite(motion.period)
  const digits = (value: number) => words.given(Number(value.toFixed(2)))
  const text = whole
    ? compare.largestPeriod
    : words.fill(compare.largest, { from: digits(window.from), to: digits(window.to), unit: units.s })
  return html`<div class="caption"><span>${compare.curve}</span><span>${rich(text)}</span></div>`
}

/** The way to the errors against the step, once a curve goes step by step. */
function stepping(page: Live): TemplateResult | typeof nothing {
  if (page.state.hide || !page.state.curves.some(({ name }) => kindOf(name).numerical)) return nothing
  return html`<button type="button" class="text-button" id="convergence" @click=${() => openDialog(page, 'convergence')}>${page.words.say.compare.convergence}</button>`
}

export function compareList(page: Live, study: Study): TemplateResult {
  const { compare, embedding } = page.words.say
  const list = html`<ul class="rows"><li class="row exact">${sample('c-exact', false)}<span class="name">${compare.exact}<small>${compare.exactBy}</small></span><span class="result">0</span></li>
    ${study.rows.map((each) => row(page, study, each))}</ul>
    <div class="foot">${addMenu(page)}${examples(page)}</div>`
  const locked = isLocked(page.state, 'curves')
  return html`<section class="compare" aria-labelledby="compare-title"><div class="head"><h2 id="compare-title">${compare.title}</h2>${stepping(page)}</div>
    ${heading(page, study)}
    ${locked ? html`<fieldset disabled title=${embedding.locked}>${list}</fieldset>` : list}
  </section>`
}
