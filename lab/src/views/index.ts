// The views that there are, in the order of their tabs. A view that does not exist yet has no tab.

import { html, nothing, type TemplateResult } from 'lit-html'
import { retried } from '../retry'
import type { ViewName } from '../state'
import { motionSentence } from './bench'
import { dialog } from './dialogs'
import { lab, labAlarm } from './lab'
import type { Live, Page } from './page'
import { fillMenus } from './saving'
import type { View } from './shell'

type Later = typeof import('./later')
let later: Later | null = null
let failed = false

/** A view that is a part of its own, with its words. */
export interface Part {
  readonly sentence: View['sentence']
  readonly body: View['body']
}

/** The parts by their views, in the order in which they are asked for once the page works. */
const PARTS = {
  derivation: async () => {
    const part = await import('./derivation')
    await part.formulaFont()
    return part
  },
  springs: () => import('./springs'),
  friction: () => import('./friction'),
  data: () => import('./data'),
  handouts: () => import('./handouts'),
} satisfies Partial<Record<ViewName, () => Promise<{ readonly part: Part }>>>
type PartName = keyof typeof PARTS
const parts: Partial<Record<PartName, Part>> = {}

/** The second module of the core did not come: its views say so. */
export function secondFailed(): void {
  failed = true
}

/** Views that stand by themselves: without the part that comes after the Lab, and without the second module of the core. */
const ALONE: readonly ViewName[] = ['springs', 'friction', 'data']
/** One more that has no need of the module. */
export const needsSecond = (shown: readonly ViewName[]): boolean =>
  shown.some((name) => !ALONE.includes(name) && name !== 'phase')

/** Loads the first views after the Lab; begun with the page, so that no request is left for a tab. Never rejects: the Lab works alone. */
export async function loadViews(shown: readonly ViewName[]): Promise<void> {
  if (shown.every((name) => ALONE.includes(name))) return
  try {
    later = await retried(() => import('./later'))
  } catch {
    failed = true
  }
}

export const viewsLoaded = (): boolean => later !== null

/** Loads those of the other views that are shown, that of the link first: what it is has come before it is drawn. Rejects where one did not come. */
export async function loadParts(shown: readonly ViewName[], first: ViewName, came: () => void): Promise<void> {
  const names = (Object.keys(PARTS) as PartName[]).filter((name) => shown.includes(name))
  names.sort((a, b) => Number(b === first) - Number(a === first))
  for (const name of names) {
    parts[name] = (await retried(PARTS[name])).part
    came()
  }
  await loadSaving()
  came()
}

let saving: typeof import('./save-menus') | null = null

/** Loads what is in the menus "Save", and with it all that makes a file. Never rejects: the page works without. */
async function loadSaving(): Promise<void> {
  try {
    saving = await retried(() => import('./save-menus'))
    await saving.prepared()
    fillMenus(saving)
  } catch {
    fillMenus(null)
  }
}

function part(name: PartName): View {
  return {
    name,
    sentence: (page) => parts[name]?.sentence(page) ?? page.words.say.sentence.waiting,
    body: (page) => parts[name]?.body(page) ?? waiting(page),
  }
}

function waiting(page: Live): TemplateResult {
  const { loadingView, failedView } = page.words.say.plots
  return html`<p class="waiting-line" role="status">${failed ? failedView : loadingView}</p>`
}

function view(name: 'phase' | 'period' | 'functions'): View {
  const shown = (page: Live) => (name === 'phase' || page.model.complete ? later : null)
  return {
    name,
    sentence: (page) => shown(page)?.[`${name}Sentence`](page) ?? page.words.say.sentence.waiting,
    body: (page) => shown(page)?.[name](page) ?? waiting(page),
  }
}

export const VIEWS: readonly View[] = [
  { name: 'lab', sentence: motionSentence, alarm: labAlarm, body: lab },
  view('phase'),
  view('period'),
  view('functions'),
  part('derivation'),
  part('springs'),
  part('friction'),
  part('data'),
  part('handouts'),
]

/** The dialog that is open; where its part did not come it says so. */
export function dialogs(page: Page): TemplateResult | typeof nothing {
  if (page.session.dialog === 'film') return saving?.filmDialog(page) ?? nothing
  if (later) return later.dialogs(page, VIEWS.length)
  if (!failed || page.session.dialog === null) return nothing
  const { shell, plots, compare } = page.words.say
  const title = page.session.dialog === 'convergence' ? compare.convergence : shell[page.session.dialog]
  return dialog(page, 'failed', title, html`<p>${plots.failedView}</p>`)
}
