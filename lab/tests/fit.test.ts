// The module of the fit: the numbers of the command line on one record, its messages, and what a worker tells of a measurement.

import { readFile } from 'node:fs/promises'
import { describe, expect, it } from 'vitest'
import type { Statements } from '../src/model/exchange'
import { type Modules, measure, type Told } from '../src/model/fit-protocol'
import { degrees } from '../src/number'
import { archive } from './archive'
import { Measuring, modules } from './measuring'

const text = (name: string) => readFile(new URL(name, import.meta.url), 'utf8')
const bytes = (of: string) => new TextEncoder().encode(of)
/** 70°, 0.8 m, 600 samples with a scatter of 0.01 rad; python/tests/test_fit_page.py holds the command line to the same numbers. */
const RECORD = 'record-70deg.csv'
const STATED: Statements = [
  ['file', RECORD],
  ['length', '0.8 0.001'],
]

/** Largest difference of numbers at the same place, against the wanted one or a thousandth; texts must be the same. */
function difference(found: unknown, wanted: unknown): number {
  if (typeof wanted === 'number' && typeof found === 'number')
    return Math.abs(found - wanted) / Math.max(1e-3, Math.abs(wanted))
  if (typeof wanted !== 'object' || wanted === null || typeof found !== 'object' || found === null)
    return Object.is(found, wanted) ? 0 : Number.POSITIVE_INFINITY
  const keys = Object.keys(wanted)
  if (Object.keys(found).length !== keys.length) return Number.POSITIVE_INFINITY
  const each = (of: object, key: string) => (of as Record<string, unknown>)[key]
  return keys.reduce((most, key) => Math.max(most, difference(each(found, key), each(wanted, key))), 0)
}

describe('the record of 70°', () => {
  /** Of `libration fit record-70deg.csv --length 0.800±0.001 --json`. */
  const wanted = async () => JSON.parse(await text('record-70deg.json')) as Record<string, unknown>
  const KEYS = [
    'omega0',
    'g',
    'length',
    'offset',
    'friction',
    'swing',
    'verdicts',
    'window',
    'samples',
    'ladder',
    'budget',
  ] as const

  it('has the numbers of the command line to 1e-12', async () => {
    const fits = await Measuring.start()
    const line = await wanted()
    const read = fits.read(bytes(await text(RECORD)), STATED)
    expect(read.understood).toEqual(line.understood)
    expect(read.measured).toBe(line.kind)
    const { fit, grades, stands } = fits.fit(STATED)
    expect({ grades, stands, model: fit.model }).toEqual({
      grades: line.grades,
      stands: line.stands,
      model: line.model,
    })
    for (const key of KEYS) expect([key, difference(fit[key], line[key]) < 1e-12]).toEqual([key, true])
    expect(difference(fit.rms, line.rms)).toBeLessThan(1e-12)
  })

  it('has other numbers where a time is another one', async () => {
    const fits = await Measuring.start()
    fits.read(bytes((await text(RECORD)).replace('0.1,', '0.1001,')), STATED)
    expect(difference(fits.fit(STATED).fit.g, (await wanted()).g)).toBeGreaterThan(1e-9)
  })

  it('gives g = 9.810 ± 0.012', async () => {
    const fits = await Measuring.start()
    fits.read(bytes(await text(RECORD)), STATED)
    const { g } = fits.fit(STATED).fit
    expect(g?.value.toFixed(3)).toBe('9.810')
    expect(g?.u.toFixed(3)).toBe('0.012')
  })

  it('gives the length from g', async () => {
    const fits = await Measuring.start()
    const stated: Statements = [['gravity', '9.81 0.0001']]
    fits.read(bytes(await text(RECORD)), stated)
    const { length, length_given: given } = fits.fit(stated).fit
    expect(given).toBe(false)
    expect(Math.abs((length?.value ?? 0) - 0.8)).toBeLessThan(3e-4)
  })
})

describe('refusals are the lines of the command', () => {
  const refusal = async (of: string | Uint8Array, stated: Statements) =>
    (await Measuring.start()).refusal(typeof of === 'string' ? bytes(of) : of, stated)

  /** Each with the line of `libration fit NAME`, to which python/tests/test_fit_page.py holds the command. */
  it('malformed files', async () => {
    const files: readonly { name: string; text?: string; base64?: string; line: string }[] = JSON.parse(
      await text('malformed.json'),
    )
    expect(files.length).toBeGreaterThan(15)
    for (const { name, text, base64, line } of files) {
      const content = base64 === undefined ? bytes(text ?? '') : new Uint8Array(Buffer.from(base64, 'base64'))
      expect(await refusal(content, [['file', name]]), name).toBe(line)
    }
  })

  it('not periods alone: each begins where the one above ends', async () => {
    const fits = await Measuring.start()
    const read = fits.read(bytes('period (s)\n1.80\n1.81\n1.79\n1.80\n'), [['file', 'periods.csv']])
    expect([read.kind, [...read.y]]).toEqual(['gate', [1.8, 1.81, 1.79, 1.8]])
    expect(Array.from(read.x, (t) => t.toFixed(2))).toEqual(['0.00', '1.80', '3.61', '5.40'])
    expect(read.understood).toContain('No column of times: each period begins where the one above ends.')
  })

  it('an old workbook, which the command reads', async () => {
    const old = new Uint8Array([0xd0, 0xcf, 0x11, 0xe0, 0xa1, 0xb1, 0x1a, 0xe1, 0, 0])
    const line = 'a.xls: an old workbook (XLS); save it as XLSX or CSV and give that'
    expect(await refusal(old, [['file', 'a.xls']])).toBe(line)
  })

  it('both length and gravity: g/L is all that a motion holds', async () => {
    const both: Statements = [...STATED, ['gravity', '9.81 0']]
    expect(await refusal(await text(RECORD), both)).toContain('the motion holds g/L alone')
  })

  it('a role and a number that are none', async () => {
    expect(await refusal('', [['column', 'colour=red']])).toContain('must be ROLE=NAME')
    expect(await refusal('', [['rate', 'fast']])).toBe('rate = "fast": is not understood')
  })
})

describe('story 16: archives and workbooks are read as the table in them', () => {
  const swing = Array.from({ length: 40 }, (_, i) => [0.1 * i, 1.5 * Math.cos(0.35 * i) * 0.99 ** i] as const)
  const table = (between: string, point: string) =>
    [['"Time (s)"', '"Gyroscope x (rad/s)"'], ...swing.map((row) => row.map((x) => x.toFixed(6).replace('.', point)))]
      .map((row) => row.join(between))
      .join('\n')
  const device = '"property","value"\n"version","1"\n'

  it.each([
    [',', '.'],
    [';', ','],
    ['\t', '.'],
  ])('phyphox, columns by %j and decimals by %j', async (between, point) => {
    const fits = await Measuring.start()
    const stated: Statements = [['file', 'a.zip']]
    const { understood, ...alone } = fits.read(bytes(table(between, point)), stated)
    const packed = archive({ 'Gyroscope.csv': table(between, point), 'meta/device.csv': device })
    expect(fits.read(packed, stated)).toEqual({ understood, ...alone })
    expect(alone.measured).toBe('velocity')
    expect([...alone.y]).toEqual(swing.map(([, velocity]) => Number(velocity.toFixed(6))))
    // Of two files that with the better quantity.
    const two = { 'Accelerometer.csv': 'Time (s),Linear Acceleration x (m/s^2)\n0,1\n1,2\n2,1\n' }
    const read = fits.read(archive({ ...two, 'Gyroscope.csv': table(between, point) }), stated)
    expect(read.understood[0]).toBe('Of the files, Gyroscope.csv is read.')
    expect(read.y).toEqual(alone.y)
  })

  it('a workbook', async () => {
    const fits = await Measuring.start()
    const cell = (place: string, value: number) => `<c r="${place}"><v>${value}</v></c>`
    const rows = swing.map(
      ([t, angle], i) => `<row r="${i + 2}">${cell(`A${i + 2}`, t)}${cell(`B${i + 2}`, angle)}</row>`,
    )
    const text = (place: string, is: string) => `<c r="${place}" t="inlineStr"><is><t>${is}</t></is></c>`
    const head = `<row r="1">${text('A1', 't (s)')}${text('B1', 'theta (rad)')}</row>`
    const sheet = `<worksheet><sheetData>${head}${rows.join('')}</sheetData></worksheet>`
    const { measured, y } = fits.read(
      archive({ 'xl/workbook.xml': '<workbook/>', 'xl/worksheets/sheet1.xml': sheet }),
      [['file', 'a.xlsx']],
    )
    expect(measured).toBe('angle')
    expect([...y]).toEqual(swing.map(([, angle]) => angle))
  })

  it('a spoiled byte is found', async () => {
    const fits = await Measuring.start()
    const packed = archive({ 'Gyroscope.csv': table(',', '.') })
    packed[packed.length - 100] = (packed[packed.length - 100] as number) ^ 1
    expect(() => fits.read(packed, [['file', 'a.zip']])).toThrow('a.zip: a ZIP archive that cannot be unpacked: ')
  })
})

describe('what the worker tells', () => {
  const told = async (of: string, stated: Statements) => {
    const all: Told[] = []
    await measure({ modules, files: [{ bytes: bytes(of), stated }], stated }, (each) => all.push(each))
    return all
  }

  it('what was read, then every step, then the result', async () => {
    const all = await told(await text(RECORD), STATED)
    const steps = all.filter((each) => each.kind === 'step')
    expect(all.map(({ kind }) => kind)).toEqual(['read', ...steps.map(() => 'step'), 'fitted'])
    expect(steps.map((each) => each.step)).toEqual(Array.from({ length: steps[0]?.of ?? 0 }, (_, i) => i))
    const last = all.at(-1)
    if (last?.kind !== 'fitted') throw new Error('no result')
    const [result] = last.results
    if (!result) throw new Error('no result')
    const { x, measured, fitted, residual } = result
    expect([x.length, measured.length, fitted.length, residual.length]).toEqual([600, 600, 600, 600])
    expect(
      Math.max(...fitted.map((each, i) => Math.abs(each + (residual[i] as number) - (measured[i] as number)))),
    ).toBeLessThan(1e-15)
  })

  it('a refusal, once and last', async () => {
    expect(await told('', [['file', 'a.csv']])).toEqual([{ kind: 'refused', message: 'a.csv: is empty' }])
  })

  it('a failure where there is no module', async () => {
    const all: Told[] = []
    const none = {} as Modules
    await measure({ modules: none, files: [], stated: [] }, (each) => all.push(each))
    expect(all.map(({ kind }) => kind)).toEqual(['failed'])
  })
})

describe('several records', () => {
  /** The record with its times stretched: of a pendulum so many times as long. */
  const stretched = async (times: number, first: Statements) => {
    const [head = '', ...rows] = (await text(RECORD)).trim().split('\n')
    const row = (each: string) => {
      const [t = '', angle = ''] = each.split(',')
      return `${Number(t) * Math.sqrt(times)},${angle}`
    }
    return { bytes: bytes([head, ...rows.map(row)].join('\n')), stated: first }
  }
  const asked = async (lengths: readonly number[]) => {
    const files = await Promise.all(
      [0.8, 1, 1.25].map((times, i) =>
        stretched(times, [
          ['file', `${i}.csv`],
          ['length', `${lengths[i] ?? 1} 0.0005`],
        ]),
      ),
    )
    const all: Told[] = []
    const stated = lengths.map((length) => ['length', `${length} 0.0005`] as const)
    await measure({ modules, files, stated }, (each) => all.push(each))
    return all
  }

  it('at three lengths give g and what every length misses', async () => {
    // Each 15 mm short of 0.64 m, 0.8 m, 1 m.
    const all = await asked([0.625, 0.785, 0.985])
    expect(all.filter(({ kind }) => kind === 'read').length).toBe(3)
    const steps = all.filter((each) => each.kind === 'step')
    expect(steps.map(({ step }) => step)).toEqual(steps.map((_, i) => i))
    expect(steps.at(-1)?.of).toBe(steps.length)
    const last = all.at(-1)
    if (last?.kind !== 'fitted' || !last.joint) throw new Error('no result')
    const { together, stands } = last.joint
    expect([stands, last.results.length, together.omega0, together.length]).toEqual([true, 3, null, null])
    const { g, length_offset: offset } = together
    expect(Math.abs((g?.value ?? 0) - 9.81)).toBeLessThan(2 * (g?.u ?? 0))
    expect(Math.abs((offset?.value ?? 0) - 0.015)).toBeLessThan(2 * (offset?.u ?? 0))
    expect(together.verdicts.join()).toContain('every stated length is short by')
  })

  it('need one length each', async () => {
    const all = await asked([0.625, 0.785])
    expect(all.at(-1)).toEqual({
      kind: 'refused',
      message: '3 records with 2 lengths: each record needs its length, and two are the least',
    })
  })
})

describe('a light gate', () => {
  it('has the turning angle of each period by the fit, and other records have none', async () => {
    const rows = Array.from({ length: 60 }, (_, i) => {
      const swing = 1.4 * Math.exp(-0.024 * i)
      const period = 1.8 * (1 + swing ** 2 / 16 + (11 * swing ** 4) / 3072 + (173 * swing ** 6) / 737280)
      return `${1.85 * i},${(period + 0.0004 * (((i * 7919) % 13) / 13 - 0.5)).toFixed(5)}`
    })
    const fits = await Measuring.start()
    const all: Told[] = []
    const file = { bytes: bytes(`time (s),period (s)\n${rows.join('\n')}\n`), stated: [] }
    await measure({ modules, files: [file], stated: [] }, (each) => all.push(each))
    const last = all.at(-1)
    if (last?.kind !== 'fitted') throw new Error('no result')
    const [result] = last.results
    expect(result?.swings.length).toBe(result?.x.length)
    expect(degrees(result?.swings[0] as number)).toBeGreaterThan(70)
    expect(result?.swings[0]).toBeGreaterThan(result?.swings.at(-1) as number)
    fits.read(bytes(await text(RECORD)), STATED)
    expect(fits.fit(STATED).swings.length).toBe(0)
  })
})
