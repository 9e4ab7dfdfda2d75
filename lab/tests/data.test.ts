// What the view Data computes is what the command line prints, to 1e-12: python/tests/test_lab_files.py holds the command to the
// same files. Fits of one record and of several, parts of a rigid pendulum, corrections; g from a period that was timed.

import { readFile } from 'node:fs/promises'
import { describe, expect, it } from 'vitest'
import { lawOf, smallPeriod } from '../src/against-swing'
import type { Entries } from '../src/entries'
import { Measurement } from '../src/measurement'
import { completedModel, openModel } from '../src/model'
import { type AskedFile, measure, type Result, type Statements, type Told } from '../src/model/fit-protocol'
import type { Fitter } from '../src/model/fitter'
import { degrees, radians } from '../src/number'
import { EXAMPLE, isBadTiming, Timing, type TimingEntries, timingStatements } from '../src/timing'
import fits from './fits.json'
import periods from './gravity.json'
import { modules, startedPeriod } from './measuring'

const text = (name: string) => readFile(new URL(name, import.meta.url), 'utf8')

/** Parts of an uncertainty. What a model adds to one is a difference of two fits, of which one may be hardly determined: a tenth counts. */
const UNCERTAIN = new Set(['u', 'expanded', 'model'])

/** Largest difference of what both hold, against the wanted one or a thousandth; texts must be the same. */
function difference(found: unknown, wanted: unknown): number {
  if (typeof wanted === 'number' && typeof found === 'number')
    return Math.abs(found - wanted) / Math.max(1e-3, Math.abs(wanted))
  if (typeof wanted !== 'object' || wanted === null || typeof found !== 'object' || found === null)
    return Object.is(found, wanted) ? 0 : Number.POSITIVE_INFINITY
  const each = (of: object, key: string) => (of as Record<string, unknown>)[key]
  const of = (key: string) => difference(each(found, key), each(wanted, key)) * (UNCERTAIN.has(key) ? 0.1 : 1)
  return Object.keys(wanted).reduce((most, key) => Math.max(most, of(key)), 0)
}

type Case = (typeof fits)[number]

/** As the page fits files with what is typed beside them. */
async function fitted({ files, typed, lengths }: Case) {
  const begun: { files: readonly AskedFile[]; stated: Statements }[] = []
  const fitter = {
    begin: (asked: readonly AskedFile[], stated: Statements) => void begun.push({ files: asked, stated }),
    cancel: () => {},
  }
  const now = new Measurement(fitter as unknown as Fitter, () => {})
  now.enter(typed as Partial<Entries>)
  const read = files.map(async ({ name, text: own }) => {
    return [name, new TextEncoder().encode(own ?? (await text(name)))] as const
  })
  now.take(...(await Promise.all(read)))
  lengths?.forEach(([length = '', lengthU = ''], i) => {
    now.typeLength(i, { length, lengthU })
    now.entered()
  })
  const all: Told[] = []
  const last = begun.at(-1)
  if (last) await measure({ modules, ...last }, (told) => all.push(told))
  const end = all.at(-1)
  if (end?.kind !== 'fitted') throw new Error(JSON.stringify(end))
  const quantities = all.flatMap((told) => (told.kind === 'read' ? [told.reading.measured] : []))
  return { ...end, quantities }
}

describe.each(fits.map((each) => [each.name, each] as const))('%s', (_, each) => {
  it('has the numbers of the command line to 1e-12', async () => {
    const { results, joint, quantities } = await fitted(each)
    const { kind, records, grades, stands, ...wanted } = each.answer as Record<string, unknown>
    const found = joint ? joint.together : results[0]?.fit
    const told = joint ?? results[0]
    expect({ grades: told?.grades, stands: told?.stands }).toEqual({ grades, stands })
    for (const [key, value] of Object.entries(wanted)) {
      // The command says which kind it is where the module has no such value.
      if (joint && key === 'length_given') continue
      expect([key, difference(found?.[key as keyof typeof found], value) < 1e-12]).toEqual([key, true])
    }
    ;((records ?? []) as Record<string, unknown>[]).forEach((record, i) => {
      expect(difference(results[i]?.fit, record)).toBeLessThan(1e-12)
    })
    expect(kind).toBe(joint ? (each.lengths ? 'lengths' : 'runs') : quantities[0])
  })
})

describe('story 19: Q = 100 from 100 degrees', () => {
  const named = (name: string) => fits.find((each) => each.name.startsWith(name)) as Case
  const T0 = 2 * Math.PI * Math.sqrt(0.8 / 9.81)

  it.each(['a light gate', 'a record'])('%s gives T0 within 2 u, and linear friction', async (name) => {
    const [result] = (await fitted(named(name))).results
    const { value, u } = smallPeriod(result?.fit.omega0 ?? { value: 0, u: 0 })
    expect(Math.abs(value - T0)).toBeLessThan(2 * u)
    expect(u).toBeLessThan(1e-3 * T0)
    expect(result?.fit.model).toBe('linear')
  })

  it('its periods against the swing lie on the exact law, and not on that of small swings', async () => {
    const [result] = (await fitted(named('a light gate'))).results
    await openModel()
    const model = await completedModel()
    if (!result) throw new Error('no result')
    expect(Math.abs(degrees(result.swings[0] as number) - 100)).toBeLessThan(5)
    const law = lawOf(model, result.swings, result)
    if (!law) throw new Error('no law')
    // The curve at a swing of the record is what was fitted there.
    const [first, last] = [law.y.at(-1) as number, law.y[0] as number]
    expect(Math.abs(first - (result.fitted[0] as number))).toBeLessThan(1e-9)
    expect(Math.abs(last - (result.fitted.at(-1) as number))).toBeLessThan(1e-9)
    expect(first / smallPeriod(result.fit.omega0).value).toBeGreaterThan(1.2)
  })
})

describe('story 18: a period that was timed', () => {
  const of = (typed: Partial<TimingEntries>): TimingEntries => ({ ...new Timing(() => {}).entries, ...typed })

  it.each(periods.map((each) => [each.command.join(' '), each] as const))(
    '%s: the numbers of the command',
    async (_, each) => {
      const { found, normal } = (await startedPeriod()).gravity(timingStatements(of(each.typed)))
      const { g, budget, g_small_swings: small, normal_g: place = null } = each.answer as Record<string, unknown>
      expect(difference(normal, place)).toBeLessThan(1e-12)
      if (g === undefined) return expect(found).toBe(null)
      expect(difference(found?.g, g)).toBeLessThan(1e-12)
      expect(difference(found?.small_swings, small)).toBeLessThan(1e-12)
      const parts = Object.fromEntries((found?.budget ?? []).map(({ source, u }) => [source, u]))
      expect(difference(parts, budget)).toBeLessThan(1e-12)
    },
  )

  it('30°: 9.810, where the formula of small swings gives 9.477', async () => {
    const timing = new Timing(() => {})
    timing.enter({ ...EXAMPLE, time: '20.409902' })
    timing.begin(await startedPeriod())
    expect(timing.answer?.found?.g.value.toFixed(3)).toBe('9.810')
    expect(timing.answer?.found?.small_swings.toFixed(3)).toBe('9.477')
    // The curve goes through both.
    expect(timing.curve?.g[0]).toBe(timing.answer?.found?.small_swings)
    const at = timing.curve?.swing.findIndex((each) => Math.abs(each - radians(30)) < 1e-12) ?? -1
    expect(Math.abs((timing.curve?.g[at] as number) - (timing.answer?.found?.g.value as number))).toBeLessThan(1e-12)
  })

  it('Londrina has 9.787, not 9.81', async () => {
    const { normal, found } = (await startedPeriod()).gravity(
      timingStatements(of({ latitude: '−23,3', height: '585' })),
    )
    expect([normal?.toFixed(3), found]).toEqual(['9.787', null])
  })

  it('a value out of its range is a refusal of one line, and no number is none', async () => {
    const timing = new Timing(() => {})
    timing.begin(await startedPeriod())
    timing.enter({ time: '2', length: '1', swing: '200' })
    expect(timing.message).toContain('must be greater than 0 and less than 3.14159')
    expect(timing.answer).toBe(null)
    timing.enter({ swing: 'wide' })
    expect([timing.bad, timing.message]).toEqual(['wide', ''])
    timing.enter({ swing: '20', swings: '2.5' })
    expect(timing.bad).toBe('2.5')
    expect(isBadTiming('swings', '-3')).toBe(true)
    timing.enter({ swings: '1' })
    expect(timing.answer?.found?.g.value).toBeGreaterThan(9.9)
  })
})

describe('what is shown was found in the files that are there', () => {
  const told: ((told: Told) => void)[] = []
  let ended = 0
  const fitter = {
    begin: (_files: unknown, _stated: unknown, listen: (told: Told) => void) => void told.push(listen),
    cancel: () => {
      ended++
    },
  }
  const begun = () => {
    const now = new Measurement(fitter as unknown as Fitter, () => {})
    now.take(['a.csv', new Uint8Array()])
    told.at(-1)?.({ kind: 'fitted', results: [{} as Result], joint: null })
    expect([now.phase, now.result]).toEqual(['fitted', {}])
    return now
  }

  it('nothing of another file stands beside one that waits for a number', () => {
    const now = begun()
    // A number that is being mended leaves what was found.
    now.enter({ length: 'abc' })
    expect(now.result).toEqual({})
    const before = ended
    now.take(['b.csv', new Uint8Array()])
    expect([now.phase, now.file?.name, now.result, now.reading]).toEqual(['empty', 'b.csv', null, null])
    expect(ended).toBeGreaterThan(before)
    now.enter({ length: '1' })
    expect(now.phase).toBe('reading')
  })

  it('what cannot be read is named, and a fit that runs is ended', () => {
    const now = begun()
    now.enter({ length: '1' })
    const before = ended
    now.fail('folder: not found')
    expect([now.phase, now.message]).toEqual(['failed', 'folder: not found'])
    expect(ended).toBeGreaterThan(before)
  })
})
