// The language of the page: words from a catalogue, numbers as it writes them, functions as it calls them.

import { degrees, shortest } from '../number'
import { LANGUAGES, type Language } from '../state'
import type { AbsentCatalogue } from './data-absent'
import { en, type FirstCatalogue } from './en'
import type { DataCatalogue } from './en-data'
import type { DerivationCatalogue } from './en-derivation'
import type { FrictionCatalogue } from './en-friction'
import type { HandoutsCatalogue } from './en-handouts'
import type { LaterCatalogue } from './en-later'
import type { SaveCatalogue } from './en-save'
import type { SpringCatalogue } from './en-springs'
import { es } from './es'
import { ptBR } from './pt-BR'
import { filled } from './rich'

/** What comes with the later views. */
interface Added extends LaterCatalogue {
  readonly derivation: DerivationCatalogue
  readonly spring: SpringCatalogue
  readonly damped: FrictionCatalogue
  readonly data: AbsentCatalogue & DataCatalogue
  readonly handouts: HandoutsCatalogue
  readonly save: SaveCatalogue
}
type Catalogue = FirstCatalogue & Added

const FIRST: Readonly<Record<Language, FirstCatalogue>> = { en, 'pt-BR': ptBR, es }
/** Whole once the words of all parts have come; a part asks for none but its own and those that are there before it. */
const CATALOGUES = FIRST as Readonly<Record<Language, Catalogue>>

/** Adds the words of a part of the page that comes after the Lab (later.ts, data.ts, save.ts). */
export function addWords(words: Readonly<Record<Language, Partial<Added>>>): void {
  for (const language of LANGUAGES) Object.assign(CATALOGUES[language], words[language])
}

/** In their own names; those made by machine say so until a native reader has seen them. */
export const LANGUAGE_NAMES: Readonly<Record<Language, string>> = { en: 'English', 'pt-BR': 'Português', es: 'Español' }

/** What to say of a language's words, in that language; empty for English. */
export function languageNote(language: Language): string {
  return CATALOGUES[language].machineAssisted
}

/** The first of the reader's languages that there is. */
export function nearestLanguage(wanted: readonly string[]): Language {
  for (const tag of wanted) {
    const base = tag.toLowerCase().split('-')[0]
    const found = LANGUAGES.find((each) => each.toLowerCase().split('-')[0] === base)
    if (found) return found
  }
  return 'en'
}

export class Words {
  readonly say: Catalogue
  readonly #formats = new Map<string, Intl.NumberFormat>()

  constructor(readonly language: Language) {
    this.say = CATALOGUES[language]
  }

  /** A catalogue text with its {names} replaced. */
  fill(text: string, values: Readonly<Record<string, string | number>>): string {
    return filled(text, values)
  }

  #format(options: Intl.NumberFormatOptions): Intl.NumberFormat {
    const key = JSON.stringify(options)
    let made = this.#formats.get(key)
    if (!made) {
      made = new Intl.NumberFormat(this.language, { useGrouping: false, ...options })
      this.#formats.set(key, made)
    }
    return made
  }

  /** With so many decimals, and a minus sign that is one. */
  fixed(value: number, decimals: number): string {
    if (Number.isNaN(value)) return '–'
    if (!Number.isFinite(value)) return value > 0 ? '∞' : '−∞'
    const text = this.#format({ minimumFractionDigits: decimals, maximumFractionDigits: decimals }).format(value)
    const zero = !/[1-9]/.test(text)
    return zero ? text.replace('-', '') : text.replace('-', '−')
  }

  /** With so many significant digits; as a power of ten where zeros would hide them. */
  significant(value: number, digits = 3): string {
    if (value === 0) return '0'
    if (!Number.isFinite(value)) return this.fixed(value, 0)
    const size = Math.abs(Number(value.toPrecision(digits)))
    const exponent = Math.floor(Math.log10(size))
    if (exponent < -4 || exponent > 4) return this.#power(this.fixed(value / 10 ** exponent, digits - 1), exponent)
    return this.fixed(value, Math.max(digits - 1 - exponent, 0))
  }

  /** As it was given: no digit more, none less. */
  given(value: number): string {
    const [mantissa = '', exponent] = shortest(value).split('e')
    const text = mantissa.replace('-', '−').replace('.', this.decimal)
    return exponent ? this.#power(text, Number(exponent)) : text
  }

  /** In the markup of rich.ts. */
  #power(mantissa: string, exponent: number): string {
    return `${mantissa}\u00a0×\u00a010^{${String(exponent).replace('-', '−')}}`
  }

  /** For a field, where what is shown can be typed again. */
  typed(value: number): string {
    return shortest(value).replace('-', '−').replace('.', this.decimal)
  }

  get decimal(): '.' | ',' {
    return this.language === 'en' ? '.' : ','
  }

  angle(radians: number, decimals?: number): string {
    const value = degrees(radians)
    return `${decimals === undefined ? this.given(value) : this.fixed(value, decimals)}°`
  }

  /** For a sentence: as given where that is short in degrees or in radians, else to a thousandth of a degree. */
  shortAngle(radians: number): string {
    const inDegrees = degrees(radians)
    const few = (value: number) => Math.abs(value * 1000 - Math.round(value * 1000)) < 1e-9
    if (!few(inDegrees) && few(radians)) return this.with(this.given(radians), 'rad')
    return `${this.given(Number(inDegrees.toFixed(3)))}°`
  }

  /** With a space that does not break. */
  with(text: string, unit: string): string {
    return unit === '°' ? `${text}°` : `${text}\u00a0${unit}`
  }

  /** An error in degrees. */
  degrees(value: number): string {
    const text = this.significant(value)
    // Not onto a power of ten, where it would be read as one.
    return text.includes('^') ? `${text}\u00a0°` : `${text}°`
  }

  percent(value: number, digits = 3): string {
    return this.with(this.significant(value, digits), '%')
  }

  /** Formulas with the functions as this language writes them: sen, tg. */
  formula(text: string): string {
    return text.replace(/\b(arc)?(sin|tan)\b/g, (_, arc: string | undefined, name: 'sin' | 'tan') => {
      return (arc ?? '') + this.say.functionNames[name]
    })
  }
}
