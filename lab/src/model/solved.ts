// The exact motion as the command `libration solve` writes it: from t = 0, evenly spaced, with what the motion is.

import { approx, Pendulum } from 'libration'
import type { Setup } from './motion'

export interface Solved {
  /** Name, value and unit, in the order of the file. */
  readonly parameters: readonly (readonly [string, number | string, string])[]
  /** Name, unit and values. */
  readonly columns: readonly (readonly [string, string, Float64Array])[]
}

/** Evenly spaced instants as NumPy's `linspace` rounds them. */
export function instants(until: number, samples: number): Float64Array {
  const step = until / (samples - 1)
  const times = Float64Array.from({ length: samples }, (_, i) => i * step)
  times[samples - 1] = until
  return times
}

export function solved(setup: Setup, until: number, samples: number): Solved {
  const pendulum = new Pendulum(setup)
  const times = instants(until, samples)
  const { theta, velocity } = pendulum.motion(times)
  return {
    parameters: [
      ['theta0', setup.theta0, 'rad'],
      ['velocity0', setup.velocity0, 'rad/s'],
      ['length', setup.length, 'm'],
      ['gravity', setup.gravity, 'm/s^2'],
      ['omega0', pendulum.omega0, 'rad/s'],
      ['regime', pendulum.regime, ''],
      ['period', pendulum.period, 's'],
      ['theta_max', pendulum.thetaMax, 'rad'],
      ['energy', pendulum.energy, 'rad^2/s^2'],
      ['energy_ratio', pendulum.energyRatio, ''],
      ['energy_ratio_c', pendulum.energyRatioC, ''],
    ],
    columns: [
      ['t', 's', times],
      ['theta', 'rad', theta],
      ['velocity', 'rad/s', velocity],
      ['theta_linear', 'rad', approx.angle('linear').of(pendulum).theta(times)],
    ],
  }
}
