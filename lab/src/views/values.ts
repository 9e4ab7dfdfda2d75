// The numbers of the state as values of the page: their fields, sliders, and what is wrong with what is typed.

import { html, type TemplateResult } from 'lit-html'
import { entry, type ValueSpec, value } from '../controls/value'
import { icon } from '../draw/icons'
import { isLocked } from '../embedding'
import { plain, rich } from '../language/rich'
import { degrees, parseQuantity, radians } from '../number'
import { inRange, RANGES, type RangeName } from '../state'
import { type Page, quantityText, setNumber } from './page'

export interface Slide {
  readonly least: number
  readonly most: number
  readonly step: number
  readonly grain: number
  readonly origin: number
  readonly ticks: readonly number[]
}

/** Numbers of the state that are values of their own; the span may be a word. */
type NumberName = Exclude<RangeName, 't' | 'speed' | 'span' | 'seed'>

/** Gravity of Moon, Mars, Earth and Jupiter in m/s². */
const PLACES = [1.62, 3.71, 9.81, 24.79]

export function slideOf(page: Page, name: RangeName): Slide {
  switch (name) {
    case 'theta0':
      return { least: -180, most: 180, step: 1, grain: 1, origin: 0, ticks: [-180, -90, 0, 90, 180] }
    case 'velocity0': {
      const top = page.motion?.separatrixVelocity(page.state.theta0) ?? 0
      // Where g is hidden this velocity is for the reader to find.
      const ticks = top > 0 && top < 10 && !page.state.hide ? [-top, 0, top] : [0]
      return { least: -10, most: 10, step: 0.1, grain: 0.05, origin: 0, ticks }
    }
    case 'length':
      return { least: 0.01, most: 2, step: 0.01, grain: 0.01, origin: 0, ticks: [0.01, 1] }
    case 'gravity':
      return { least: 0.01, most: 25, step: 0.01, grain: 0.01, origin: 0, ticks: PLACES }
    default:
      return { least: 0, most: 1, step: 1, grain: 1, origin: 0, ticks: [] }
  }
}

/** The text of a field as the quantity it is; NaN if it is none. */
export function readField(name: RangeName, text: string): number {
  return parseQuantity(text, RANGES[name].unit)
}

/** What is wrong with a draft, in words; null if it can stand. */
export function fieldFault(page: Page, name: RangeName, draft: string | undefined, called?: string): string | null {
  if (draft === undefined || draft.trim() === '') return null
  const { words, state } = page
  const read = readField(name, draft)
  if (inRange(name, read)) return null
  const range = RANGES[name]
  const label = called ?? words.say.values[name as keyof typeof words.say.values]?.label ?? name
  const kept =
    name === 'span' && state.span === 'T'
      ? plain(words.say.play.period)
      : quantityText(words, name, Number(state[name]))
  const unit = range.unit === 'deg' ? '°' : words.say.units[range.unit]
  const value = Number.isNaN(read)
    ? draft.trim()
    : words.with(draft.trim().replace(/\s*(?!e[-+]?\d)[a-z°].*$/i, ''), unit).replace(/\s°/, '°')
  const text = words.say.faults[Number.isNaN(read) ? 'not-a-number' : 'out-of-range']
  return words.fill(text, {
    name: label,
    value,
    kept,
    least: quantityText(words, name, range.least),
    most: quantityText(words, name, range.most),
  })
}

/** A value of which nothing is said but that it is there. */
function hidden({ words }: Page, { label, symbol }: Said): TemplateResult {
  const { embedding } = words.say
  return html`<div class="value" data-value="hidden" title=${embedding.hiddenTitle}><span>${rich(`${label} ${symbol}`)}</span><span class="field locked">${embedding.hidden}${icon('lock')}</span></div>`
}

/** What a value is called. */
interface Said {
  readonly label: string
  readonly symbol: string
}

function specOf(page: Page, name: NumberName, said: Said, slide: Slide): ValueSpec {
  const { words, state, store, session } = page
  const { unit } = RANGES[name]
  const angle = unit === 'deg'
  const number = state[name]
  const shown = angle ? degrees(number) : number
  const draft = session.drafts[name]
  const locked = isLocked(state, name)
  return {
    key: name,
    label: said.label,
    symbol: said.symbol,
    unit: angle ? '°' : words.say.units[unit],
    value: shown,
    current: () => (angle ? degrees(store.state[name]) : store.state[name]),
    ...slide,
    text: words.typed(shown),
    spoken: quantityText(words, name, number),
    draft,
    fault: fieldFault(page, name, draft, said.label),
    ...(locked ? { locked, title: words.say.embedding.locked } : {}),
    onText: (text) => {
      store.draft(name, text)
      setNumber(store, name, readField(name, text))
    },
    onDone: () => fieldFault(page, name, draft) === null && store.draft(name, null),
    onSlide: (next) => {
      store.draft(name, null)
      setNumber(store, name, angle ? radians(next) : next)
    },
    onHold: (held) => store.setSession({ held: held ? name : null }),
  }
}

/** A number of the state with its field and slider. The motion follows while what is typed is valid. */
export function numberValue(page: Page, name: NumberName, said: Said, slide: Slide): TemplateResult {
  return value(specOf(page, name, said, slide))
}

/** The same without a slider, on one line. */
export function numberEntry(page: Page, name: NumberName, said: Said, slide: Slide): TemplateResult {
  return entry(specOf(page, name, said, slide))
}

/** A value of the pendulum by its name. */
export function stateValue(page: Page, name: 'theta0' | 'velocity0' | 'length' | 'gravity'): TemplateResult {
  const said = page.words.say.values[name]
  if (page.state.hide && name === 'gravity') return hidden(page, said)
  return numberValue(page, name, said, slideOf(page, name))
}
