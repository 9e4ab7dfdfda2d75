// Sentences of the reader and the fit, verdicts, guesses and refusals, in Portuguese and Spanish.
//
// A sentence is known by its English pattern, in which {} stands for what changes; numbers get a decimal comma. One that is not
// known stays English. The table is the Python package's, which has the same for its reports (measurement/_sentences.py).

import table from '../../../python/libration/measurement/sentences.json'
import type { Language } from '../state'

type Table = Readonly<Record<string, readonly string[]>>

const PATTERNS: Table = Object.assign({}, ...Object.values(table.sentences))
const PIECES: Table = table.pieces
const NUMBER = /^[-+−]?[0-9]+\.[0-9]+(e[-+]?[0-9]+)?$/

const literal = (text: string): string => text.replace(/[.*+?^${}()|[\]\\]/g, '\\$&')

/** Patterns with more fixed letters first. */
const compiled: readonly (readonly [RegExp, readonly string[]])[] = Object.entries(PATTERNS)
  .toSorted(([a], [b]) => fixed(b) - fixed(a))
  .map(([english, others]) => [new RegExp(`^${english.split('{}').map(literal).join('(.*?)')}$`, 's'), others])

function fixed(english: string): number {
  return english.replaceAll('{}', '').length
}

/** A sentence in a language; as it is where its pattern is not known. */
export function inLanguage(sentence: string, language: Language): string {
  if (language === 'en') return sentence
  for (const [pattern, others] of compiled) {
    const found = pattern.exec(sentence)
    if (found) return filledIn(of(others, language), found.slice(1), language)
  }
  return sentence
}

const of = (others: readonly string[], language: Language): string => others[language === 'es' ? 1 : 0] as string

/** Places are taken in their order, or by their numbers. */
function filledIn(text: string, parts: readonly string[], language: Language): string {
  let next = 0
  return text.replace(/\{(\d*)\}/g, (_, place: string) => {
    const part = parts[place === '' ? next++ : Number(place)]
    return piece(part ?? '', language)
  })
}

/** What fills a place: a number, a known text, a sentence of its own, or names, which stay. */
function piece(part: string, language: Language): string {
  if (NUMBER.test(part)) return part.replace('.', ',')
  const told = inLanguage(part, language)
  if (told !== part) return told
  const own = PIECES[part]
  if (own) return of(own, language)
  let out = part
  for (const [english, others] of Object.entries(PIECES))
    out = out.replace(
      new RegExp(`(^|; )${literal(english)}: `, 'g'),
      (_, before: string) => `${before}${of(others, language)}: `,
    )
  return out
}

/** A refusal, which begins with the name of its file. */
export function refusalInLanguage(line: string, files: readonly string[], language: Language): string {
  const name = files.map((each) => `${each}: `).find((each) => line.startsWith(each)) ?? ''
  return name + inLanguage(line.slice(name.length), language)
}
