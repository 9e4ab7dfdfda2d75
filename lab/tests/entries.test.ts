// What is typed beside measurements as statements of the module: of one file, of parts, of several files; and when a fit begins.

import { describe, expect, it } from 'vitest'
import { entryNumber, isBad, measuredValue, statementsOf } from '../src/entries'
import { Measurement } from '../src/measurement'
import type { Statements } from '../src/model/exchange'
import type { Fitter } from '../src/model/fitter'

const bytes = (of: string) => new TextEncoder().encode(of)

describe('what is typed', () => {
  const nothing = new Measurement({} as Fitter, () => {}).entries

  it('becomes statements', () => {
    const entries = {
      ...nothing,
      length: '80,0 cm',
      lengthU: '1 mm',
      'column-x': 'left',
      'unit-x': 'cm',
      'column-y': 'up',
      'unit-angle': 'deg',
      rate: '30',
      gravity: '9',
    }
    expect(statementsOf('a.csv', entries)).toEqual([
      ['file', 'a.csv'],
      ['unit', 'angle=deg'],
      ['column', 'x=left'],
      ['unit', 'x=cm'],
      ['column', 'y=up'],
      ['rate', '30'],
      ['length', '0.8 0.001'],
    ])
    expect(
      statementsOf('a.csv', {
        ...nothing,
        known: 'gravity',
        gravity: '9,81',
        model: 'dry',
        'column-time': '1',
        run: '2',
      }),
    ).toEqual([
      ['file', 'a.csv'],
      ['column', 'time=1'],
      ['run', '2'],
      ['gravity', '9.81 0'],
      ['model', 'dry'],
    ])
  })

  it('is bad where a number belongs and none stands', () => {
    expect(isBad('length', 'long')).toBe(true)
    expect(isBad('column-angle', 'long')).toBe(false)
    expect(isBad('length', ' ')).toBe(false)
    expect(entryNumber('length', '65cm')).toBe(0.65)
  })

  it('has its uncertainty behind it, and one unit for both', () => {
    expect(measuredValue('0.495±0.001', 'm')).toEqual([0.495, 0.001])
    expect(measuredValue('49,5 +- 0,1 cm', 'm')).toEqual([0.495, 0.001])
    expect(measuredValue('19 g', 'kg')).toEqual([0.019, 0])
    for (const bad of ['', 'long', '1±', '1±2±3', '1 mm ± x'])
      expect([bad, measuredValue(bad, 'm')]).toEqual([bad, null])
  })

  it('parts of a rigid pendulum: a rod hangs from the pivot where its centre is not stated', () => {
    const part = { mass: '', distance: '', size: '' }
    const parts = [
      { ...part, shape: 'rod', size: '0.5±0.002', mass: '20g' },
      { ...part, shape: 'ball', distance: '0.5', mass: '50 g', size: '1cm' },
      // Not yet whole.
      { ...part, shape: 'disc', distance: '0.5' },
    ] as const
    expect(
      statementsOf('a.csv', { ...nothing, known: 'parts', parts, length: '1', bobMass: '1', bobRadius: '1' }),
    ).toEqual([
      ['file', 'a.csv'],
      ['part', 'rod 0.02 0 0.25 0.001 0.5 0.002'],
      ['part', 'ball 0.05 0 0.5 0 0.01 0'],
    ])
    expect(statementsOf('a.csv', { ...nothing, bobRadius: '12.5mm', bobMass: '66 g', wireMass: '0.4g' })).toEqual([
      ['file', 'a.csv'],
      ['bob', '0.0125 0.066'],
      ['wire', '0.0004'],
    ])
  })

  it('of several files: the common length, or one each', () => {
    const begun: unknown[] = []
    const fitter = { begin: (files: unknown, stated: unknown) => void begun.push([files, stated]), cancel: () => {} }
    const now = new Measurement(fitter as unknown as Fitter, () => {})
    now.take(['a.csv', bytes('t')], ['b.csv', bytes('t')])
    now.enter({ length: '1' })
    expect(begun.at(-1)).toMatchObject([
      [
        {
          stated: [
            ['file', 'a.csv'],
            ['length', '1 0'],
          ],
        },
        {
          stated: [
            ['file', 'b.csv'],
            ['length', '1 0'],
          ],
        },
      ],
      [
        ['file', 'a.csv'],
        ['length', '1 0'],
      ],
    ])
    now.typeLength(1, { length: '60 cm', lengthU: '1mm' })
    now.entered()
    expect(begun.at(-1)).toMatchObject([
      [
        {
          stated: [
            ['file', 'a.csv'],
            ['length', '1 0'],
          ],
        },
        {
          stated: [
            ['file', 'b.csv'],
            ['length', '0.6 0.001'],
          ],
        },
      ],
      [
        ['length', '1 0'],
        ['length', '0.6 0.001'],
      ],
    ])
    now.remove(1)
    expect(begun.at(-1)).toMatchObject([
      [{}],
      [
        ['file', 'a.csv'],
        ['length', '1 0'],
      ],
    ])
    now.typeLength(0, { length: 'x' })
    now.entered()
    now.add(['c.csv', bytes('t')])
    expect(now.bad).toBe('x')
    expect(begun.length).toBe(4)
  })

  it('is not fitted while it is bad, and the fit of a file before is not touched by a cancelled one', () => {
    const begun: Statements[] = []
    const fitter = { begin: (_: unknown, stated: Statements) => void begun.push(stated), cancel: () => {} }
    const now = new Measurement(fitter as unknown as Fitter, () => {})
    now.take(['a.csv', bytes('t')])
    now.enter({ length: 'x' })
    expect(begun.length).toBe(1)
    now.enter({ length: '1' })
    expect(begun.map((each) => each.length)).toEqual([1, 2])
    // What is entered again as it was is no reason for another fit.
    now.enter({ length: '1' })
    expect(begun.length).toBe(2)
    now.cancel()
    expect(now.phase).toBe('cancelled')
  })
})
