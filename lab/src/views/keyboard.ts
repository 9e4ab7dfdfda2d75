// The keys of the page. Single letters work only while no field has the focus, and can be switched off.

import { shownViews } from '../embedding'
import { toggleTable } from './chart'
import { openDialog } from './dialogs'
import type { Page } from './page'
import { stepFrame, togglePlay } from './player'
import type { View } from './shell'

function typing(target: EventTarget | null): boolean {
  return target instanceof HTMLElement && target.matches('input:not([type=checkbox]), textarea, select')
}

/** The chart that has the focus, or the first of the view. */
function chartOf(): HTMLElement | null {
  const around = document.activeElement?.closest<HTMLElement>('[data-chart]')
  return around ?? document.querySelector<HTMLElement>('[data-chart]')
}

export function onKey(event: KeyboardEvent, page: Page, views: readonly View[]): void {
  const { store, session } = page
  if (event.defaultPrevented || event.ctrlKey || event.metaKey || event.altKey || session.dialog !== null) return
  const { target, key } = event
  if (key === 'Escape') {
    store.setSession({ hint: null, menu: null, drafts: {} })
    return
  }
  if (typing(target) || !session.singleKeys) return
  const act = () => {
    switch (key) {
      case ' ':
        // A focused button or box keeps its own space bar.
        if (target instanceof HTMLElement && target.matches('button, a, input, summary')) return false
        togglePlay(page)
        return true
      case '.':
        stepFrame(page, 1)
        return true
      case ',':
        stepFrame(page, -1)
        return true
      case 'r':
      case 'R':
        store.seek(0)
        store.play()
        return true
      case 'n':
      case 'N':
      case 'p':
      case 'P': {
        // The next and the previous step, where a view has steps.
        const button = document.querySelector<HTMLElement>(`[data-step=${key.toLowerCase() === 'n' ? 'next' : 'back'}]`)
        button?.click()
        return button !== null
      }
      case 's':
      case 'S':
      case '?':
      case '/':
        // What stands in another page has no bar, and what is in the bar has no key.
        if (page.state.embed) return false
        openDialog(page, /s/i.test(key) ? 'share' : 'keys')
        return true
      case 't':
      case 'T': {
        const chart = chartOf()?.dataset.chart
        if (chart) toggleTable(page, chart)
        return chart !== undefined
      }
      case 'l':
      case 'L': {
        const button = chartOf()?.querySelector<HTMLElement>('[data-tool=sound]')
        button?.click()
        return button !== null
      }
      default: {
        const shown = shownViews(page.state)
        const view = views.filter(({ name }) => shown.includes(name))[Number(key) - 1]
        if (!/^[1-9]$/.test(key) || !view) return false
        store.set({ view: view.name })
        return true
      }
    }
  }
  if (act()) event.preventDefault()
}
