// The left column of a view: the drawn pendulum, the values one can set, and the facts of the motion.

import { html, nothing, svg, type TemplateResult } from 'lit-html'
import { hint } from '../controls/parts'
import { afterKey, dragging } from '../controls/slide'
import { angleAt, BOX, type Ghost, type PendulumSpec, pendulum, spot } from '../draw/pendulum'
import { isLocked } from '../embedding'
import { rich } from '../language/rich'
import { degrees, radians } from '../number'
import type { Live } from './page'
import { saveMenu } from './saving'
import { fieldFault, stateValue } from './values'

/** Shows a release angle from the beginning, at rest in time: what a hand on the bob does. */
function hold({ store }: Live, angle: number): void {
  store.clock.pause()
  store.draft('theta0', null)
  store.set({ theta0: angle, t: 0 })
}

function bob(page: Live, angle: number): TemplateResult {
  const { store, state, words } = page
  const release = degrees(state.theta0)
  const at = spot(angle)
  const before = state.theta0
  const drag = dragging({
    at: (x, y, element) => {
      const drawing = (element as SVGElement).ownerSVGElement
      if (!drawing) return
      const box = drawing.getBoundingClientRect()
      const scale = BOX.width / box.width
      const seen = angleAt((x - box.left) * scale, (y - box.top) * scale)
      // Whole degrees; the top is as hard to find as it is, and typed for sure.
      hold(page, radians(Math.round(degrees(seen))))
    },
    begin: () => store.setSession({ held: 'bob' }),
    end: (dropped) => {
      store.setSession({ held: null })
      if (dropped) hold(page, before)
      else if (!store.session.reduced && !matchMedia('(prefers-reduced-motion: reduce)').matches) store.play()
    },
  })
  const keys = (event: KeyboardEvent) => {
    const next = afterKey(event, { value: degrees(store.state.theta0), least: -180, most: 180, step: 1 })
    if (next === null) return
    event.preventDefault()
    event.stopPropagation()
    hold(page, radians(next))
  }
  const locked = isLocked(state, 'theta0')
  return html`<svg class="bob-drawing" viewBox="0 0 ${BOX.width} ${BOX.height}"><g class="bob-handle" role="slider" tabindex=${locked ? -1 : 0} aria-disabled=${locked ? 'true' : nothing} aria-label=${words.say.drawing.bob} aria-valuemin="-180" aria-valuemax="180"
    aria-valuenow=${release} aria-valuetext=${words.fill(words.say.drawing.bobText, { angle: words.typed(release) })} data-exact=${String(angle)} transform="translate(${at.x.toFixed(2)} ${at.y.toFixed(2)})"
    @pointerdown=${locked ? nothing : drag} @keydown=${locked ? nothing : keys}>${locked ? svg`<title>${words.say.embedding.locked}</title>` : nothing}<circle class="reach-target" r="16"/><circle class="bob" r="10"/></g></svg>`
}

/** A part of the energy; that over the energy at the top has g in it. */
const percentText = ({ state, words }: Live, part: number) =>
  state.hide ? '–' : words.with(words.fixed(100 * part, 0), '%')

/** What is drawn of the pendulum at an angle with a velocity; a film draws the same. */
export function pendulumAt(page: Live, angle: number, velocity: number, ghosts: readonly Ghost[]): PendulumSpec {
  const { motion, state, words } = page
  const { kinetic, potential } = motion.energyAt(angle, velocity)
  const say = words.say.drawing
  return {
    angle,
    release: state.theta0,
    reach: motion.regime === 'libration' ? motion.thetaMax : motion.regime === 'rest' ? 0 : Math.PI,
    kinetic,
    potential,
    ghosts,
    words: { ...say, more: words.fill(say.more, { percent: percentText(page, kinetic + potential) }) },
    degree: (value: number) => `${words.typed(value)}°`,
  }
}

/** The pendulum at the time shown, with the bobs of other curves. */
function drawnPendulum(page: Live, ghosts: readonly Ghost[]): TemplateResult {
  const { motion, t, words } = page
  const angle = motion.theta(t)
  const velocity = motion.velocity(t)
  const spec = pendulumAt(page, angle, velocity, ghosts)
  const say = words.say.drawing
  const speed = words.with(words.fixed(velocity, 2), words.say.units['rad/s'])
  const caption = words.fill(say.caption, {
    t: words.with(words.fixed(t, 2), words.say.units.s),
    angle: words.angle(angle, 1),
    velocity: speed,
    kinetic: percentText(page, spec.kinetic),
    potential: percentText(page, spec.potential),
  })
  return html`<figure class="drawing" aria-label=${say.name}>
    <div class="drawing-box"><svg viewBox="0 0 ${BOX.width} ${BOX.height}" aria-hidden="true">${pendulum(spec)}</svg>${bob(page, angle)}</div>
    <div class="reading reading-top" aria-hidden="true"><i>θ</i> = <b class="number">${words.angle(angle, 1)}</b></div>
    <div class="reading reading-bottom" aria-hidden="true"><i class="dotted">θ</i> = <b class="number">${speed}</b></div>
    ${saveMenu(page, { key: 'pendulum', name: say.name, items: (menus) => menus.pendulumItems(page, ghosts), className: 'in-corner' })}
    <figcaption class="unseen">${page.store.clock.playing ? nothing : caption}</figcaption>
  </figure>`
}

export function facts(page: Live): TemplateResult | typeof nothing {
  const { motion, words, session, store, state } = page
  if (state.hide) return nothing
  const say = words.say.facts
  const { period, smallPeriod, regime } = motion
  const seconds = (value: number, digits = 4) =>
    Number.isFinite(value) ? words.with(words.fixed(value, digits), words.say.units.s) : say.infinite
  const rest = regime === 'rest'
  const rotates = regime === 'rotation'
  const word = hint(
    'parameter',
    say.parameter,
    words.formula(words.say.hints.parameter),
    session.hint === 'parameter',
    (open) => store.setSession({ hint: open ? 'parameter' : null }),
  )
  return html`<dl class="facts">
    <dt class="big">${rich(rotates ? say.turn : say.period)}</dt><dd class="big" id="period-value">${rest ? say.none : seconds(period)}</dd>
    <dt>${rich(say.smallPeriod)}</dt><dd>${seconds(smallPeriod)}</dd>
    <dt>${rich(say.ratio)}</dt><dd>${rest || rotates ? say.none : Number.isFinite(period) ? words.fixed(period / smallPeriod, 4) : '∞'}</dd>
    <dt>${word} ${rich(words.formula(state.velocity0 === 0 ? say.parameterIs : say.energyIs))}</dt><dd>${words.fixed(motion.energyRatio, 4)}</dd>
  </dl>`
}

const VALUES = ['theta0', 'velocity0', 'length', 'gravity'] as const

/** The column of Lab and Phase portrait. What is wrong with a value takes its room from the drawing. */
export function bench(page: Live, ghosts: readonly Ghost[]): TemplateResult {
  const faulty = VALUES.some((name) => fieldFault(page, name, page.session.drafts[name]) !== null)
  return html`<div class="column left ${faulty ? 'faulty' : ''}">${drawnPendulum(page, ghosts)}
    <div class="first-values">${stateValue(page, 'theta0')}</div>
    <div class="more-values">${stateValue(page, 'velocity0')}${stateValue(page, 'length')}${stateValue(page, 'gravity')}</div>
    ${facts(page)}</div>`
}

/** The first sentence of the page, by kind of motion. */
export function motionSentence({ motion, state, words }: Live): string {
  const say = words.say.sentence
  if (state.hide) return words.say.embedding.sentence
  const { regime, period, smallPeriod, thetaMax } = motion
  const angle = words.shortAngle(state.theta0)
  const velocity = words.with(words.given(Number(state.velocity0.toPrecision(5))), words.say.units['rad/s'])
  const time = words.with(words.fixed(period, 3), words.say.units.s)
  if (regime === 'rest') return motion.balanced ? say.balance : words.fill(say.rest, { angle })
  if (regime === 'separatrix') return words.fill(say.separatrix, { angle, velocity })
  if (regime === 'rotation') return words.fill(say.rotates, { angle, velocity, period: time })
  const excess = 100 * (period / smallPeriod - 1)
  const longer = words.with(excess >= 1 ? words.fixed(excess, 1) : words.significant(excess, 2), '%')
  if (state.velocity0 === 0) return words.fill(say.swings, { angle, period: time, longer })
  return words.fill(say.swingsThrown, { angle, velocity, top: words.angle(thetaMax, 1), period: time, longer })
}
