// Sentences of the reader and the fit in Portuguese and Spanish: every pattern of the table, and the refusals that are met first.

import { describe, expect, it } from 'vitest'
import table from '../../python/libration/measurement/sentences.json'
import { inLanguage, refusalInLanguage } from '../src/language/sentences'
import type { Statements } from '../src/model/exchange'
import { Measuring } from './measuring'

const groups: Readonly<Record<string, Readonly<Record<string, readonly string[]>>>> = table.sentences

describe('the table', () => {
  it.each(Object.keys(groups))('%s: every pattern is known in both languages, with its places', (group) => {
    for (const [english, others] of Object.entries(groups[group] ?? {})) {
      const sentence = english.replaceAll('{}', '7')
      for (const [i, language] of (['pt-BR', 'es'] as const).entries()) {
        expect([english, inLanguage(sentence, language)]).toEqual([english, others[i]?.replaceAll(/\{\d*\}/g, '7')])
        expect(others[i]).not.toBe(english)
      }
      expect(inLanguage(sentence, 'en')).toBe(sentence)
    }
  })

  it('numbers have a decimal comma, names stay, and what is not known stays English', () => {
    expect(inLanguage('the record holds 1.2 periods: friction and rest are hardly determined', 'pt-BR')).toContain(
      '1,2',
    )
    expect(inLanguage('Column "a.b" does not move: left out.', 'es')).toContain('"a.b"')
    expect(inLanguage('what nobody says', 'es')).toBe('what nobody says')
  })
})

describe('refusals of the module', () => {
  const COLUMNS = 't,theta,phi\n0,10,1\n0.1,9,2\n0.2,7,4\n'
  const FLAT = `t [s],theta [deg]\n${Array.from({ length: 20 }, (_, i) => `${i / 10},1`).join('\n')}`
  it.each<readonly [string, string, Statements, string, string]>([
    ['nothing', '', [], 'está vazio', 'está vacío'],
    ['no numbers', 'a\nb\nc\n', [], 'não contém nenhuma linha de números', 'no contiene ninguna fila de números'],
    ['two angles', COLUMNS, [], 'qual coluna é o ângulo?', '¿qué columna es el ángulo?'],
    [
      'no time',
      'angle [deg]\n1\n2\n3\n2\n1\n0\n-1\n-2\n-1\n0\n',
      [],
      'quantas amostras por segundo?',
      '¿cuántas muestras por segundo?',
    ],
    [
      'an unknown unit',
      COLUMNS,
      [
        ['column', 'angle=theta'],
        ['unit', 'angle=bananas'],
      ],
      'deve ser',
      'debe ser',
    ],
    ['an unknown column', COLUMNS, [['column', 'angle=psi']], 'não é nenhuma coluna', 'no es ninguna columna'],
    ['too few', 't [s],theta [deg]\n0,10\n0.1,9\n0.2,7\n0.3,4\n', [], 'pelo menos', 'al menos'],
    ['nothing moves', FLAT, [], 'coluna', 'columna'],
    ['an archive', 'PK\u0003\u0004', [], 'compactado', 'comprimido'],
    ['a page of HTML', '<!DOCTYPE html><p>1', [], 'página', 'página'],
    ['a PDF', '%PDF-1.7', [], 'dados brutos', 'datos brutos'],
    ['JSON', '{"t": [0, 1]}', [], 'escreva', 'escriba'],
  ])('%s', async (_, file, stated, portuguese, spanish) => {
    const line = (await Measuring.start()).refusal(new TextEncoder().encode(file), [['file', 'swing.csv'], ...stated])
    expect(line).not.toBe('')
    const told = (['pt-BR', 'es'] as const).map((language) => refusalInLanguage(line, ['swing.csv'], language))
    expect(told[0], line).toContain(portuguese)
    expect(told[1], line).toContain(spanish)
  })
})
