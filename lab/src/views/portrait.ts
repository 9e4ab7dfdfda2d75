// The small phase portrait of the Lab: level curves, separatrix, the orbit and where it is.

import { html, nothing, svg, type TemplateResult } from 'lit-html'
import { iconButton } from '../controls/parts'
import { measured, sizeOf } from '../controls/size'
import { dragging } from '../controls/slide'
import { pathOf } from '../draw/curve'
import { plot } from '../draw/plot'
import { linearScale, roundTicks, type Scale } from '../draw/scale'
import { isLocked, shownViews } from '../embedding'
import { plain, rich } from '../language/rich'
import { remember } from '../memory'
import type { Motion } from '../model'
import { DEGREES, radians } from '../number'
import type { Live } from './page'

const POINTS = 181

export interface Loop {
  readonly x: Float64Array
  readonly y: Float64Array
}

/** The angle within one turn. */
export function withinTurn(theta: number): number {
  const turned = theta - 2 * Math.PI * Math.round(theta / (2 * Math.PI))
  return turned
}

/** The curve of one energy: closed about the bottom, or from edge to edge, forwards and backwards. */
export function levelCurves(motion: Motion, energyRatio: number, thetaMax: number): Loop[] {
  // Close together at the turning angles, where the curve bends.
  const theta = Float64Array.from({ length: POINTS }, (_, i) => -thetaMax * Math.cos((Math.PI * i) / (POINTS - 1)))
  const up = motion.levelVelocity(theta, energyRatio)
  const down = up.map((velocity) => -velocity)
  const x = theta.map((angle) => angle * DEGREES)
  if (energyRatio < 1) {
    return [{ x: Float64Array.from([...x, ...x.toReversed()]), y: Float64Array.from([...up, ...down.toReversed()]) }]
  }
  return [
    { x, y: up },
    { x, y: down },
  ]
}

/** Faint curves: swings to these degrees, and motions of these energies that turn over. */
const SWINGS = [30, 60, 90, 120]
const OVER = [1.25, 1.7]

interface Background {
  readonly omega0: number
  readonly faint: readonly Loop[]
  readonly separatrix: readonly Loop[]
}
let last: Background | null = null

/** Of one pendulum, whatever its start. */
export function background(motion: Motion): Background {
  const { omega0 } = motion
  if (last?.omega0 === omega0) return last
  const swings = SWINGS.map((degrees) =>
    levelCurves(motion, motion.energyAt(degrees / DEGREES, 0).potential, degrees / DEGREES),
  )
  const over = OVER.map((energy) => levelCurves(motion, energy, Math.PI))
  last = { omega0, faint: [...swings, ...over].flat(), separatrix: levelCurves(motion, 1, Math.PI) }
  return last
}

/** What is drawn of the orbit itself: the separatrix is drawn already, rest is a point. */
const orbitOf = remember((motion: Motion): Loop[] => {
  if (motion.regime === 'libration') return levelCurves(motion, motion.energyRatio, motion.thetaMax)
  if (motion.regime !== 'rotation') return []
  const [forwards, backwards] = levelCurves(motion, motion.energyRatio, Math.PI)
  const one = motion.velocity(0) >= 0 ? forwards : backwards
  return one ? [one] : []
})

/** The velocity at the bottom on the level of an energy. */
function fastest(motion: Motion, energyRatio: number): number {
  return motion.levelVelocity(Float64Array.of(0), energyRatio)[0] || 1
}

/** Greatest velocity of the axis: room for the faint curves and for the orbit. */
function velocityReach(motion: Motion): number {
  return 1.02 * fastest(motion, Math.max(2, 1.1 * motion.energyRatio))
}

/** While a hand is on the portrait its axis stands still. */
let heldReach: number | null = null

/** Starts where the pointer is: whole degrees, twentieths of a radian per second. */
function starting(page: Live, width: number, height: number) {
  const { store } = page
  return dragging({
    begin: () => {
      heldReach = velocityReach(page.motion)
      store.setSession({ held: 'portrait' })
    },
    at: (x, y, element) => {
      const box = element.getBoundingClientRect()
      const reach = heldReach ?? velocityReach(page.motion)
      const degree = Math.round(linearScale([-180, 180], [0, width]).invert(x - box.left))
      const velocity = linearScale([-reach, reach], [height, 0]).invert(y - box.top)
      const theta0 = radians(Math.min(180, Math.max(-180, degree)))
      const velocity0 = Number((Math.round(Math.min(reach, Math.max(-reach, velocity)) * 20) / 20).toFixed(2))
      store.clock.pause()
      store.set({ theta0, velocity0, t: 0 })
    },
    end: () => {
      heldReach = null
      store.setSession({ held: null })
    },
  })
}

/** The tinted region of swings, faint level curves, and the separatrix. */
export function portraitGround(motion: Motion, sx: Scale, sy: Scale): TemplateResult {
  const { faint, separatrix } = background(motion)
  const path = (each: Loop) => pathOf(each, sx, sy)
  const [above, below] = separatrix
  const band =
    above && below
      ? `${path(above)}${path({ x: below.x.toReversed(), y: below.y.toReversed() }).replace('M', 'L')}Z`
      : ''
  return svg`<g transform="scale(0.1)"><path class="band" d=${band}/>
    ${faint.map((each) => svg`<path class="faint" d=${path(each)}/>`)}
    ${separatrix.map((each) => svg`<path class="separatrix" d=${path(each)}/>`)}</g>`
}

function draw(page: Live, width: number, height: number): TemplateResult {
  const { motion, words, t, rem, state } = page
  const { hide } = state
  // Where g is hidden the velocity is measured by its largest: the separatrix, or a number of rad/s at its height, would say ω₀.
  const unit = hide ? fastest(motion, motion.energyRatio) : 1
  const reach = hide ? 1.15 * unit : (heldReach ?? velocityReach(motion))
  const sx = linearScale([-180, 180], [0, width])
  const sy = linearScale([-reach, reach], [height, 0])
  const under = hide ? nothing : portraitGround(motion, sx, sy)
  const { portrait } = words.say
  const labels = [
    { x: width / 2, y: height / 2 + 0.3 * rem, text: portrait.swings },
    { x: width / 2, y: 0.9 * rem, text: portrait.turnsOver },
  ]
  const values = hide ? [-1, 0, 1] : roundTicks(-reach, reach, 3)
  const drawing = plot(
    {
      width,
      height,
      rem,
      sx,
      sy,
      xs: [-180, 0, 180].map((value) => ({ value, text: `${words.typed(value)}°` })),
      ys: values.map((value) => ({ value: value * unit, text: words.typed(value) })),
      xLabels: true,
      lines: orbitOf(motion).map((each) => ({ ...each, clothes: 'c-exact' })),
      labels: hide ? [] : labels,
      under,
    },
    [motion, words, reach],
  )
  const x = sx(withinTurn(motion.theta(t)) * DEGREES)
  const y = sy(motion.velocity(t))
  return html`${drawing}<b class="handle spot" style="left:${x.toFixed(1)}px;top:${y.toFixed(1)}px"></b>`
}

export function portraitChart(page: Live): TemplateResult {
  const { words, store, state } = page
  const { portrait } = words.say
  const size = sizeOf('portrait')
  const { hide } = state
  const locked = isLocked(state, 'theta0') || isLocked(state, 'velocity0')
  return html`<figure class="chart portrait" aria-label=${portrait.title}>
    <div class="head"><h2>${portrait.title} <span class="unit">${rich(hide ? "_θ'_/_θ'_{max}" : portrait.unit)}</span></h2>${shownViews(state).includes('phase') ? iconButton(portrait.open, 'open', () => store.set({ view: 'phase' })) : nothing}</div>
    <div class="plot with-x" style="--plot-height:12.5rem" ${measured('portrait')} title=${locked ? words.say.embedding.locked : nothing} @pointerdown=${size && !locked && !hide ? starting(page, size.width, size.height) : nothing}>${size && size.width > 0 ? draw(page, size.width, size.height) : ''}</div>
    <figcaption class="unseen">${plain(hide ? portrait.title : portrait.caption)}</figcaption>
  </figure>`
}
