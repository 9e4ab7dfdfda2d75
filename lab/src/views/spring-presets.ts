// Springs to begin with, one for each kind of motion. Each replaces the spring and its start; one line undoes it.

import type { TemplateResult } from 'lit-html'
import { companionOf } from '../model/spring'
import { inRange, type State } from '../state'
import { type Example, exampleMenu } from './example-menu'
import type { Live } from './page'

type SpringPreset = Pick<State, 'spring' | 'p' | 'r' | 'q' | 'c' | 's' | 'u0' | 'springVelocity0'>

const duffing = (p: number, q: number, u0: number, springVelocity0 = 0): SpringPreset => {
  return { spring: 'duffing', p, r: 0, q, c: 0, s: 0, u0, springVelocity0 }
}
const even = (p: number, r: number, q: number, c: number, u0: number): SpringPreset => {
  return { ...duffing(p, q, u0), spring: 'helmholtz-duffing', r, c }
}
const quintic = (p: number, q: number, s: number, u0: number): SpringPreset => {
  return { ...duffing(p, q, u0), spring: 'cubic-quintic', s }
}

/** Those on a separatrix are on it exactly: their energies are sums of few bits. */
export const SPRING_PRESETS = {
  hardening: duffing(1, 1, 1.5),
  softening: duffing(1, -0.5, 1.2),
  escape: duffing(1, -0.5, 1.6),
  saddles: duffing(1, -0.5, 0, 1),
  inside: duffing(-1, 0.5, 1.9),
  on: duffing(-1, 0.5, 2),
  outside: duffing(-1, 0.5, 2.1),
  beam: even(1, 0.5, 0.2, 0, 1),
  tilted: even(-1, 0, 1, 0.125, -1.25),
  helmholtz: even(1, -1, 0, 0, -0.5),
  bistable: quintic(1, -4, 3, 0.5),
  quintic: quintic(1, 1, -1, 1.3),
} as const satisfies Record<string, SpringPreset>

/** That of the pendulum in the Lab, if it is a spring that can stand here. */
function companion({ theta0, velocity0, length, gravity }: State): SpringPreset | null {
  const found = companionOf(theta0, velocity0, length, gravity)
  if (!found || !(['p', 'q', 'u0', 'springVelocity0'] as const).every((name) => inRange(name, found[name]))) return null
  const { p, q, u0, springVelocity0 } = found
  return duffing(p, q, u0, springVelocity0)
}

export function springPresets(page: Live): TemplateResult {
  const { state, words } = page
  const { spring } = words.say
  const names = Object.keys(SPRING_PRESETS) as (keyof typeof SPRING_PRESETS)[]
  const examples: Example[] = names.map((name) => ({ text: spring.presets[name], state: SPRING_PRESETS[name] }))
  const note = words.formula(spring.companionNote)
  examples.push({ text: spring.presets.companion, note, state: companion(state) })
  return exampleMenu(page, { key: 'springs', name: spring.examples, className: 'right', examples })
}
