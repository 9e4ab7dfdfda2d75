// The orbits of the portrait: one list with letters, of which the chosen one is the motion of the page.

import { LETTERS, MOST_ORBITS, type Start, type State } from './state'

type Chosen = Pick<State, 'theta0' | 'velocity0' | 'orbits' | 'orbit'>

/** Place of the chosen orbit among all. */
export function placeOf({ orbit, orbits }: Chosen): number {
  return Math.min(orbit, orbits.length)
}

/** All orbits in the order of their letters. */
export function allOrbits(state: Chosen): readonly Start[] {
  const { theta0, velocity0, orbits } = state
  const place = placeOf(state)
  return [...orbits.slice(0, place), { theta0, velocity0 }, ...orbits.slice(place)]
}

export function letterOf(place: number): string {
  return LETTERS[place] ?? ''
}

function chosen(all: readonly Start[], place: number): Chosen {
  const start = all[place] as Start
  return {
    theta0: start.theta0,
    velocity0: start.velocity0,
    orbits: all.filter((_, i) => i !== place),
    orbit: place,
  }
}

/** The orbit of a letter becomes the motion of the page; letters stay. */
export function choose(state: Chosen, place: number): Chosen {
  return chosen(allOrbits(state), place)
}

/** One more orbit behind the others, chosen; the same state if there are as many as there may be. */
export function withOrbit(state: Chosen, start: Start): Chosen {
  const all = allOrbits(state)
  return all.length >= MOST_ORBITS ? chosen(all, placeOf(state)) : chosen([...all, start], all.length)
}

/** Without the orbit of a letter; the letters behind it move up. The last one stays. */
export function withoutOrbit(state: Chosen, place: number): Chosen {
  const all = allOrbits(state)
  const at = placeOf(state)
  if (all.length === 1) return chosen(all, 0)
  const rest = all.filter((_, i) => i !== place)
  return chosen(rest, Math.min(place < at ? at - 1 : at, rest.length - 1))
}
