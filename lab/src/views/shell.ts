// The frame of the page: top bar with the tabs of the views, messages, the sentence, the chosen view, dialogs.

import { html, nothing, type TemplateResult } from 'lit-html'
import { iconButton, menu, message, switches } from '../controls/parts'
import { icon, mark } from '../draw/icons'
import { shownSections, shownViews } from '../embedding'
import { LANGUAGE_NAMES, languageNote, type Words } from '../language'
import { plain, rich } from '../language/rich'
import { LANGUAGES, type Language, type State, type Theme, type ViewName } from '../state'
import type { Message } from '../store'
import { openDialog } from './dialogs'
import { faultText } from './faults'
import { isLive, type Live, type Page } from './page'

/** One view of the page: its sentence and what is below it. */
export interface View {
  readonly name: ViewName
  readonly sentence: (page: Live) => string
  /** What is spoken besides the sentence: alarms. */
  readonly alarm?: (page: Live) => string
  readonly body: (page: Live) => TemplateResult
}

function tabs(page: Page, views: readonly View[]): TemplateResult {
  const { words, state, store } = page
  const shown = shownViews(state)
  return html`<nav class="tabs" aria-label=${words.say.shell.views}>${views.flatMap(({ name }) =>
    !shown.includes(name)
      ? []
      : html`<button type="button" class=${state.view === name ? 'on' : ''} aria-current=${state.view === name ? 'page' : nothing} data-view=${name}
      @click=${() => store.set({ view: name })}><span class="long">${words.say.views[name]}</span><span class="short-name">${words.say.viewsShort[name]}</span></button>`,
  )}</nav>`
}

function languageItems({ store, words }: Page) {
  return LANGUAGES.map((language: Language) => ({
    text: LANGUAGE_NAMES[language],
    lang: language,
    ...(languageNote(language) === '' ? {} : { note: languageNote(language) }),
    chosen: words.language === language,
    act: () => store.set({ language }),
  }))
}

const THEME_ICONS = { auto: 'auto', light: 'sun', dark: 'moon' } as const

function themeSwitch({ store, state, words }: Page): TemplateResult {
  const { themes, theme } = words.say.shell
  const options = (['auto', 'light', 'dark'] as const).map((value) => ({
    value: value as Theme,
    icon: THEME_ICONS[value],
    name: themes[value],
  }))
  return switches(theme, options, state.theme, (next) => store.set({ theme: next }), 'themes')
}

function header(page: Page, views: readonly View[]): TemplateResult {
  const { words, session, store, state } = page
  const { shell } = words.say
  const open = (key: string) => (isOpen: boolean) => store.setSession({ menu: isOpen ? key : null })
  return html`<header class="top"><a class="mark" href="#" @click=${(event: Event) => {
    event.preventDefault()
    store.set({ view: 'lab' })
  }}>${mark}<span>libration</span></a>
    ${tabs(page, views)}
    <div class="top-tools"><button type="button" class="button" id="share" @click=${() => openDialog(page, 'share')}>${icon('share')}<span>${shell.share}</span></button>
      ${menu({
        key: 'language',
        label: html`${words.language.slice(0, 2).toUpperCase()}${icon('down')}`,
        // What is seen of it stands in its name, for who speaks to the page.
        name: `${words.language.slice(0, 2).toUpperCase()}, ${shell.language}: ${LANGUAGE_NAMES[words.language]}`,
        open: session.menu === 'language',
        toggle: open('language'),
        items: languageItems(page),
        className: 'wide-only right',
      })}
      <span class="wide-only">${themeSwitch(page)}</span>
      ${iconButton(shell.keys, 'keys', () => openDialog(page, 'keys'), undefined, 'wide-only')}
      ${menu({
        key: 'more',
        label: icon('dots'),
        name: shell.menu,
        open: session.menu === 'more',
        toggle: open('more'),
        className: 'narrow-only right',
        items: [
          ...languageItems(page),
          ...(['auto', 'light', 'dark'] as const).map((theme) => ({
            text: `${shell.theme}: ${shell.themes[theme]}`,
            chosen: state.theme === theme,
            act: () => store.set({ theme }),
          })),
          { text: shell.keys, act: () => openDialog(page, 'keys') },
        ],
      })}</div></header>`
}

function bar(page: Page, one: Message): TemplateResult {
  const { words, store, state } = page
  const { linkFaults, shell, messages } = words.say
  const close = () => store.dismiss(one.key)
  if (one.faults) {
    const intro = one.faults.length > 1 ? linkFaults.introMany : linkFaults.intro
    return message(
      html`<p>${intro} ${one.faults.map((fault) => html`${faultText(words, fault, state.hide)} `)}${linkFaults.kept}</p>`,
      messages.close,
      close,
    )
  }
  const { undo } = one
  const back = (state: State) => {
    store.dismiss(one.key)
    store.clock.pause()
    store.set(state)
  }
  return message(
    html`<p>${one.text} ${undo ? html`<button type="button" class="text-button" @click=${() => back(undo)}>${shell.undo}</button>` : nothing}</p>`,
    messages.close,
    close,
    true,
  )
}

/** What is shown while there is no model: the frame stands, the reason is in the page. */
export interface Waiting {
  readonly slow: boolean
  readonly failed: string | null
}

function waitingBody(page: Page, waiting: Waiting): TemplateResult {
  const { words } = page
  if (waiting.failed === null)
    return html`<p class="waiting-line" role="status">${waiting.slow ? words.say.plots.loading : ''}</p>`
  const { messages } = words.say
  const text = waiting.failed === 'no-wasm' ? messages.noWasm : words.fill(messages.failed, { why: waiting.failed })
  const parts = text.split(/(\{offline\}|\{table\})/)
  const linked = parts.map((part) => {
    if (part === '{offline}') return html`<a href="offline.html">${messages.offline}</a>`
    return part === '{table}' ? html`<a href="#still">${messages.periodTable}</a>` : part
  })
  return message(html`<p>${linked}</p>`, messages.close, null)
}

function skip(words: Words): TemplateResult {
  return html`<a class="skip" href="#main" @click=${(event: Event) => {
    event.preventDefault()
    const first = document.querySelector<HTMLElement>('.bob-handle') ?? document.getElementById('main')
    first?.focus()
  }}>${words.say.shell.skip}</a>`
}

/** The dialog of a page, if one is open. */
export type Dialogs = (page: Page) => TemplateResult | typeof nothing

export function shell(
  page: Page,
  views: readonly View[],
  dialogs: Dialogs,
  waiting: Waiting,
  spoken: string,
): TemplateResult {
  const { words, state, session } = page
  const view = views.find(({ name }) => name === state.view) ?? views[0]
  const live = isLive(page) && view ? page : null
  const sentence = live && view ? view.sentence(live) : words.say.sentence.waiting
  return html`<svg class="definitions" aria-hidden="true"><defs><pattern id="hatch" width="8" height="8" patternUnits="userSpaceOnUse" patternTransform="rotate(45)"><path d="M0 0V8" stroke="var(--edge)" stroke-width="1" opacity="0.8"/></pattern></defs></svg>
    ${state.embed ? nothing : skip(words)}
    ${state.embed ? (shownViews(state).length > 1 ? html`<header class="top">${tabs(page, views)}</header>` : nothing) : header(page, views)}
    <div class="messages">${session.messages.map((one) => bar(page, one))}</div>
    <main id="main" tabindex="-1" class="view view-${view?.name ?? 'lab'} ${state.embed ? 'embedded' : ''}" data-parts=${shownSections(state) ?? nothing}>
      <h1 class="sentence">${rich(sentence)}</h1>
      ${live && view ? view.body(live) : waitingBody(page, waiting)}
    </main>
    <div class="unseen" role="status" aria-live="polite" id="live">${plain(spoken)}</div>
    ${dialogs(page)}`
}
