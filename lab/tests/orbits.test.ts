// The list of orbits: letters stay when another is chosen, the chosen one is the motion of the page.

import { describe, expect, it } from 'vitest'
import { allOrbits, choose, placeOf, withOrbit, withoutOrbit } from '../src/orbits'
import { DEFAULTS, MOST_ORBITS } from '../src/state'

const [a, b, c] = [
  { theta0: 1, velocity0: 0 },
  { theta0: 2, velocity0: 0.5 },
  { theta0: -0.5, velocity0: 7 },
]
const state = { ...DEFAULTS, ...a, orbits: [b, c], orbit: 0 }

describe('orbits', () => {
  it('keep their letters whichever is chosen', () => {
    for (const place of [0, 1, 2, 1, 0]) {
      const next = choose(state, place)
      expect(allOrbits(next)).toEqual([a, b, c])
      expect({ theta0: next.theta0, velocity0: next.velocity0 }).toEqual([a, b, c][place])
      expect(allOrbits(choose(next, 2))).toEqual([a, b, c])
    }
  })

  it('are added behind the others and chosen, up to as many as there may be', () => {
    const d = { theta0: 3, velocity0: 1 }
    let next = withOrbit(state, d)
    expect(allOrbits(next)).toEqual([a, b, c, d])
    expect(next.orbit).toBe(3)
    for (let i = 0; i < 10; i++) next = withOrbit(next, d)
    expect(allOrbits(next).length).toBe(MOST_ORBITS)
  })

  it('are removed, and another is chosen if it was the chosen one', () => {
    expect(allOrbits(withoutOrbit(state, 1))).toEqual([a, c])
    const second = choose(state, 1)
    expect(allOrbits(withoutOrbit(second, 0))).toEqual([b, c])
    expect(withoutOrbit(second, 0)).toMatchObject({ ...b, orbit: 0 })
    expect(withoutOrbit(second, 1)).toMatchObject({ ...c, orbit: 1 })
    expect(withoutOrbit(choose(state, 2), 2)).toMatchObject({ ...b, orbit: 1 })
    const one = { ...state, orbits: [] }
    expect(allOrbits(withoutOrbit(one, 0))).toEqual([a])
  })

  it('of a link with a letter too many is the last', () => expect(placeOf({ ...state, orbit: 5 })).toBe(2))
})
