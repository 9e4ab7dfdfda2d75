// What is taken along: tables that read back bit for bit, the motion as the command line writes it, the instants of a film, PNG chunks.

import { readFile } from 'node:fs/promises'
import { createRequire } from 'node:module'
import { beforeAll, describe, expect, it } from 'vitest'
import { version } from '../package.json'
import type { TableSpec } from '../src/columns'
import { Words } from '../src/language'
import { type Model, openModel } from '../src/model'
import { instants } from '../src/model/solved'
import { parseQuantity, radians } from '../src/number'
import { csv } from '../src/save/csv'
import { delaysOf, FEWEST, type Film, filmOf, MOST, makeFilm, type Sink } from '../src/save/film'
import { motionCommand, motionCsv, written } from '../src/save/motion-csv'
import { checkSum, pixelsOf, withDensity } from '../src/save/png'

const place = createRequire(import.meta.url)
let model: Model
beforeAll(async () => {
  const bytes = (kind: string) => readFile(place.resolve(`libration/libration-${kind}.wasm`))
  model = await openModel({ simd: await bytes('simd'), scalar: await bytes('scalar') })
})

/** Doubles of all sizes, by a generator of its own. */
function doubles(count: number): Float64Array {
  const view = new DataView(new ArrayBuffer(8))
  let state = 1n
  return Float64Array.from({ length: count }, () => {
    for (;;) {
      state = (state * 6364136223846793005n + 1442695040888963407n) & 0xffffffffffffffffn
      view.setBigUint64(0, state ^ (state >> 29n))
      const value = view.getFloat64(0)
      if (Number.isFinite(value)) return value
    }
  })
}

const EXAMPLE = (values: Float64Array, factor = 1): TableSpec => ({
  caption: 'Angle, °.',
  file: 'angle',
  first: { title: '_t_, s', values: Float64Array.from(values, (_, i) => i / 3), factor: 1, decimals: 3 },
  columns: [{ title: 'exact', values, factor, decimals: 2, about: '_θ_, by sn' }],
})

describe('a table as CSV', () => {
  it.each([
    ['en', undefined, ',', '.'],
    ['pt-BR', undefined, ';', ','],
    ['es', '.', ',', '.'],
    ['en', ',', ';', ','],
  ] as const)('of %s with the sign %s reads back to the same doubles', (language, sign, between, point) => {
    const values = doubles(2000)
    const text = csv(new Words(language), EXAMPLE(values), 'https://x/#v=1', sign)
    const lines = text.split('\r\n').filter((line) => line !== '' && !line.startsWith('#'))
    const back = lines.slice(1).map((line) => line.split(between).map((cell) => Number(cell.replace(point, '.'))))
    expect(back.map((row) => row[1])).toEqual([...values])
    expect(back.map((row) => row[0])).toEqual([...values].map((_, i) => i / 3))
    expect(back.every((row) => row.length === 2)).toBe(true)
  })

  it('says units, link, version, separators and formulas in its header', () => {
    const head = csv(new Words('en'), EXAMPLE(doubles(1)), 'https://x/#v=1')
      .split('\r\n')
      .slice(0, 5)
    expect(head).toEqual([
      '# Angle, °.',
      '# https://x/#v=1',
      `# libration ${version}; decimal point, columns separated by commas`,
      '# exact: θ, by sn',
      '"t, s",exact',
    ])
    const spanish = csv(new Words('es'), EXAMPLE(doubles(1)), '').split('\r\n')
    expect(spanish[2]).toBe(`# libration ${version}; coma decimal, columnas separadas por punto y coma`)
    expect(spanish[4]).toBe('"t, s";exact')
  })

  it('leaves what has no value empty', () => {
    const text = csv(new Words('en'), EXAMPLE(Float64Array.of(Number.NaN, 1)), '')
    expect(text).toContain('\r\n0,\r\n')
  })
})

/** 41 instants of 150 degrees, 1 m, 9.81 m/s²; python/tests/test_motion_page.py holds `libration solve` to the same file. */
const SHARED = new URL('motion-150deg.csv', import.meta.url)
const SETUP = { theta0: radians(150), velocity0: 0, length: 1, gravity: 9.81 }
const SAMPLING = { until: 4, samples: 41 }

describe('the motion as libration solve writes it', () => {
  it('is the file that both are held to, byte for byte', async () => {
    expect(motionCsv(SETUP, SAMPLING, '.')).toBe(await readFile(SHARED, 'utf8'))
  })

  it('has other bytes for another angle', async () => {
    const other = { ...SETUP, theta0: SETUP.theta0 * (1 + Number.EPSILON) }
    expect(motionCsv(other, SAMPLING, '.')).not.toBe(await readFile(SHARED, 'utf8'))
  })

  it('names the command', () => {
    expect(motionCommand(SETUP, SAMPLING, '.')).toBe(
      'libration solve --theta0 150deg --length 1m --gravity 9.81 --until 4s --samples 41 --out motion.csv',
    )
    expect(motionCommand({ ...SETUP, theta0: -1.25, velocity0: -2 }, SAMPLING, ',')).toBe(
      'libration solve --theta0 -1.25rad --velocity0 -2 --length 1m --gravity 9.81 --until 4s --samples 41 --decimal comma --out motion.csv',
    )
  })

  it('with a decimal comma says so first', () => {
    const lines = motionCsv(SETUP, SAMPLING, ',').split('\n')
    expect(lines[0]).toBe('# decimal comma, columns separated by semicolons')
    expect(lines.find((line) => line.startsWith('t ['))).toBe('t [s];theta [rad];velocity [rad/s];theta_linear [rad]')
    expect(lines.at(-2)).toMatch(/^4,0;-?\d,\d+;/)
  })

  it('has the numbers of the model, from t = 0 to the last', () => {
    const motion = model.motion(SETUP)
    const times = instants(4, 41)
    expect([times[0], times[40], times.length]).toEqual([0, 4, 41])
    const rows = motionCsv(SETUP, SAMPLING, '.')
      .split('\n')
      .filter((line) => /^[\d.]+,/.test(line))
    rows.forEach((row, i) => {
      const [t, theta, velocity] = row.split(',').map(Number)
      expect([t, theta, velocity]).toEqual([
        times[i],
        motion.theta(times[i] as number),
        motion.velocity(times[i] as number),
      ])
    })
    expect(rows.length).toBe(41)
  })

  it.each([
    [0, '0.0'],
    [-0, '-0.0'],
    [1, '1.0'],
    [-12.5, '-12.5'],
    [0.0001, '0.0001'],
    [0.00012345, '0.00012345'],
    [0.00001, '1e-05'],
    [-1.5e-7, '-1.5e-07'],
    [1e16, '1e+16'],
    [123456789012345680, '1.2345678901234568e+17'],
    [9007199254740992, '9007199254740992.0'],
    [1e100, '1e+100'],
    [1 / 3, '0.3333333333333333'],
    [5e-324, '5e-324'],
    [Number.NaN, 'nan'],
    [Number.NEGATIVE_INFINITY, '-inf'],
  ])('writes %d as Python does', (value, text) => expect(written(value)).toBe(text))

  it('writes every double so that it reads back', () => {
    for (const value of doubles(5000)) expect(Object.is(Number(written(value)), value)).toBe(true)
  })
})

const PERIOD = { of: 'period', rate: 25, speed: 1 } as const
const filmed = (theta0: number, velocity0: number, choice: Parameters<typeof filmOf>[1] = PERIOD): Film => {
  const film = filmOf(model.motion({ theta0, velocity0, length: 1, gravity: 9.81 }), choice)
  if ('refused' in film) throw new Error(film.refused)
  return film
}

describe('a film', () => {
  it.each([
    ['150 degrees', radians(150), 0],
    ['thrown', 0.3, 2],
    ['a rotation', 0, 7.5],
    ['next to the top', radians(179.9), 0],
  ])('of %s: frame i is the motion at i/perSecond, bit for bit', (_, theta0, velocity0) => {
    const motion = model.motion({ theta0, velocity0, length: 1, gravity: 9.81 })
    const film = filmed(theta0, velocity0)
    expect(film.times.length).toBeGreaterThan(20)
    film.theta.forEach((theta, i) => {
      expect(Object.is(theta, motion.theta(i / film.perSecond))).toBe(true)
      expect(Object.is(film.velocity[i], motion.velocity(i / film.perSecond))).toBe(true)
    })
    // A film begun a thousandth of a frame later is another one.
    expect(film.theta.some((theta, i) => theta === motion.theta((i + 1e-3) / film.perSecond))).toBe(false)
  })

  it('has as many frames as fill a period: the one after the last is the first', () => {
    const motion = model.motion(SETUP)
    const film = filmed(SETUP.theta0, 0)
    expect(film.times.length).toBe(Math.floor(25 * motion.period))
    const after = film.times.length / film.perSecond
    expect(Math.abs(after - motion.period)).toBeLessThan(1e-15 * motion.period)
    expect(Math.abs(motion.theta(after) - (film.theta[0] as number))).toBeLessThan(1e-12)
    expect(film.repeats).toBe(true)
  })

  it('of a rotation is one turn', () => {
    const motion = model.motion({ ...SETUP, theta0: 0, velocity0: 7.5 })
    const film = filmed(0, 7.5)
    const turned = motion.theta(film.times.length / film.perSecond) - (film.theta[0] as number)
    expect(Math.abs(turned - 2 * Math.PI)).toBeLessThan(1e-12)
  })

  it('of what the plots show begins and ends with them', () => {
    const film = filmed(SETUP.theta0, 0, { of: { from: 8, to: 16 }, rate: 20, speed: 2 })
    expect([film.times[0], film.times.length, film.seconds, film.repeats]).toEqual([8, 80, 4, false])
    expect(film.times.at(-1)).toBeCloseTo(15.9, 12)
  })

  it('in slow motion has more frames, at times that lie closer', () => {
    const film = filmed(SETUP.theta0, 0, { ...PERIOD, speed: 0.25 })
    expect(film.seconds).toBe(4 * model.motion(SETUP).period)
    expect(film.times.length).toBe(Math.floor(25 * film.seconds))
  })

  it.each([10, 20, 25, 30, 50])(
    'as GIF at %i frames a second lasts as long, to a hundredth, and no frame less than two',
    (rate) => {
      const film = filmed(SETUP.theta0, 0, { ...PERIOD, rate })
      const delays = delaysOf(film)
      expect(delays.length).toBe(film.times.length)
      expect(delays.reduce((sum, each) => sum + each, 0)).toBe(Math.round(100 * film.seconds))
      expect(Math.min(...delays)).toBeGreaterThanOrEqual(2)
      expect(Math.max(...delays) - Math.min(...delays)).toBeLessThanOrEqual(1)
    },
  )

  it('is refused where there is none to make', () => {
    const refused = (theta0: number, velocity0: number, choice: Parameters<typeof filmOf>[1] = PERIOD) =>
      filmOf(model.motion({ ...SETUP, theta0, velocity0 }), choice)
    expect(refused(0, 0)).toEqual({ refused: 'rest', frames: 0 })
    expect(refused(Math.PI, 0)).toEqual({ refused: 'rest', frames: 0 })
    const { separatrixVelocity } = model.motion(SETUP)
    const top = separatrixVelocity.call(model.motion(SETUP), 0)
    expect(refused(0, top)).toEqual({ refused: 'separatrix', frames: 0 })
    // What the plots show of it can be filmed.
    expect(refused(0, top, { ...PERIOD, of: { from: 0, to: 8 } })).toMatchObject({ repeats: false })
    expect(refused(1, 0, { ...PERIOD, of: { from: 0, to: 0.1 } })).toEqual({ refused: 'few', frames: 2 })
    expect(refused(1, 0, { ...PERIOD, of: { from: 0, to: 600 } })).toEqual({ refused: 'many', frames: 15000 })
    expect(FEWEST).toBeLessThan(MOST)
  })
})

describe('the making of a film', () => {
  const sink = () => {
    const log: string[] = []
    const made: Sink = {
      ending: 'gif',
      type: 'image/gif',
      add: async (_, frame) => void log.push(`add ${frame}`),
      finish: async () => {
        log.push('finish')
        return new Uint8Array(1)
      },
      close: () => void log.push('close'),
    }
    return { log, made }
  }
  const film = { times: new Float64Array(3) } as unknown as Film

  it('paints, adds and tells each frame in order', async () => {
    const { log, made } = sink()
    const paint = async (frame: number) => void log.push(`paint ${frame}`)
    await makeFilm(
      film,
      null as never,
      paint,
      made,
      (done) => void log.push(`told ${done}`),
      new AbortController().signal,
    )
    const each = (i: number) => [`paint ${i}`, `add ${i}`, `told ${i + 1}`]
    expect(log).toEqual([...each(0), ...each(1), ...each(2), 'finish'])
  })

  it('ends where it is cancelled, and closes what it had begun', async () => {
    const { log, made } = sink()
    const abort = new AbortController()
    const making = makeFilm(
      film,
      null as never,
      async () => {},
      made,
      () => abort.abort(),
      abort.signal,
    )
    await expect(making).rejects.toThrow()
    expect(log).toEqual(['add 0', 'close'])
  })
})

describe('a PNG', () => {
  it('has 1890 pixels on 160 mm at 300 in an inch', () => expect([pixelsOf(160), pixelsOf(25.4)]).toEqual([1890, 300]))

  it('has the check sums of its specification', () => {
    // Of the chunk IEND, which is the same in every file.
    expect(checkSum(new TextEncoder().encode('IEND'))).toBe(0xae426082)
  })

  it('says how large a pixel is, before its picture', () => {
    const before = Uint8Array.from({ length: 60 }, (_, i) => i)
    const after = withDensity(before, 300)
    expect(after.length).toBe(before.length + 21)
    expect(after.subarray(0, 33)).toEqual(before.subarray(0, 33))
    expect(after.subarray(54)).toEqual(before.subarray(33))
    const view = new DataView(after.buffer, 33)
    expect(new TextDecoder().decode(after.subarray(37, 41))).toBe('pHYs')
    expect([view.getUint32(0), view.getUint32(8), view.getUint32(12), view.getUint8(16)]).toEqual([9, 11811, 11811, 1])
    expect(view.getUint32(17)).toBe(checkSum(after.subarray(37, 50)))
  })
})

it('an angle of the command is read back as it was', () => {
  for (const angle of [radians(150), -1.25, 0.1, Math.PI]) {
    const [, text = ''] = /--theta0 (\S+)/.exec(motionCommand({ ...SETUP, theta0: angle }, SAMPLING, '.')) ?? []
    expect(parseQuantity(text, 'deg')).toBe(angle)
  }
})
