// The play bar of every view: time of the clock, typed time, speed, and which span the plots show.

import { html, type TemplateResult } from 'lit-html'
import { switches } from '../controls/parts'
import { playBar } from '../controls/play'
import { field } from '../controls/value'
import { rich } from '../language/rich'
import { inRange, SPEEDS, type State } from '../state'
import type { Window } from '../study'
import { type Page, setNumber } from './page'
import { fieldFault, readField } from './values'

/** A frame of film, in s. */
const FRAME = 1 / 60

export function togglePlay({ store }: Pick<Page, 'store'>): void {
  if (store.clock.playing) store.pause()
  else store.play()
}

export function stepFrame({ store }: Pick<Page, 'store'>, frames: number): void {
  store.clock.pause()
  store.seek(Math.max(0, store.clock.t + frames * FRAME * store.clock.speed))
}

function timeField(page: Page, where: 'bar' | 'short'): TemplateResult {
  const { store, words, session, t } = page
  const key = `t-${where}`
  const draft = session.drafts[key]
  const fault = fieldFault(page, 't', draft)
  const { label, symbol } = words.say.values.t
  const spec = {
    key,
    label,
    symbol,
    unit: words.say.units.s,
    value: t,
    least: 0,
    most: 100_000,
    step: 0.1,
    grain: 0.01,
    origin: 0,
    ticks: [],
    text: words.fixed(t, 2),
    spoken: '',
    draft,
    fault,
    onText: (text: string) => {
      store.clock.pause()
      store.draft(key, text)
      const value = readField('t', text)
      if (inRange('t', value)) store.seek(value)
    },
    onDone: () => fault === null && store.draft(key, null),
    onSlide: (next: number) => store.seek(next),
    onHold: () => {},
  }
  return html`<span class="time">${where === 'bar' ? html`<span class="time-name" aria-hidden="true">${rich(symbol)}</span>` : ''}${field(spec, label)}</span>`
}

function speedSwitch({ store, words }: Page): TemplateResult {
  const options = SPEEDS.map((value) => ({
    value: value as number,
    text: { 0.25: '¼', 0.5: '½', 1: '1', 2: '2' }[value],
    name: `${words.say.play.speed} ${words.given(value)}`,
  }))
  return html`<span class="soft option">${words.say.play.speed} ${switches(words.say.play.speed, options, store.clock.speed, (speed) => store.set({ speed }))}</span>`
}

/** 1 T, 8 s, 60 s, or as typed. */
export function spanSwitch(page: Page): TemplateResult {
  const { store, words, state, session } = page
  const usual: { value: State['span']; text: string }[] = [
    ...(state.hide ? [] : [{ value: 'T' as const, text: words.say.play.period }]),
    { value: 8, text: words.with('8', words.say.units.s) },
    { value: 60, text: words.with('60', words.say.units.s) },
  ]
  const draft = session.drafts.span
  const other = typeof state.span === 'number' && !usual.some(({ value }) => value === state.span)
  const spec = {
    key: 'span',
    label: words.say.play.other,
    symbol: '',
    unit: words.say.units.s,
    value: typeof state.span === 'number' ? state.span : 0,
    least: 0.1,
    most: 600,
    step: 1,
    grain: 1,
    origin: 0,
    ticks: [],
    text: other && typeof state.span === 'number' ? words.typed(state.span) : '',
    spoken: '',
    draft,
    fault: fieldFault(page, 'span', draft),
    onText: (text: string) => {
      store.draft('span', text)
      setNumber(store, 'span', readField('span', text))
    },
    onDone: () => fieldFault(page, 'span', draft) === null && store.draft('span', null),
    onSlide: (next: number) => setNumber(store, 'span', next),
    onHold: () => {},
  }
  return html`<span class="soft option">${words.say.play.shown} ${switches(words.say.play.shown, usual, state.span, (span) => store.set({ span }))}<span class="span-field ${other ? 'on' : ''}">${field(spec, words.say.play.other)}</span></span>`
}

export function player(page: Page, window: Window, ticks: readonly number[], last: TemplateResult): TemplateResult {
  const { store, words, t, session } = page
  const { play } = words.say
  return playBar({
    playing: store.clock.playing,
    t,
    current: () => store.clock.t,
    from: window.from,
    to: window.to,
    ticks: ticks.filter((tick) => tick > window.from && tick < window.to),
    names: { play: play.play, pause: play.pause, back: play.back, on: play.on, bar: play.bar },
    spoken: words.fill(play.timeText, { t: words.fixed(t, 2) }),
    field: (where) => timeField(page, where),
    options: [speedSwitch(page), last],
    note: session.reduced && !store.clock.playing ? play.reduced : null,
    onPlay: () => togglePlay(page),
    onStep: (frames) => stepFrame(page, frames),
    onSeek: (time) => {
      store.clock.pause()
      // The end of this window is the beginning of the next; the head stays in this one.
      store.seek(Math.min(time, window.to - 1e-6 * (window.to - window.from)))
    },
    onHold: (held) => store.setSession({ held: held ? 'time' : null }),
  })
}
