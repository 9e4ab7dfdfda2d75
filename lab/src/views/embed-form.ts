// What another page may have of this one: a form that makes the code of a frame, with the parts, the locks and Planet X.

import { html, nothing, type TemplateResult } from 'lit-html'
import { switches } from '../controls/parts'
import { embedCode, saysNothing, shownViews } from '../embedding'
import { plain, rich } from '../language/rich'
import { writeLink } from '../link'
import { LOCKS, type Lock, SECTIONS, type Shown, type State, VIEWS, type ViewName } from '../state'
import { localNotice } from './local'
import { copyText, type Live } from './page'

const SIZES = { '360': [360, 640], '640': [640, 480], '800': [800, 600] } as const
type Size = keyof typeof SIZES

/** What is chosen; it is for another page, so that it is not in the link of this one. */
interface EmbedChoices {
  readonly show: readonly Shown[]
  readonly lock: readonly Lock[]
  readonly hide: boolean
  readonly size: Size
  readonly preview: boolean
}
let chosen: EmbedChoices = { show: ['phase'], lock: ['L', 'g'], hide: false, size: '360', preview: false }

const OFFERED: readonly ViewName[] = VIEWS.filter((name) => name !== 'handouts')

/** The link of the embedded page: this motion, with what is chosen. */
function embeddedLink({ store, words }: Live, { show, lock, hide }: EmbedChoices): string {
  const { moment } = store
  const allowed = show.filter((each) => !hide || saysNothing(each))
  const state: State = {
    ...moment,
    // It begins at the start, not where this page happens to be.
    t: 0,
    language: words.language,
    embed: true,
    show: allowed,
    lock,
    hide,
    handout: 'worksheet',
    seed: 1,
    key: false,
  }
  const span = hide && state.span === 'T' ? 8 : state.span
  return (
    location.href.replace(/#.*$/, '') + writeLink({ ...state, span, view: shownViews(state)[0] ?? 'lab' }, store.kept)
  )
}

export function embedForm(page: Live): TemplateResult {
  const { words, store, session } = page
  const { handouts, views, values } = words.say
  const change = (patch: Partial<EmbedChoices>) => {
    chosen = { ...chosen, preview: false, ...patch }
    store.setSession({ copied: false, copyFailed: false })
  }
  const toggled = <T>(all: readonly T[], each: T, on: boolean) =>
    on ? [...all, each] : all.filter((one) => one !== each)
  const box = (id: string, text: string, on: boolean, set: (on: boolean) => void, disabled = false) =>
    html`<label class="check"><input type="checkbox" id=${id} .checked=${on && !disabled} ?disabled=${disabled} @change=${(event: Event) => set((event.target as HTMLInputElement).checked)}> <span>${rich(text)}</span></label>`
  const show = (each: Shown, text: string, disabled = false) =>
    box(
      `show-${each}`,
      text,
      chosen.show.includes(each),
      (on) => change({ show: toggled(chosen.show, each, on) }),
      disabled,
    )
  const names: Readonly<Record<Lock, string>> = {
    th0: `${values.theta0.label} ${values.theta0.symbol}`,
    w0: `${values.velocity0.label} ${values.velocity0.symbol}`,
    L: `${values.length.label} ${values.length.symbol}`,
    g: `${values.gravity.label} ${values.gravity.symbol}`,
    curves: handouts.curves,
  }
  const closed = (each: Shown) => chosen.hide && !saysNothing(each)
  const link = embeddedLink(page, chosen)
  const [width, height] = SIZES[chosen.size]
  const code = embedCode(link, width, height)
  const order = <T>(all: readonly T[], some: readonly T[]) => all.filter((each) => some.includes(each))
  return html`<div class="handout-columns embed-columns"><div class="column handout-choices">
      <fieldset class="group"><legend>${handouts.views}</legend>${OFFERED.map((name) => show(name, views[name], closed(name)))}</fieldset>
      <fieldset class="group"><legend>${handouts.partsOf}</legend>${SECTIONS.map((name) => show(name, handouts.parts[name], closed(name)))}</fieldset>
      <p class="soft small">${handouts.shownHelp}</p></div>
    <div class="column handout-choices">
      <fieldset class="group"><legend>${handouts.locked}</legend>${LOCKS.map((name) =>
        box(`lock-${name}`, names[name], chosen.lock.includes(name), (on) =>
          change({ lock: order(LOCKS, toggled(chosen.lock, name, on)) }),
        ),
      )}</fieldset>
      <fieldset class="group"><legend class="unseen">${plain(handouts.planet)}</legend>${box('hide-g', handouts.planet, chosen.hide, (hide) => change({ hide }))}</fieldset>
      <p class="soft small">${rich(handouts.planetHelp)}</p>
      ${chosen.hide ? html`<p class="soft small" id="hidden-help">${rich(handouts.hiddenHelp)}</p>` : nothing}</div>
    <div class="column embed-result"><div class="entry"><span aria-hidden="true">${handouts.size}</span>${switches(
      handouts.size,
      (Object.keys(SIZES) as Size[]).map((value) => ({ value, text: SIZES[value].join(' × ') })),
      chosen.size,
      (size) => change({ size }),
    )}</div>
      <textarea id="embed-code" class="link" readonly rows="7" spellcheck="false" aria-label=${handouts.frame} .value=${code} @focus=${(event: FocusEvent) => (event.target as HTMLTextAreaElement).select()}></textarea>
      ${localNotice(words)}
      ${session.copyFailed ? html`<p class="soft small" role="status">${handouts.copyFailed}</p>` : nothing}
      <div class="foot"><button type="button" class="button primary" id="copy-embed" @click=${() => copyText(page, code, '#embed-code')}>${session.copied ? handouts.copied : handouts.copyFrame}</button>
      <button type="button" class="button" @click=${() => copyText(page, link, '#embed-code')}>${handouts.copyLink}</button>
      <button type="button" class="button" id="preview" aria-expanded=${chosen.preview ? 'true' : 'false'} @click=${() => change({ preview: !chosen.preview })}>${chosen.preview ? handouts.hide : handouts.show}</button></div>
      <span class="unseen" role="status">${session.copied ? handouts.copied : ''}</span>
      ${chosen.preview ? html`<iframe class="embed-preview" src=${link} width=${width} height=${height} title=${handouts.previewTitle}></iframe>` : nothing}</div></div>`
}
