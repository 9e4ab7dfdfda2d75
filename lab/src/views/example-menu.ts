// A menu of pictures to begin with. Each replaces a part of the state, or all of it; one line undoes it.

import { html, type TemplateResult } from 'lit-html'
import { type MenuItem, menu } from '../controls/parts'
import { icon } from '../draw/icons'
import { isRefused } from '../embedding'
import { plain } from '../language/rich'
import type { State } from '../state'
import type { Page } from './page'

/** What one example is called, and what it sets; null where it cannot stand here. */
export interface Example extends Pick<MenuItem, 'text' | 'note'> {
  readonly state: Partial<State> | null
}

interface ExampleMenu {
  readonly key: string
  readonly name: string
  readonly examples: readonly Example[]
  readonly className?: string
  readonly up?: boolean
}

export function exampleMenu(page: Page, { key, name, examples, ...where }: ExampleMenu): TemplateResult {
  const { store, session, words } = page
  return menu({
    key,
    label: html`${name}${icon('down')}`,
    name,
    open: session.menu === key,
    toggle: (open) => store.setSession({ menu: open ? key : null }),
    ...where,
    items: examples.map(({ state, ...said }) => ({
      ...said,
      disabled: state === null || isRefused(page.state, state),
      act: () => {
        const text = words.fill(words.say.shell.replaced, { name: plain(said.text) })
        store.replace({ ...store.moment, t: 0, ...state }, { key: 'example', text })
      },
    })),
  })
}
