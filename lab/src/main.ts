// Where the page begins: the state from the link, the frame at once, the exact core as soon as it is there.

import './style/fonts.css'
import './style/tokens.css'
import './style/base.css'
import './style/layout.css'
import './style/charts.css'
import './style/controls.css'
import './style/functions.css'
import './style/period.css'
import './style/phase.css'
import { App } from './app'
import { shownViews } from './embedding'
import { readLink } from './link'
import { completedModel, openModel } from './model'
import { retried } from './retry'
import { keepForLater } from './second-visit'
import { SECOND, SOURCES } from './sources'
import type { ViewName } from './state'
import { dialogs, loadParts, loadViews, needsSecond, secondFailed, VIEWS, viewsLoaded } from './views'

/** The views whose parts were asked for. */
let asked: readonly ViewName[] = []

/** The views and formulas that the page can begin without; if they do not come, the page says so in their place. */
async function completed(app: App, views: Promise<void>): Promise<void> {
  const { state } = app.store
  try {
    await views
    app.schedule()
    const parts = loadParts(asked, state.view, () => app.schedule())
    const model = needsSecond(asked) && retried(() => completedModel(SECOND)).then((whole) => app.begin(whole))
    await Promise.all([parts, model])
    // Says that nothing more will be asked for, but what a view asks for itself.
    document.documentElement.dataset.whole = ''
    // What stands in a page of others has not all that a visit is kept with.
    if (viewsLoaded() && !state.embed) await keepForLater()
  } catch {
    secondFailed()
    app.schedule()
  }
}

async function begin(): Promise<void> {
  const root = document.getElementById('page')
  if (!root) return
  document.getElementById('still')?.setAttribute('hidden', '')
  const opened = readLink(location.hash)
  const app = new App(root, VIEWS, dialogs, opened)
  asked = shownViews(opened.state)
  const views = loadViews(asked)
  window.addEventListener('hashchange', ({ newURL }) => {
    // The address itself may have been written again in the meantime.
    app.store.openLink(readLink(new URL(newURL).hash))
    const shown = shownViews(app.store.state)
    if (shown.every((each) => asked.includes(each))) return
    asked = shown
    void completed(app, loadViews(shown))
  })
  const slow = setTimeout(() => app.wait({ slow: true, failed: null }), 300)
  try {
    if (typeof WebAssembly !== 'object') throw new Error('no-wasm')
    const model = await retried(() => openModel(SOURCES))
    if (opened.state.view !== 'lab') await views
    app.begin(model)
    void completed(app, views)
  } catch (error) {
    // The part that needs no core stands below what is said of it.
    document.getElementById('still')?.removeAttribute('hidden')
    document.documentElement.classList.add('failed')
    app.wait({ slow: false, failed: error instanceof Error ? error.message : String(error) })
    return
  } finally {
    clearTimeout(slow)
  }
  const reduced = matchMedia('(prefers-reduced-motion: reduce)').matches
  if (reduced) app.store.setSession({ reduced: true })
  else if (!opened.given.has('t')) app.store.play()
}

void begin()
