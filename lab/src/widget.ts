// The drawing of the lab as a widget of notebooks, for anywidget: one module with the core inside, which asks for nothing.
//
// The traits of Python are the start, and the length with gravity or omega0. What a hand changes goes to Python, what Python sets comes
// here. Numbers that no hand has touched stay as Python gave them: the lab has them as doubles too.

import { render as draw, html, nothing, type TemplateResult } from 'lit-html'
import { onResize, remPixels } from './controls/size'
import { value } from './controls/value'
import { nearestLanguage, Words } from './language'
import { readLink } from './link'
import { remember } from './memory'
import { type Model, openModel } from './model'
import { parseNumber } from './number'
import { SOURCES } from './sources'
import { Store } from './store'
import { rememberedStudy, spanOf, windowOf } from './study'
import baseStyle from './style/base.css?inline'
import chartStyle from './style/charts.css?inline'
import controlStyle from './style/controls.css?inline'
import tokenStyle from './style/tokens.css?inline'
import widgetStyle from './style/widget.css?inline'
import { angleChart } from './views/angle'
import { bench, motionSentence } from './views/bench'
import type { Live } from './views/page'
import { player, spanSwitch } from './views/player'
import { periodMarks } from './views/time-axis'

/** What anywidget gives. */
interface Traits {
  get(name: string): unknown
  set(name: string, value: unknown): void
  save_changes(): void
  on(event: string, listener: () => void): void
  off(event: string, listener: () => void): void
}

const START = ['theta0', 'velocity0', 'length', 'gravity'] as const
/** Standard gravity, in m/s²; of a pendulum that is given by omega0 the length is what has this frequency there. */
const STANDARD = 9.80665
/** How often a hand that drags tells Python, in ms. */
const PAUSE = 60

const STYLE = [tokenStyle, baseStyle, chartStyle, controlStyle, widgetStyle]
  .join('\n')
  .replace(/:root(\[[^\]]*\]|:not\([^)]*\))/g, ':host($1)')
  .replaceAll(':root', ':host')

let core: Promise<Model> | null = null
const shown = new Set<NotebookView>()
onResize(() => {
  for (const each of shown) each.schedule()
})

const number = (traits: Traits, name: string): number => Number(traits.get(name))

/** Whether what is behind an element is dark: notebooks have themes of their own. */
function isDark(element: HTMLElement): boolean {
  let each: Element | null = element
  while (each) {
    const numbers = getComputedStyle(each).backgroundColor.match(/[\d.]+/g) ?? []
    const [red = 0, green = 0, blue = 0, opaque = 1] = numbers.map(Number)
    if (numbers.length > 0 && opaque > 0) return red + green + blue < 384
    const root: Node = each.getRootNode()
    each = each.parentElement ?? (root instanceof ShadowRoot ? root.host : null)
  }
  return false
}

class NotebookView {
  readonly #store = new Store(readLink(''))
  readonly #host = document.createElement('div')
  readonly #inside: HTMLElement
  readonly #motion = remember((model: Model, theta0: number, velocity0: number, length: number, gravity: number) =>
    model.motion({ theta0, velocity0, length, gravity }),
  )
  #model: Model | null = null
  #failed = ''
  #scheduled = false
  #told: ReturnType<typeof setTimeout> | undefined
  #omega0: number | null = null

  constructor(
    private readonly traits: Traits,
    element: HTMLElement,
  ) {
    element.append(this.#host)
    const root = this.#host.attachShadow({ mode: 'open' })
    root.append(Object.assign(document.createElement('style'), { textContent: STYLE }))
    this.#inside = root.appendChild(document.createElement('div'))
    this.#store.open({ curves: [], span: 'T' })
    this.take()
    this.#store.listen(() => {
      this.schedule()
      this.#told ??= setTimeout(() => this.#tell(), PAUSE)
    })
    // A notebook's own keys are not meant while a hand is in here.
    this.#host.addEventListener('keydown', (event) => event.stopPropagation())
  }

  readonly take = (): void => {
    const { traits } = this
    const omega0 = traits.get('omega0')
    this.#omega0 = typeof omega0 === 'number' ? omega0 : null
    const gravity = this.#omega0 === null ? number(traits, 'gravity') : STANDARD
    const length = this.#omega0 === null ? number(traits, 'length') : STANDARD / (this.#omega0 * this.#omega0)
    const start = { theta0: number(traits, 'theta0'), velocity0: number(traits, 'velocity0'), length, gravity }
    const { state } = this.#store
    if (START.some((name) => !Object.is(state[name], start[name]))) this.#store.open({ ...start, t: 0 })
  }

  /** What a hand has changed. */
  #tell(): void {
    this.#told = undefined
    const { traits } = this
    const { state } = this.#store
    const named = this.#omega0 === null ? START : (['theta0', 'velocity0'] as const)
    const changed = named.filter((name) => !Object.is(traits.get(name), state[name]))
    for (const name of changed) traits.set(name, state[name])
    const frequency = this.#omega0 !== null && !Object.is(traits.get('omega0'), this.#omega0)
    if (frequency) traits.set('omega0', this.#omega0)
    if (changed.length > 0 || frequency) traits.save_changes()
  }

  async begin(): Promise<void> {
    this.schedule()
    try {
      core ??= openModel(SOURCES)
      this.#model = await core
      const still = matchMedia('(prefers-reduced-motion: reduce)').matches
      if (still) this.#store.setSession({ reduced: true })
      else this.#store.play()
    } catch (error) {
      this.#failed = String(error)
    }
    this.schedule()
  }

  schedule(): void {
    if (this.#scheduled) return
    this.#scheduled = true
    requestAnimationFrame(() => {
      this.#scheduled = false
      if (!this.#host.isConnected && this.#model) return
      this.#draw()
      if (this.#store.clock.playing) this.schedule()
    })
  }

  readonly #words = remember((wanted: string) => new Words(nearestLanguage(wanted ? [wanted] : navigator.languages)))

  #draw(): void {
    this.#host.dataset.theme = isDark(this.#host.parentElement ?? this.#host) ? 'dark' : 'light'
    const words = this.#words(String(this.traits.get('lang') ?? ''))
    const model = this.#model
    if (!model) {
      draw(html`<div class="widget"><p class="waiting-line">${this.#failed || '…'}</p></div>`, this.#inside)
      return
    }
    const store = this.#store
    const { state, session } = store
    const motion = this.#motion(model, state.theta0, state.velocity0, state.length, state.gravity)
    const live: Live = { store, state, session, words, model, motion, t: store.clock.t, rem: remPixels() }
    draw(this.#page(live), this.#inside)
  }

  #page(live: Live): TemplateResult {
    const { motion, t, state, session } = live
    const { from, to } = windowOf(spanOf(state, motion), t)
    const study = rememberedStudy(motion, state.curves, from, to, session.held !== null && session.held !== 'time')
    const by = this.#omega0 !== null
    return html`<div class="widget" lang=${live.words.language} data-frequency=${by ? 'omega0' : nothing}>
      <div class="column">${bench(live, [])}${by ? this.#frequency(live) : nothing}</div>
      <div class="column"><p class="sentence">${motionSentence(live).replaceAll('*', '')}</p>
        ${angleChart(live, study)}${player(live, study.window, periodMarks(study), spanSwitch(live))}</div></div>`
  }

  /** omega0, of a pendulum that has no length. */
  #frequency({ store, words, session }: Live): TemplateResult {
    const omega0 = this.#omega0 ?? 1
    const take = (next: number) => {
      if (!(next > 0 && Number.isFinite(next))) return
      this.#omega0 = next
      store.open({ length: STANDARD / (next * next), t: 0 })
    }
    return value({
      key: 'omega0',
      label: 'omega0',
      symbol: '_ω_{0}',
      unit: words.say.units['rad/s'],
      value: omega0,
      least: 0,
      most: 10,
      step: 0.1,
      grain: 0.05,
      origin: 0,
      ticks: [1],
      text: words.typed(omega0),
      spoken: words.typed(omega0),
      draft: session.drafts.omega0,
      fault: null,
      onText: (text) => {
        store.draft('omega0', text)
        take(parseNumber(text))
      },
      onDone: () => store.draft('omega0', null),
      onSlide: (next) => {
        store.draft('omega0', null)
        take(next)
      },
      onHold: (held) => store.setSession({ held: held ? 'omega0' : null }),
    })
  }
}

/** Shows the widget; what is returned takes it away. */
function render({ model, el }: { model: Traits; el: HTMLElement }): () => void {
  const view = new NotebookView(model, el)
  shown.add(view)
  const events = [...START, 'omega0'].map((name) => `change:${name}`)
  for (const event of events) model.on(event, view.take)
  void view.begin()
  return () => {
    for (const event of events) model.off(event, view.take)
    shown.delete(view)
  }
}

export default { render }
