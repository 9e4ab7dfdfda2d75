// How long a pendulum with friction and torque is computed at once: so long that the core needs some milliseconds for it.
//
// The steps of the integration are counted by the radians that its fastest term goes through. How fast the pendulum will be is bounded by
// its energy: gravity gives it 2ω₀ at most, a torque F the velocity F t, or that at which friction takes as much as the torque gives.

import type { FrictionAndTorque } from '../state'
import type { Setup } from './motion'

type Acting = Pick<Setup, 'length' | 'gravity'> & FrictionAndTorque

/** Most radians of a piece by this bound; a piece has a third of it or less. */
const RADIANS = 6000

/** What it goes through at most in a time. */
function radiansIn(setup: Acting, velocity0: number, time: number): number {
  const { length, gravity, linear, quadratic, torque, drive, driveFrequency } = setup
  const omega0 = Math.sqrt(gravity / length)
  const pull = Math.abs(torque) + drive
  const start = Math.abs(velocity0)
  // Division by 0 is infinite: without friction there is no such velocity.
  const balance = pull === 0 ? 0 : Math.min(pull / (2 * linear), Math.sqrt(pull / quadratic))
  const fastest = 2 * omega0 + Math.min(start + pull * time, Math.max(start, balance))
  return time * (fastest + omega0 + 2 * linear + (drive === 0 ? 0 : driveFrequency))
}

/** As much of a time as is a piece, from a velocity on: all of it, or its half, quarter, eighth … */
export function pieceOf(setup: Acting, velocity0: number, time: number): number {
  const { linear, quadratic, dry, torque, drive } = setup
  // The exact motion is computed at any time at once.
  if (linear === 0 && quadratic === 0 && dry === 0 && torque === 0 && drive === 0) return time
  let piece = time
  while (radiansIn(setup, velocity0, piece) > RADIANS) piece /= 2
  return piece
}
