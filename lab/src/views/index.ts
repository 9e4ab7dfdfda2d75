// The views that there are, in the order of their tabs. A view that does not exist yet has no tab.

import { html, nothing, type TemplateResult } from 'lit-html'
import { retried } from '../retry'
import { motionSentence } from './bench'
import { dialog } from './dialogs'
import { lab, labAlarm } from './lab'
import type { Live, Page } from './page'
import type { View } from './shell'

type Later = typeof import('./later')
let later: Later | null = null
let failed = false

/** The second module of the core did not come: its views say so. */
export function secondFailed(): void {
  failed = true
}

/** Loads all views but the Lab; begun with the page, so that no request is left for a tab. Never rejects: the Lab works alone. */
export async function loadViews(): Promise<void> {
  try {
    later = await retried(() => import('./later'))
  } catch {
    failed = true
  }
}

export const viewsLoaded = (): boolean => later !== null

function view(name: 'phase' | 'period' | 'functions' | 'data'): View {
  const alone = name === 'phase' || name === 'data'
  const shown = (page: Live) => (alone || page.model.complete ? later : null)
  return {
    name,
    sentence: (page) => shown(page)?.[`${name}Sentence`](page) ?? page.words.say.sentence.waiting,
    body: (page) => {
      const { loadingView, failedView } = page.words.say.plots
      return (
        shown(page)?.[name](page) ??
        html`<p class="waiting-line" role="status">${failed ? failedView : loadingView}</p>`
      )
    },
  }
}

export const VIEWS: readonly View[] = [
  { name: 'lab', sentence: motionSentence, alarm: labAlarm, body: lab },
  view('phase'),
  view('period'),
  view('functions'),
  view('data'),
]

/** The dialog that is open; where its part did not come it says so. */
export function dialogs(page: Page): TemplateResult | typeof nothing {
  if (later) return later.dialogs(page, VIEWS.length)
  if (!failed || page.session.dialog === null) return nothing
  const { shell, plots, compare } = page.words.say
  const title = page.session.dialog === 'convergence' ? compare.convergence : shell[page.session.dialog]
  return dialog(page, 'failed', title, html`<p>${plots.failedView}</p>`)
}
