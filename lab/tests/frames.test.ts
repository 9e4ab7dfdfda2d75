// Story 1 without a browser: every frame of 600 s at 30, 60 and 144 frames a second shows the angle of the core at its true time.

import { Pendulum } from 'libration'
import { beforeAll, describe, expect, it } from 'vitest'
import { readLink } from '../src/link'
import { type Model, openModel } from '../src/model'
import { Store } from '../src/store'

const LINK = '#th0=150deg&L=1m&g=9.81&t=0s'
const SECONDS = 600
/** What the wall's clock says at the start, in ms. */
const BEGUN = 1234.5

let model: Model

beforeAll(async () => {
  model = await openModel()
})

/** Largest difference of the angle shown from the core's, in rad, over all frames; the wall's clock may run at another rate. */
function farthest(hertz: number, pace = 1): { frames: number; off: number } {
  let wall = BEGUN
  const store = new Store(readLink(LINK), () => wall)
  const { theta0, velocity0, length, gravity } = store.state
  const motion = model.motion({ theta0, velocity0, length, gravity })
  const frames = SECONDS * hertz
  const times = Float64Array.from({ length: frames }, (_, i) => (i + 1) / hertz)
  const truth = new Pendulum({ theta0, length, gravity }).theta(times)
  let off = 0
  store.play()
  times.forEach((t, i) => {
    wall = BEGUN + 1000 * t * pace
    // As views/bench.ts draws it.
    const miss = Math.abs(motion.theta(store.clock.t) - (truth[i] as number))
    // NaN stays.
    off = Math.max(off, miss)
  })
  return { frames, off }
}

describe('story 1: every frame of 600 s', () => {
  it.each([30, 60, 144])('at %i frames a second is the motion of the core', (hertz) => {
    const { frames, off } = farthest(hertz)
    expect(frames).toBe(600 * hertz)
    expect(off).toBeLessThan(1e-12)
  })

  it('is not with a clock that is a millionth too fast', () => {
    expect(farthest(30, 1 + 1e-6).off).toBeGreaterThan(1e-4)
  })
})
