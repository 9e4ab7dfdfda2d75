// The orbits of the portrait as a list: letter, start, kind of motion, period. The chosen one is the motion of the page.

import { html, nothing, type TemplateResult } from 'lit-html'
import { hint, menu } from '../controls/parts'
import { icon } from '../draw/icons'
import { isRefused } from '../embedding'
import type { Motion } from '../model'
import { DEGREES, radians } from '../number'
import { allOrbits, choose, letterOf, placeOf, withOrbit, withoutOrbit } from '../orbits'
import { MOST_ORBITS, type Start } from '../state'
import { type Live, quantityText } from './page'

/** `150°, 0 rad/s`: as given, four decimals at most. */
export function orbitWords({ words }: Pick<Live, 'words'>, { theta0, velocity0 }: Start): string {
  const angle = Number((theta0 * DEGREES).toFixed(2))
  return `${words.given(angle)}°, ${quantityText(words, 'velocity0', Number(velocity0.toFixed(4)))}`
}

function row(page: Live, motion: Motion, start: Start, place: number, count: number): TemplateResult {
  const { words, store, state } = page
  const { phase, facts, units } = words.say
  const letter = letterOf(place)
  const { regime, period, energyRatio } = motion
  const time =
    regime === 'rest'
      ? facts.none
      : Number.isFinite(period)
        ? words.with(words.fixed(period, 3), units.s)
        : facts.infinite
  const energy = words.with(
    words.fixed(100 * energyRatio, energyRatio !== 1 && energyRatio > 0.99 && energyRatio < 1.01 ? 2 : 0),
    '%',
  )
  const text = words.fill(phase.energy, { regime: phase.regimes[regime], energy })
  const chosen = place === placeOf(state)
  // Where a start is locked, its orbit stays the chosen one.
  const locked = isRefused(state, choose(state, place))
  const stays = isRefused(state, withoutOrbit(state, place))
  const remove = () => store.set({ ...withoutOrbit(state, place), t: 0 })
  const removeName = words.fill(phase.remove, { letter })
  return html`<div class="row orbit-row ${chosen ? 'chosen' : ''}" data-orbit=${letter}>
    <input type="radio" name="orbit" id="orbit-${letter}" .checked=${chosen} ?disabled=${locked} title=${locked ? words.say.embedding.locked : nothing} aria-label="${letter}: ${orbitWords(page, start)}, ${text}, ${phase.period} ${time}"
      @change=${() => store.set({ ...choose(state, place) })} @keydown=${(event: KeyboardEvent) => event.key === 'Delete' && remove()}>
    <b class="letter" aria-hidden="true">${letter}</b>
    <span class="name"><span class="number">${orbitWords(page, start)}</span><small>${text}</small></span><span class="result">${time}</span>
    ${
      count > 1 && !stays
        ? html`<button type="button" class="icon remove" aria-label=${removeName} title=${removeName} @click=${remove}>${icon('close')}</button>`
        : nothing
    }</div>`
}

const SWINGS = [90, 120, 30, 150, 60, 170]

function addMenu(page: Live): TemplateResult {
  const { words, store, state, session, motion } = page
  const { phase } = words.say
  const all = allOrbits(state)
  const full = all.length >= MOST_ORBITS
  const top = motion.separatrixVelocity(0)
  const free = SWINGS.find(
    (angle) => !all.some(({ theta0, velocity0 }) => theta0 === radians(angle) && velocity0 === 0),
  )
  const kinds: readonly [string, Start][] = [
    [phase.addLibration, { theta0: radians(free ?? 75), velocity0: 0 }],
    [phase.addSeparatrix, { theta0: 0, velocity0: top }],
    [phase.addRotation, { theta0: 0, velocity0: -Number((1.2 * top).toPrecision(2)) }],
  ]
  return menu({
    key: 'orbit',
    label: html`${icon('plus')}${phase.add}`,
    name: phase.add,
    open: session.menu === 'orbit',
    toggle: (open) => store.setSession({ menu: open ? 'orbit' : null }),
    items: kinds.map(([text, start]) => ({
      text,
      note: orbitWords(page, start),
      disabled: full || isRefused(state, withOrbit(state, start)),
      act: () => store.set({ ...withOrbit(state, start), t: 0 }),
    })),
  })
}

export function orbitList(page: Live, motions: readonly Motion[]): TemplateResult {
  const { words, state, session, store } = page
  const { phase, hints } = words.say
  const all = allOrbits(state)
  const [before = '', after = ''] = words.fill(phase.help, { letter: letterOf(placeOf(state)) }).split('{hint}')
  const word = hint('separatrix', phase.separatrix, hints.separatrix, session.hint === 'separatrix', (open) =>
    store.setSession({ hint: open ? 'separatrix' : null }),
  )
  return html`<section class="compare orbits" aria-labelledby="orbits-title"><div class="head"><h2 id="orbits-title">${phase.orbits}</h2></div>
    <div class="caption"><span>${phase.start}</span><span>${phase.period}</span></div>
    <div class="rows" role="radiogroup" aria-labelledby="orbits-title">${motions.map((motion, place) => row(page, motion, all[place] as Start, place, all.length))}</div>
    <div class="foot">${addMenu(page)}</div>
    <p class="soft small orbits-help">${before}${word}${after}</p>
  </section>`
}
