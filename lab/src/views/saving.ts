// The menus "Save": their buttons stand with the page; what is in them is a part of its own (save-menus.ts), which comes when the page works.

import type { TemplateResult } from 'lit-html'
import { type MenuItem, menu } from '../controls/parts'
import { icon } from '../draw/icons'
import type { Ghost } from '../draw/pendulum'
import type { ChartSpec } from './chart-spec'
import type { Live, Page } from './page'

/** What the part gives. */
interface Menus {
  readonly chartItems: (page: Page, spec: ChartSpec) => readonly MenuItem[]
  readonly pendulumItems: (page: Live, ghosts: readonly Ghost[]) => readonly MenuItem[]
}

let menus: Menus | null = null
let failed = false

/** The part has come; null where it did not. */
export function fillMenus(came: Menus | null): void {
  menus = came
  failed = came === null
}

interface SaveSpec {
  readonly key: string
  /** Of the picture, in words. */
  readonly name: string
  readonly items: (menus: Menus) => readonly MenuItem[]
  readonly className?: string
}

export function saveMenu(
  { words, session, store }: Page,
  { key, name, items, className = '' }: SaveSpec,
): TemplateResult {
  const { save, loadingView, failedView } = words.say.plots
  const menuKey = `save-${key}`
  const open = session.menu === menuKey
  const waiting = [{ text: failed ? failedView : loadingView, disabled: true, act: () => {} }]
  return menu({
    key: menuKey,
    label: icon('save'),
    name: words.fill(save, { plot: name }),
    open,
    toggle: (isOpen) => store.setSession({ menu: isOpen ? menuKey : null }),
    items: !open ? [] : menus ? items(menus) : waiting,
    className: `save right ${className}`,
  })
}
