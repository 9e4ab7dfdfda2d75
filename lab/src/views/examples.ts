// Pictures to begin with: figures of the three papers and the edges of the motion. Each replaces the state; one line undoes it.

import type { TemplateResult } from 'lit-html'
import { readLink } from '../link'
import { DEFAULTS, type State } from '../state'
import { exampleMenu } from './example-menu'
import type { Page } from './page'

/** As links, so that an example is nothing that a reader could not make. */
export const EXAMPLES = {
  lima2: 'th0=60deg&L=1m&g=9.8&curves=harmonic,fourier:1,fourier:2&span=T&error=linear',
  lima3: 'th0=90deg&L=1m&g=9.8&curves=harmonic,fourier:2&span=T&error=linear',
  lima4: 'th0=157.5deg&L=1m&g=9.8&curves=harmonic,fourier:4&span=T&error=linear',
  horsley: 'th0=3rad&L=1m&g=9.8&curves=linear,rk45,rk4:0.025&span=12s',
  // Salas' m = 1.419: 0.6 rad with 3 rad/s and ω0 = 1.3/s turns over, and is at 5.1116 rad at 2.1 s. His data are not in the text.
  salas: 'th0=0.6rad&w0=3&L=1m&g=1.69&curves=rk4:0.025,small-m&span=8s&t=2.1s',
  over: 'th0=0deg&w0=7.5&L=1m&g=9.81&curves=linear,rk45&span=8s',
  balance: 'th0=180deg&L=1m&g=9.81&curves=linear,rk4:0.025&span=8s',
} as const

export type ExampleName = keyof typeof EXAMPLES

/** The state of an example as it stands in this page; language and theme stay the reader's. */
export function exampleState(name: ExampleName, { language, theme, embed, lock, show, hide }: State): State {
  return { ...DEFAULTS, ...readLink(EXAMPLES[name]).state, language, theme, embed, lock, show, hide }
}

export function examples(page: Page): TemplateResult {
  const { state, words } = page
  const names = Object.keys(EXAMPLES) as ExampleName[]
  return exampleMenu(page, {
    key: 'examples',
    name: words.say.compare.examples,
    className: 'right',
    up: state.curves.length > 4,
    examples: names.map((name) => ({ text: words.say.examples[name], state: exampleState(name, state) })),
  })
}
