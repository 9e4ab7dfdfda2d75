// The catalogues: nothing missing, nothing left in English, placeholders kept; numbers as each language writes them.

import { describe, expect, it } from 'vitest'
import { nearestLanguage, Words } from '../src/language'
import '../src/language/later'
import '../src/language/data'
import '../src/language/handouts'
import '../src/language/save'
import '../src/language/derivation'
import '../src/language/friction'
import '../src/language/springs'
import { filled, pieces, plain } from '../src/language/rich'
import { LANGUAGES } from '../src/state'

type Leaf = readonly [string, string]

function leaves(value: unknown, path = ''): Leaf[] {
  if (typeof value === 'string') return [[path, value]]
  return Object.entries(value as object).flatMap(([key, each]) => leaves(each, `${path}/${key}`))
}

const [en, ptBR, es] = [new Words('en').say, new Words('pt-BR').say, new Words('es').say]
const english = leaves(en)
const placeholders = (text: string) =>
  [...text.matchAll(/\{([a-zA-Z]\w*)\}/g)]
    .map((match) => match[1])
    .filter((name) => !/^(top|alto|topo)$/.test(name ?? ''))
    .sort()

// Symbols, names, numbers, and words that are the same in both languages.
const SAME = new Set([
  'Total',
  'amplitude',
  'log',
  'Taylor',
  'RK45',
  'RK4',
  'Verlet',
  'Euler',
  'Euler–Cromer',
  'CSV',
  'Link',
  'Error',
  'Fourier _N_',
  'Lab',
  'linear',
  'Latitude',
  'Duffing',
  'Salas 2019 (35)',
  'Esc',
  'rad/s',
  'Shift + ← →',
  'Page ↑ ↓',
  'Home End',
  'sin _θ_ = _θ_ − 40_θ_³/243',
])
const same = (text: string) =>
  SAME.has(text) || !/[a-z]{3}/i.test(plain(text).replace(/[{][^}]*[}]/g, '')) || /^sin² |^_/.test(text)

describe.each([
  ['pt-BR', ptBR],
  ['es', es],
] as const)('%s', (_, catalogue) => {
  const texts = leaves(catalogue)

  it('has the keys of English', () => {
    expect(texts.map(([key]) => key)).toEqual(english.map(([key]) => key))
  })

  it('keeps every placeholder', () => {
    texts.forEach(([key, text], i) => {
      expect([key, placeholders(text)]).toEqual([key, placeholders(english[i]?.[1] ?? '')])
    })
  })

  it('leaves nothing in English', () => {
    const left = texts.filter(
      ([key, text], i) =>
        text === english[i]?.[1] && !same(text) && !key.startsWith('/functionNames') && !key.startsWith('/units'),
    )
    expect(left).toEqual([])
  })

  it('has no blanks at the ends, no empty text but where English has one', () => {
    texts.forEach(([key, text], i) => {
      expect([key, text]).toEqual([key, text.trim()])
      if (english[i]?.[1] !== '') expect([key, text === '']).toEqual([key, false])
    })
  })

  it('says that it is machine-assisted', () => expect(catalogue.machineAssisted).not.toBe(''))
})

describe('numbers', () => {
  it.each([
    ['en', '9.81', '−79.3', '0.164'],
    ['pt-BR', '9,81', '−79,3', '0,164'],
    ['es', '9,81', '−79,3', '0,164'],
  ] as const)('in %s', (language, gravity, angle, error) => {
    const words = new Words(language)
    expect(words.given(9.81)).toBe(gravity)
    expect(words.fixed(-79.34, 1)).toBe(angle)
    expect(words.significant(0.16432)).toBe(error)
    expect(words.typed(9.81)).toBe(gravity)
    expect(words.fixed(-0.001, 1)).toBe(words.fixed(0, 1))
    expect(words.fixed(12345.6, 1)).toBe(language === 'en' ? '12345.6' : '12345,6')
  })

  it('with three digits, whatever their size', () => {
    const words = new Words('en')
    expect([200, 19.79, 9.999, 99.96, 0.0003, 0].map((value) => words.significant(value))).toEqual([
      '200',
      '19.8',
      '10.0',
      '100',
      '0.000300',
      '0',
    ])
    expect(words.significant(1.234e-9)).toBe('1.23\u00a0×\u00a010^{−9}')
    expect(plain(words.significant(1.234e-9))).toBe('1.23\u00a0×\u00a010⁻⁹')
  })

  it('functions by their names', () => {
    const text = '_m_ = sin²(θ/2), arctan'
    expect(LANGUAGES.map((each) => new Words(each).formula(text))).toEqual([
      '_m_ = sin²(θ/2), arctan',
      '_m_ = sen²(θ/2), arctg',
      '_m_ = sen²(θ/2), arctan',
    ])
  })
})

describe('markup', () => {
  it('is bold, symbol, index and power', () => {
    expect(pieces("*a* _T_{0} _θ'_ _u''_ x^{2}").map(({ kind, text }) => [kind, text])).toEqual([
      ['bold', 'a'],
      ['text', ' '],
      ['symbol', 'T'],
      ['index', '0'],
      ['text', ' '],
      ['dotted', 'θ'],
      ['text', ' '],
      ['twice', 'u'],
      ['text', ' x'],
      ['power', '2'],
    ])
  })

  it('is not in what is spoken', () => expect(plain('*{a}* _T_{0} longer')).toBe('{a} T0 longer'))

  it('of every text is closed', () => {
    for (const [key, text] of [...english, ...leaves(ptBR), ...leaves(es)])
      expect([key, /[*]|(?<![{\w])_(?!θ_³)/.test(plain(text))]).toEqual([key, false])
  })

  it('fills names and shows those it has no value for', () => expect(filled('{a} {b}', { a: 1 })).toBe('1 {b}'))
})

it('the language of a reader is the nearest there is', () => {
  expect([['pt-PT'], ['es-CO', 'en'], ['de', 'es'], ['de'], []].map((wanted) => nearestLanguage(wanted))).toEqual([
    'pt-BR',
    'es',
    'es',
    'en',
    'en',
  ])
})
