// Damped and driven pendulums to begin with. Each replaces pendulum, start and what acts on it; one line undoes it.

import type { TemplateResult } from 'lit-html'
import type { FrictionSetup } from '../model/friction'
import { radians } from '../number'
import type { State } from '../state'
import { exampleMenu } from './example-menu'
import type { Live } from './page'

type FrictionPreset = FrictionSetup & Pick<State, 'until'>

const NOTHING: FrictionPreset = {
  theta0: 0,
  velocity0: 0,
  length: 1,
  gravity: 9.81,
  linear: 0,
  quadratic: 0,
  dry: 0,
  torque: 0,
  drive: 0,
  driveFrequency: 2,
  until: 30,
}

/** ω₀ = 1/s, Q = ω₀/2γ = 2, driven at 2/3: Baker & Gollub, Chaotic Dynamics, chapter 3. */
const driven = (drive: number): FrictionPreset => {
  return { ...NOTHING, length: 9.81, linear: 0.25, drive, driveFrequency: 2 / 3, until: 100 }
}

export const FRICTION_PRESETS = {
  weak: { ...NOTHING, theta0: radians(60), linear: 0.03, until: 60 },
  dry: { ...NOTHING, theta0: radians(40), dry: 0.3 },
  quadratic: { ...NOTHING, theta0: radians(170), quadratic: 0.4 },
  over: { ...NOTHING, velocity0: 12, linear: 0.1, quadratic: 0.03 },
  one: driven(0.9),
  two: driven(1.07),
  chaos: driven(1.5),
  josephson: { ...NOTHING, length: 9.81, linear: 0.25, torque: 1.2, until: 60 },
} as const satisfies Record<string, FrictionPreset>

export function frictionPresets(page: Live): TemplateResult {
  const { damped } = page.words.say
  const names = Object.keys(FRICTION_PRESETS) as (keyof typeof FRICTION_PRESETS)[]
  const examples = names.map((name) => ({ text: damped.presets[name], state: FRICTION_PRESETS[name] }))
  return exampleMenu(page, { key: 'frictions', name: damped.examples, examples })
}
