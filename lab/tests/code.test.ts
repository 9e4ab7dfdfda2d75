// The texts of code: those of tests/snippets.json are what the page gives, so that who runs them (python/tests/test_snippets.py)
// runs the page's own. `npx vitest run tests/code.test.ts -u` writes the file again.

import { beforeAll, describe, expect, it } from 'vitest'
import { codeText, losesDigits, TIMES } from '../src/handouts/code'
import { enHandouts } from '../src/language/en-handouts'
import { esHandouts } from '../src/language/es-handouts'
import { ptBRHandouts } from '../src/language/pt-BR-handouts'
import { type Model, openModel } from '../src/model'
import { radians } from '../src/number'
import { CODES, type Code } from '../src/state'

let model: Model
beforeAll(async () => {
  model = await openModel()
})

const STARTS = [
  { theta0: radians(150), velocity0: 0, length: 1, gravity: 9.81 },
  { theta0: radians(20), velocity0: 0, length: 0.7, gravity: 9.81 },
  { theta0: radians(-90), velocity0: 0, length: 1, gravity: 9.81 },
  { theta0: radians(179), velocity0: 0, length: 1, gravity: 9.81 },
  { theta0: 0.1, velocity0: -0.2, length: 2, gravity: 1.62 },
  { theta0: 0, velocity0: 3, length: 1, gravity: 9.81 },
  { theta0: -2.5, velocity0: -1e-7, length: 0.25, gravity: 24.79 },
  { theta0: 0.6, velocity0: 3, length: 1, gravity: 1.69 },
  { theta0: 0, velocity0: 7.5, length: 1, gravity: 9.81 },
  { theta0: -2, velocity0: -9, length: 0.5, gravity: 9.81 },
  { theta0: 0, velocity0: 2, length: 1, gravity: 1 },
  { theta0: radians(90), velocity0: -Math.SQRT2, length: 1, gravity: 1 },
  { theta0: 0, velocity0: 0, length: 1, gravity: 9.81 },
  { theta0: Math.PI, velocity0: 0, length: 1, gravity: 9.81 },
] as const

function texts(words: typeof enHandouts) {
  return STARTS.map((start) => {
    const motion = model.motion(start)
    const each = CODES.map((code) => [code, codeText(code, motion, words.comments).split('\n').slice(0, -1)] as const)
    return { start, kind: motion.regime, times: TIMES, texts: Object.fromEntries(each) as Record<Code, string[]> }
  })
}

it('are those of snippets.json', async () => {
  await expect(`${JSON.stringify(texts(enHandouts), null, 1)}\n`).toMatchFileSnapshot('snippets.json')
})

it('are for every kind of motion', () => {
  const kinds = new Set(texts(enHandouts).map(({ kind }) => kind))
  expect([...kinds].sort()).toEqual(['libration', 'rest', 'rotation', 'separatrix'])
})

describe.each([
  ['pt-BR', ptBRHandouts],
  ['es', esHandouts],
] as const)('in %s', (_, words) => {
  /** A text without what is said in it. */
  const bare = (text: readonly string[]) => text.map((line) => line.replace(/\s*(?:#|%|\(\*)(?!\w).*$/, ''))

  it('differ from English in their comments alone', () => {
    const [mine, english] = [texts(words as typeof enHandouts), texts(enHandouts)]
    mine.forEach(({ texts: all }, i) => {
      for (const code of CODES) {
        expect(bare(all[code])).toEqual(bare(english[i]?.texts[code] ?? []))
        expect(all[code]).not.toEqual(english[i]?.texts[code])
      }
    })
  })
})

describe('Mathematica, which nobody runs here', () => {
  // By eye against its documentation: EllipticK[m], EllipticF[phi, m], JacobiSN[u, m], JacobiAmplitude[u, m], ArcTan[x, y].
  it('has brackets that close, names that it knows, and numbers with a point', () => {
    const KNOWN =
      /^(Sqrt|Sin|ArcSin|ArcTan|ArcSinh|Tan|Sinh|Cosh|Abs|Infinity|Print|Do|Degree|EllipticK|EllipticF|JacobiSN|JacobiCN|JacobiDN|JacobiAmplitude)$/
    for (const { texts: all } of texts(enHandouts)) {
      const code = all.mathematica
        .join('\n')
        .replace(/\(\*.*?\*\)/gs, '')
        .replace(/"[^"]*"/g, '')
      let open = ''
      for (const mark of code.match(/[()[\]{}]/g) ?? []) {
        if ('([{'.includes(mark)) open += mark
        else {
          expect(open.at(-1)).toBe('([{'[')]}'.indexOf(mark)])
          open = open.slice(0, -1)
        }
      }
      expect(open).toBe('')
      for (const [name] of code.matchAll(/\b[A-Z][A-Za-z]+/g)) expect(name).toMatch(KNOWN)
      for (const [, value] of code.matchAll(/\b(?:theta0|velocity0|length|gravity) = ([^;]*);/g))
        expect(value).toMatch(/^-?\d+\.\d*(\*\^-?\d+)?( Degree)?$/)
    }
  })
})

it('say where SciPy and Octave lose digits', () => {
  const near = model.motion({ theta0: radians(179.9999), velocity0: 0, length: 1, gravity: 9.81 })
  expect(CODES.filter((code) => losesDigits(code, near))).toEqual(['scipy', 'octave'])
  expect(CODES.filter((code) => losesDigits(code, model.motion(STARTS[0])))).toEqual([])
})
