// The page at work: state and clock in, one render for each frame that needs one; link, theme, language and keys beside it.

import { render } from 'lit-html'
import { onResize, remPixels } from './controls/size'
import { nearestLanguage, Words } from './language'
import { type Opened, writeLink } from './link'
import { remember } from './memory'
import type { Model, Motion } from './model'
import type { State } from './state'
import { Store } from './store'
import { onKey } from './views/keyboard'
import { isLive, type Page } from './views/page'
import { type Dialogs, shell, type View, type Waiting } from './views/shell'

export class App {
  readonly store: Store
  #model: Model | null = null
  #waiting: Waiting = { slow: false, failed: null }
  #scheduled = false
  #spoken = ''
  #speech: ReturnType<typeof setTimeout> | undefined
  #address: ReturnType<typeof setTimeout> | undefined
  #rem = 16
  readonly #words = remember((language: State['language']) => {
    return new Words(language === 'auto' ? nearestLanguage(navigator.languages) : language)
  })
  readonly #motion = remember((model: Model, theta0: number, velocity0: number, length: number, gravity: number) =>
    model.motion({ theta0, velocity0, length, gravity }),
  )

  constructor(
    private readonly root: HTMLElement,
    private readonly views: readonly View[],
    private readonly dialogs: Dialogs,
    opened: Opened,
  ) {
    this.store = new Store(opened)
    if (opened.faults.length > 0) this.store.setSession({ messages: [{ key: 'link', faults: opened.faults }] })
    this.store.listen(() => this.schedule())
    this.store.listen(() => this.#remember())
    onResize(() => this.schedule())
    window.addEventListener('resize', () => this.schedule())
    // What a hand does next is meant for the state as it is now, though its frame may not have come yet.
    for (const kind of ['keydown', 'pointerdown', 'click', 'input', 'change'])
      window.addEventListener(kind, () => this.#scheduled && this.#draw(), { capture: true })
    window.addEventListener('keydown', (event) => onKey(event, this.page(), views))
    // Before a hand touches anything, a hidden g is not to be read in the address.
    if (opened.state.hide) this.#remember()
    this.schedule()
  }

  begin(model: Model): void {
    this.#model = model
    this.schedule()
  }

  wait(waiting: Waiting): void {
    this.#waiting = waiting
    this.schedule()
  }

  page(): Page {
    const { store } = this
    const { state, session } = store
    const motion: Motion | null =
      this.#model && this.#motion(this.#model, state.theta0, state.velocity0, state.length, state.gravity)
    return {
      store,
      state,
      session,
      words: this.#words(state.language),
      model: this.#model,
      motion,
      t: store.clock.t,
      rem: this.#rem,
    }
  }

  schedule(): void {
    if (this.#scheduled) return
    this.#scheduled = true
    requestAnimationFrame(() => this.#frame())
  }

  #frame(): void {
    this.#scheduled = false
    this.#draw()
    if (this.store.clock.playing) this.schedule()
  }

  #draw(): void {
    // No control changes the size of a letter.
    if (this.store.session.held === null) this.#rem = remPixels()
    const page = this.page()
    this.#writeDocument(page.words, page.state.theme)
    render(shell(page, this.views, this.dialogs, this.#waiting, this.#spoken), this.root)
    this.#showTab(page.state.view)
  }

  /** On a phone the row of tabs is longer than the screen. */
  readonly #showTab = remember((_: State['view']): void => {
    const tab = document.querySelector('.tabs .on')
    const row = tab?.parentElement
    if (!tab || !row) return
    const [at, within] = [tab.getBoundingClientRect(), row.getBoundingClientRect()]
    row.scrollLeft += Math.max(0, at.right - within.right) + Math.min(0, at.left - within.left)
  })

  /** What stands outside of what is rendered; written when it changes, since each writing makes the browser look at all styles. */
  readonly #writeDocument = remember((words: Words, theme: State['theme']): void => {
    const { documentElement } = document
    documentElement.lang = words.language
    if (theme === 'auto') delete documentElement.dataset.theme
    else documentElement.dataset.theme = theme
    document.title = words.say.shell.title
  })

  /** What changed goes to the address of the page and to the screen reader, a little later and not while playing. */
  #remember(): void {
    clearTimeout(this.#address)
    this.#address = setTimeout(() => {
      const { store } = this
      const state = store.clock.playing ? { ...store.moment, t: store.state.t } : store.moment
      history.replaceState(null, '', writeLink(state, store.kept))
    }, 300)
    clearTimeout(this.#speech)
    this.#speech = setTimeout(() => {
      const page = this.page()
      if (this.store.clock.playing || !isLive(page)) return
      const view = this.views.find(({ name }) => name === page.state.view)
      const next = view ? `${view.sentence(page)} ${view.alarm?.(page) ?? ''}`.trim() : ''
      if (next === this.#spoken) return
      this.#spoken = next
      this.schedule()
    }, 1000)
  }
}
