// What the charts of a spring are drawn from: the motion, its axes, and where it is at the time shown.

import type { Words } from '../language'
import { remember } from '../memory'
import { SpringOrbit } from '../model/spring'
import { forceOf } from '../model/spring-force'
import type { State } from '../state'
import { within } from '../study'
import type { Live } from './page'
import { type SpringAxes, springAxes, springSpan } from './spring-axes'

export interface SpringView {
  /** The page at the time within what is shown: at the end it begins again. */
  readonly page: Live
  readonly orbit: SpringOrbit
  readonly axes: SpringAxes
  /** NaN after an escape. */
  readonly now: { readonly u: number; readonly velocity: number }
}

const orbitBy = remember(
  (kind: State['spring'], p: number, r: number, q: number, c: number, s: number, u0: number, velocity0: number) =>
    new SpringOrbit(forceOf(kind, { p, r, q, c, s }), u0, velocity0),
)

export function orbitOf({ spring, p, r, q, c, s, u0, springVelocity0 }: State): SpringOrbit {
  return orbitBy(spring, p, r, q, c, s, u0, springVelocity0)
}

const usualAxes = remember(springAxes)
let last: SpringAxes | null = null

/** While a hand moves the start the axes stand still, so that the start stays under the hand. */
function axesNow({ session }: Live, orbit: SpringOrbit): SpringAxes {
  last = session.held === 'spring-start' && last ? { ...last, span: springSpan(orbit) } : usualAxes(orbit)
  return last
}

export function springView(page: Live): SpringView {
  const orbit = orbitOf(page.state)
  const axes = axesNow(page, orbit)
  const t = within(page.t, axes.span)
  return { page: { ...page, t }, orbit, axes, now: orbit.at(t) }
}

/** Four digits at most, and no zeros behind them. */
export function shortNumber(words: Words, value: number): string {
  return words.given(Number(value.toPrecision(4)))
}
