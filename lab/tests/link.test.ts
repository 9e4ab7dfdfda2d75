// The link: every state comes back from its hash, every bad value is named and replaced, nothing throws.

import { describe, expect, it } from 'vitest'
import { CURVE_NAMES, usualCurve } from '../src/curves'
import { readLink, writeLink } from '../src/link'
import { radians } from '../src/number'
import { DEFAULTS, RANGES, type State } from '../src/state'

const plainStates: Partial<State>[] = [
  {},
  { theta0: radians(150), t: 2.4 },
  { theta0: 3, gravity: 9.8, curves: [{ name: 'rk45', on: true }] },
  { theta0: Math.PI, length: 0.7, speed: 0.25, span: 'T' },
  { theta0: -0.1, velocity0: 2 * Math.sqrt(1.419), view: 'phase', span: 12.5 },
  { curves: [], errorAxis: 'log', energy: 'parts', quantity: 'velocity', errorUnit: 'degrees' },
  { curves: CURVE_NAMES.slice(0, 6).map(usualCurve) },
  {
    curves: [
      { name: 'rk4', argument: 0.1, on: false },
      { name: 'rk4', argument: 0.025, on: true },
    ],
  },
  { orbits: [], periods: [], periodAxis: 'linear' },
  { orbits: [{ theta0: radians(60), velocity0: -3.25 }], periods: ['bernoulli', 'series:4'] },
  { orbit: 2, view: 'phase' },
  { entry: 'lima', step: 7, view: 'derivation' },
  { periodOrder: 'error', periods: ['agm:3', 'salas-28'], view: 'period' },
  { language: 'pt-BR', theme: 'dark' },
  { view: 'handouts', handout: 'code', code: 'octave' },
  { view: 'handouts', seed: 999_999, key: true, paper: 'Letter' },
  { view: 'phase', embed: true, lock: ['L', 'g'], show: ['phase'] },
  { embed: true, lock: ['th0', 'w0', 'curves'], show: ['pendulum', 'motion', 'play'], quantity: 'velocity' },
  { hide: true, gravity: 3.71, show: ['lab', 'data'] },
]

describe('a state', () => {
  it.each(plainStates)('comes back from its link: %j', (patch) => {
    const state = { ...DEFAULTS, ...patch }
    const { state: back, faults, kept } = readLink(writeLink(state))
    expect(back).toEqual(state)
    expect(faults).toEqual([])
    expect(kept).toEqual([])
  })

  it('comes back to the last bit, whatever its numbers', () => {
    let seed = 1
    const random = () => {
      seed = (seed * 16807) % 2147483647
      return seed / 2147483647
    }
    for (let i = 0; i < 500; i++) {
      const state: State = {
        ...DEFAULTS,
        theta0: (2 * random() - 1) * Math.PI,
        velocity0: (2 * random() - 1) * 10,
        length: 0.01 + random(),
        gravity: 0.01 + 20 * random(),
        t: Number((600 * random()).toFixed(3)),
      }
      expect(readLink(writeLink(state)).state).toEqual(state)
    }
  })

  it('is written as a person would read it', () => {
    expect(writeLink({ ...DEFAULTS, t: 2.4 })).toBe(
      '#v=1&th0=150deg&L=1m&g=9.81&curves=linear,harmonic,fourier:4,rk45&t=2.4s',
    )
  })

  it('is written in at most 300 characters with six curves and five orbits', () => {
    const state: State = {
      ...DEFAULTS,
      theta0: 1.2345678901234567,
      velocity0: -1.2345678901234567,
      curves: CURVE_NAMES.slice(0, 6).map(usualCurve),
      t: 123.456,
      span: 60,
    }
    expect(writeLink(state).length).toBeLessThanOrEqual(300)
  })
})

describe('what is typed by hand', () => {
  it.each([
    ['L=70cm', 'length', 0.7],
    ['L=0,7m', 'length', 0.7],
    ['L=0.7', 'length', 0.7],
    ['th0=3rad', 'theta0', 3],
    ['th0=180', 'theta0', Math.PI],
    ['th0=-90°', 'theta0', radians(-90)],
    ['th0=%E2%88%9290deg', 'theta0', radians(-90)],
    ['g=1.62m/s2', 'gravity', 1.62],
    ['w0=90deg/s', 'velocity0', radians(90)],
    ['span=T', 'span', 'T'],
    ['lang=PT-br', 'language', 'pt-BR'],
  ])('%s is understood', (pair, name, value) => {
    const { state, faults } = readLink(`#v=1&${pair}`)
    expect(faults).toEqual([])
    expect(state[name as keyof State]).toEqual(value)
  })

  it('calls RK45 by the name of its function in SciPy, too', () => {
    expect(readLink('#curves=solve_ivp').state.curves).toEqual([{ name: 'rk45', on: true }])
  })
})

describe('a bad value', () => {
  it.each([
    ['th0=200deg', 'out-of-range', 'theta0'],
    ['th0=abc', 'not-a-number', 'theta0'],
    ['th0=', 'not-a-number', 'theta0'],
    ['L=-1m', 'out-of-range', 'length'],
    ['L=1kg', 'not-a-number', 'length'],
    ['g=1e999', 'out-of-range', 'gravity'],
    ['g=NaN', 'not-a-number', 'gravity'],
    ['t=-1', 'out-of-range', 't'],
    ['view=moon', 'not-one-of', 'view'],
    ['lang=de', 'not-one-of', 'language'],
    ['theme=pink', 'not-one-of', 'theme'],
    ['curves=linear,nothing', 'unknown', 'curves'],
    ['curves=linear:3', 'unknown', 'curves'],
    ['curves=fourier:0', 'argument', 'curves'],
    ['curves=fourier:2.5', 'argument', 'curves'],
    ['curves=rk4:x', 'not-a-number', 'curves'],
    ['curves=linear,linear', 'twice', 'curves'],
    ['curves=linear,harmonic,trigonometric,small-m,cubic,rk4,verlet', 'too-many', 'curves'],
    ['orbits=1,2,3,4,5,6,7', 'too-many', 'orbits'],
    ['orbits=400', 'out-of-range', 'orbits'],
    ['orbit=G', 'not-one-of', 'orbit'],
    ['entry=euler', 'not-one-of', 'entry'],
    ['step=0', 'not-one-of', 'step'],
    ['step=2.5', 'not-one-of', 'step'],
    ['periods=bernoulli,newton', 'not-one-of', 'periods'],
    ['periods=agm:9', 'argument', 'periods'],
    ['periods=series:3', 'argument', 'periods'],
    ['periods=linear:2', 'not-one-of', 'periods'],
    ['periods=agm:1,agm:2', 'twice', 'periods'],
    ['span=0', 'out-of-range', 'span'],
    ['seed=0', 'out-of-range', 'seed'],
    ['seed=1000000', 'out-of-range', 'seed'],
    ['seed=1.5', 'not-whole', 'seed'],
    ['seed=one', 'not-a-number', 'seed'],
    ['key=2', 'not-one-of', 'key'],
    ['embed=yes', 'not-one-of', 'embed'],
    ['lock=g,mass', 'not-one-of', 'lock'],
    ['show=phase,moon', 'not-one-of', 'show'],
    ['hide=L', 'not-one-of', 'hide'],
    ['handout=poster', 'not-one-of', 'handout'],
    ['paper=A5', 'not-one-of', 'paper'],
    ['code=fortran', 'not-one-of', 'code'],
    ['g=~', 'not-a-number', 'gravity'],
    ['g=~zzzzzzzzzzzzzzzz', 'not-a-number', 'gravity'],
  ])('%s is named and replaced by the usual one', (pair, kind, name) => {
    const { state, faults } = readLink(`#v=1&${pair}&L=0.5m`.replace('&L=0.5m', pair.startsWith('L=') ? '' : '&L=0.5m'))
    expect(faults.map((fault) => fault.kind)).toEqual([kind])
    expect(state[name as keyof State]).toEqual(DEFAULTS[name as keyof State])
    if (name !== 'length') expect(state.length).toBe(0.5)
  })

  it('does not take what is not ours out of the link', () => {
    const { kept, faults, state } = readLink('#v=1&course=FIS%20101&th0=20deg')
    expect(faults).toEqual([{ kind: 'unknown', name: 'course', value: 'FIS 101' }])
    expect(readLink(writeLink(state, kept)).kept).toEqual([['course', 'FIS 101']])
  })

  it('never makes the reader throw', () => {
    for (const hash of [
      '',
      '#',
      '#&&&',
      '#=',
      '#%',
      '#%E0%A4%A',
      '#th0',
      '#th0==',
      '#v=2',
      '#curves=,,',
      '#constructor=1',
      '#__proto__=x',
    ]) {
      expect(() => readLink(hash)).not.toThrow()
      expect(Object.keys(readLink(hash).state)).toEqual(Object.keys(DEFAULTS))
    }
  })

  it('twice is the first, and said', () => {
    const { state, faults } = readLink('#L=2m&L=3m')
    expect(state.length).toBe(2)
    expect(faults).toEqual([{ kind: 'twice', name: 'L', value: '3m' }])
  })
})

describe('what is shown, locked and hidden', () => {
  it('is the first view that is named', () => {
    expect(readLink('#embed=1&lock=g,L&show=phase').state).toMatchObject({
      embed: true,
      view: 'phase',
      lock: ['L', 'g'],
      show: ['phase'],
    })
    expect(readLink('#show=functions,period').state.view).toBe('period')
    expect(readLink('#show=pendulum,motion').state.view).toBe('lab')
    expect(readLink('#show=pendulum,phase&view=phase').state.view).toBe('phase')
  })

  it('is said where the view is not among them', () => {
    const { faults, state } = readLink('#view=period&show=phase')
    expect(faults).toEqual([{ kind: 'not-one-of', name: 'view', value: 'period', allowed: ['phase'] }])
    expect(state.view).toBe('phase')
  })

  it('is the velocity of earlier links, too', () => {
    expect(readLink('#show=velocity').state).toMatchObject({ quantity: 'velocity', show: [], view: 'lab' })
    expect(writeLink({ ...DEFAULTS, quantity: 'velocity' })).toContain('&show=velocity')
  })

  it('has g in no link, in no digit of it, and the same g to the last bit', () => {
    for (const gravity of [3.71, 1.62, 9.81, 24.79, 0.001, 1000, 274.13]) {
      const link = writeLink({ ...DEFAULTS, gravity, hide: true })
      expect(link).toMatch(/&g=~[0-9a-z]+&.*&hide=g$/)
      expect(link).not.toContain(String(gravity))
      expect(readLink(link)).toMatchObject({ state: { gravity, hide: true }, faults: [] })
      // Taking the word away does not show it.
      expect(readLink(link.replace('&hide=g', '')).state).toMatchObject({ gravity, hide: true })
      expect(readLink(link.replace('&hide=g', '').replace('~', '%7E')).state).toMatchObject({ gravity, hide: true })
      expect(readLink(link.replace('&hide=g', '&hide=0')).state).toMatchObject({ gravity, hide: true })
    }
    expect(readLink('#hide=g&g=3.71').state).toMatchObject({ gravity: 3.71, hide: true })
  })

  it('keeps to views and spans that do not say g', () => {
    const { state, faults } = readLink('#hide=g&g=3.71&view=period&span=T')
    expect(faults).toEqual([{ kind: 'not-one-of', name: 'view', value: 'period', allowed: ['lab', 'data'] }])
    expect(state).toMatchObject({ view: 'lab', span: DEFAULTS.span })
    const closed = readLink('#hide=g&g=3.71&show=functions')
    expect(closed.faults.map(({ kind }) => kind)).toEqual(['not-one-of'])
    expect(closed.state).toMatchObject({ view: 'lab', show: [], hide: true })
    // A part that says g alone would be an empty page.
    for (const part of ['energy', 'facts', 'facts,energy']) {
      const { faults, state } = readLink(`#embed=1&hide=g&g=3.71&show=${part}`)
      expect(faults).toMatchObject([{ kind: 'not-one-of', name: 'show', value: part }])
      expect(state).toMatchObject({ view: 'lab', show: [], hide: true })
    }
    expect(readLink('#embed=1&hide=g&g=3.71&show=energy,motion')).toMatchObject({ faults: [], state: { view: 'lab' } })
  })
})

it('the ranges hold the defaults', () => {
  for (const [name, { least, most }] of Object.entries(RANGES)) {
    const value = DEFAULTS[name as keyof State]
    if (typeof value === 'number') expect(value >= least && value <= most).toBe(true)
  }
})
