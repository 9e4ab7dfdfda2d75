// The dialog of the film: what it shows, how large, how many frames; then its progress. One film is made at a time.

import { html, nothing, type TemplateResult } from 'lit-html'
import { version } from '../../package.json'
import { switches } from '../controls/parts'
import { plain } from '../language/rich'
import { retried } from '../retry'
import { saveFile } from '../save/file'
import { type Film, type FilmRefusal, filmOf, MOST, makeFilm, RATES, type Sink, WIDTHS } from '../save/film'
import { fontRules } from '../save/fonts'
import { gifSink } from '../save/gif'
import { paint } from '../save/png'
import { Studio } from '../save/svg'
import { SPEEDS } from '../state'
import type { Store } from '../store'
import { spanOf, windowOf } from '../study'
import { pendulumAt } from './bench'
import { dialog } from './dialogs'
import { isLive, type Live, type Page } from './page'
import { filmHeight, pendulumPicture } from './picture'
import { timeText } from './time-axis'

type Video = typeof import('../save/video')
let video: Video | null = null

/** Loads the writer of videos; without it the film is a GIF. */
export async function loadVideo(): Promise<void> {
  video = await retried(() => import('../save/video')).catch(() => null)
}

interface Choices {
  of: 'period' | 'shown'
  format: 'video' | 'gif'
  width: (typeof WIDTHS)[number]
  rate: (typeof RATES)[number]
  /** Null as long as it is that of the play bar. */
  speed: number | null
}

type Work =
  | { readonly kind: 'idle' | 'cancelled' }
  | { readonly kind: 'making'; readonly done: number; readonly frames: number; readonly cancel: () => void }
  | { readonly kind: 'saved'; readonly name: string; readonly bytes: number }
  | { readonly kind: 'failed'; readonly why: string }

const choices: Choices = { of: 'period', format: 'video', width: 480, rate: 25, speed: null }
let work: Work = { kind: 'idle' }
/** What this browser writes; undefined until it was asked. */
let written: 'mp4' | 'webm' | null | undefined

function tell(store: Store, next: Work): void {
  work = next
  store.changed()
}

/** Asks the browser once. */
function probe(store: Store): void {
  if (written !== undefined) return
  written = null
  const asked = video?.encodingFor(choices.width, filmHeight(choices.width), choices.rate)
  void asked?.then((found) => {
    written = found?.ending ?? null
    store.changed()
  })
}

async function sinkFor(
  film: Film,
  canvas: HTMLCanvasElement,
  painted: (frame: number) => Promise<void>,
): Promise<Sink> {
  const { width, height } = canvas
  const encoding = choices.format === 'video' ? await video?.encodingFor(width, height, choices.rate) : null
  return encoding && video ? video.videoSink(encoding, film) : gifSink(film, canvas, painted)
}

async function make(page: Live, film: Film): Promise<void> {
  const { store } = page
  const abort = new AbortController()
  const progress = (done: number) =>
    tell(store, { kind: 'making', done, frames: film.times.length, cancel: () => abort.abort() })
  progress(0)
  const studio = new Studio('drawing')
  const canvas = document.createElement('canvas')
  Object.assign(canvas, { width: choices.width, height: filmHeight(choices.width) })
  try {
    const fonts = await fontRules()
    const painted = (i: number) => {
      const spec = pendulumAt(page, film.theta[i] as number, film.velocity[i] as number, [])
      return paint(studio.draw(pendulumPicture(spec, '', `libration ${version}`)), canvas, fonts)
    }
    const sink = await sinkFor(film, canvas, painted)
    const bytes = await makeFilm(film, canvas, painted, sink, progress, abort.signal)
    const name = `pendulum.${sink.ending}`
    saveFile([bytes], sink.type, name)
    tell(store, { kind: 'saved', name, bytes: bytes.length })
  } catch (error) {
    const why = error instanceof Error ? error.message : String(error)
    tell(store, abort.signal.aborted ? { kind: 'cancelled' } : { kind: 'failed', why })
  } finally {
    studio.close()
  }
}

function refusalText({ words }: Page, { refused, frames }: FilmRefusal): string {
  return words.fill(words.say.save[refused], { frames, most: MOST })
}

function option<K extends keyof Choices>(
  { store }: Page,
  name: K,
  label: string,
  options: readonly { readonly value: Choices[K]; readonly text: string }[],
  chosen: Choices[K] = choices[name],
): TemplateResult {
  return html`<dt>${label}</dt><dd>${switches(label, options, chosen, (value) => {
    choices[name] = value
    work = { kind: 'idle' }
    store.changed()
  })}</dd>`
}

function options(page: Live, speed: number): TemplateResult {
  const { words, motion, state, t } = page
  const say = words.say.save
  const period = words.with(words.fixed(motion.period, 4), words.say.units.s)
  const { from, to } = windowOf(spanOf(state, motion), t)
  const span = words.fill(say.span, { from: timeText(words, from), to: timeText(words, to) })
  const first = words.fill(motion.regime === 'rotation' ? say.turn : say.period, { t: period })
  const formats = [
    ...(written ? [{ value: 'video' as const, text: written === 'mp4' ? 'MP4' : 'WebM' }] : []),
    { value: 'gif' as const, text: 'GIF' },
  ]
  return html`<dl class="film-options">
    ${option(page, 'of', say.shows, [
      { value: 'period', text: plain(first) },
      { value: 'shown', text: span },
    ])}
    ${option(page, 'format', say.format, formats, written ? choices.format : 'gif')}
    ${option(
      page,
      'width',
      say.width,
      WIDTHS.map((value) => ({ value, text: String(value) })),
    )}
    ${option(
      page,
      'rate',
      say.rate,
      RATES.map((value) => ({ value, text: String(value) })),
    )}
    ${option(
      page,
      'speed',
      say.speed,
      SPEEDS.map((value) => ({ value, text: words.given(value) })),
      speed,
    )}</dl>`
}

/** What the film will be. */
function facts(page: Live, film: Film, speed: number): TemplateResult {
  const { words } = page
  const say = words.say.save
  const seconds = (value: number, decimals: number) => words.with(words.fixed(value, decimals), words.say.units.s)
  const sentence = words.fill(say.facts, {
    frames: film.times.length,
    width: choices.width,
    height: filmHeight(choices.width),
    seconds: seconds(film.seconds, 2),
    speed: words.given(speed),
  })
  const gif = choices.format === 'gif' || !written
  const hundredths = Math.round(100 * film.seconds) / 100
  const delays = words.fill(say.delays, { seconds: seconds(hundredths, 2), true: seconds(film.seconds, 4) })
  return html`<p>${sentence} ${film.repeats ? say.repeats : say.once} ${gif ? delays : nothing} ${say.exact}</p>`
}

function state(page: Page): TemplateResult | typeof nothing {
  const { words } = page
  const say = words.say.save
  // Its frames and not those of the choices, which may have changed since it was begun.
  if (work.kind === 'making')
    return html`<div class="working"><span>${words.fill(say.making, { done: work.done, frames: work.frames })}</span>
      <progress max=${work.frames} .value=${work.done} aria-label=${say.progress}></progress></div>`
  if (work.kind === 'saved')
    return html`<p>${words.fill(say.saved, { name: work.name, size: words.fixed(work.bytes / 1000, 0) })}</p>`
  if (work.kind === 'failed') return html`<p class="refusal">${words.fill(say.failed, { why: work.why })}</p>`
  return work.kind === 'cancelled' ? html`<p>${say.cancelled}</p>` : nothing
}

export function filmDialog(page: Page): TemplateResult | typeof nothing {
  if (!isLive(page)) return nothing
  const { words, store, motion } = page
  const say = words.say.save
  probe(store)
  const speed = choices.speed ?? store.clock.speed
  const of = choices.of === 'period' ? ('period' as const) : windowOf(spanOf(page.state, motion), page.t)
  const film = filmOf(motion, { of, rate: choices.rate, speed })
  const refused = 'refused' in film
  const making = work.kind === 'making'
  const missing = written === null ? say.noVideo : written === 'webm' ? say.noMp4 : null
  const act = () => {
    if (work.kind === 'making') work.cancel()
    else if (!refused) void make(page, film)
  }
  // One button, so that the focus stays on it.
  const button = html`<button type="button" class="button ${making ? '' : 'primary'}" id=${making ? 'film-cancel' : 'film-make'} ?disabled=${refused && !making} @click=${act}>${making ? say.cancel : say.make}</button>`
  const body = html`<div class="film">${making ? nothing : options(page, speed)}
    ${making ? nothing : refused ? html`<p role="status" class="refusal">${refusalText(page, film)}</p>` : facts(page, film, speed)}
    ${missing && !making ? html`<p class="soft">${missing}</p>` : nothing}
    <div role="status" id="film-state">${state(page)}</div>
    <div class="foot">${button}</div></div>`
  return dialog(page, 'film', say.title, body)
}
