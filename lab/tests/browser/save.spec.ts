// Story 15: CSV, SVG, PNG, GIF and MP4, made on this machine; a frame is the core at its instant, and one period has no seam.

import { readFile } from 'node:fs/promises'
import type { Locator, Page } from '@playwright/test'
import { load, Pendulum } from 'libration'
import { BOX, spot } from '../../src/draw/pendulum'
import { boxAt, boxes, decodedGif, decodedVideo, type Place } from './decoded'
import { address, column, csvOf, drawn, expect, linkOf, opened, radians, ready, sheet, show, test } from './lab'
import { DIST } from './server'

test.beforeAll(async () => {
  await load()
})

const LINK = 'th0=150deg&L=1m&g=9.81&t=0s'
const SWING = () => new Pendulum({ theta0: radians(150), length: 1, gravity: 9.81 })

const menuOf = (page: Page, chart: string): Locator =>
  page.locator(chart === 'pendulum' ? '.drawing .menu.save > button' : `[data-chart=${chart}] .menu.save > button`)

/** What a choice of a menu saves. */
async function saved(page: Page, chart: string, item: RegExp): Promise<{ bytes: Buffer; name: string }> {
  await menuOf(page, chart).click()
  const saving = page.waitForEvent('download')
  await page.getByRole('menuitem', { name: item }).click()
  const file = await saving
  return { bytes: await readFile(await file.path()), name: file.suggestedFilename() }
}

async function openFilm(page: Page): Promise<Locator> {
  await menuOf(page, 'pendulum').click()
  await page.getByRole('menuitem', { name: /^Film/ }).click()
  const dialog = page.locator('dialog[open]')
  await expect(dialog).toBeVisible()
  return dialog
}

interface Choice {
  readonly format: 'MP4' | 'GIF' | 'WebM'
  readonly width?: number
  readonly rate?: number
  readonly shows?: RegExp
}

/** Makes a film and closes the dialog. */
async function film(page: Page, { format, width = 320, rate = 25, shows = /one/ }: Choice) {
  const dialog = await openFilm(page)
  await dialog.getByRole('button', { name: shows }).click()
  await dialog.getByRole('button', { name: format, exact: true }).click()
  await dialog.getByRole('button', { name: String(width), exact: true }).click()
  await dialog.getByRole('button', { name: String(rate), exact: true }).click()
  const facts = (await dialog.locator('.film').textContent()) ?? ''
  const saving = page.waitForEvent('download')
  await dialog.locator('#film-make').click()
  const file = await saving
  await expect(dialog.locator('#film-state')).toContainText('is saved')
  await page.keyboard.press('Escape')
  await expect(page.locator('dialog')).toHaveCount(0)
  return { bytes: await readFile(await file.path()), name: file.suggestedFilename(), facts }
}

/** Where the bob of an angle is in a film so large: the drawing in its middle, as large as fits. */
function place(theta: number, width: number, height: number): Place {
  const [wide, high] = [BOX.width + 28, BOX.height + 12]
  const scale = Math.min(width / wide, height / high)
  const { x, y } = spot(theta)
  return {
    x: (x + 14) * scale + (width - wide * scale) / 2,
    y: (y + 6) * scale + (height - high * scale) / 2,
  }
}

function expectBobs(bobs: readonly Place[], wanted: readonly Place[]): void {
  bobs.forEach((bob, i) => {
    const at = wanted[i] as Place
    expect([i, Math.hypot(bob.x - at.x, bob.y - at.y)].map((each) => Math.floor(each))).toEqual([i, 0])
  })
}

test('story 15: a CSV has units, formulas, version and link, and reads back bit for bit', async ({ lab }) => {
  await show(lab, `${LINK}&curves=linear,fourier:4,rk45`)
  const link = await linkOf(lab)
  const table = await csvOf(lab, 'angle')
  expect(table.about).toBe('Angle, °.')
  expect(table.link).toBe(link)
  expect(table.text).toMatch(/# libration \d+\.\d+\.\d+; decimal point, columns separated by commas\r\n/)
  expect(table.text).toContain('# exact: Jacobi’s sn\r\n')
  expect(table.text).toContain('# linear: small swings, sin θ = θ\r\n')
  const [point, comma] = [
    await saved(lab, 'angle', /CSV table decimal point/),
    await saved(lab, 'angle', /CSV table decimal comma/),
  ]
  expect(point.bytes.toString('utf8')).toBe(table.text)
  const other = sheet(comma.bytes.toString('utf8'), ';', ',')
  expect(other.text).toContain('decimal comma, columns separated by semicolons')
  for (const name of table.header) expect([...column(other, name)]).toEqual([...column(table, name)])
  // In the unit of the file they are the very doubles of the core.
  const swing = SWING()
  const degrees = [...column(table, 't, s')].map((t) => swing.theta(t) * (180 / Math.PI))
  expect([...column(table, 'exact')]).toEqual(degrees)
})

test('story 15: the table of the motion is that of libration solve', async ({ lab }) => {
  await show(lab, `${LINK}&span=4s`)
  const { bytes, name } = await saved(lab, 'pendulum', /CSV of the motion, decimal point/)
  expect(name).toBe('motion.csv')
  await expect(lab.locator('.message')).toContainText(
    'libration solve --theta0 150deg --length 1m --gravity 9.81 --until 4s --samples 1201 --out motion.csv',
  )
  const lines = bytes.toString('utf8').split('\n')
  const shared = (await readFile(new URL('../motion-150deg.csv', import.meta.url), 'utf8')).split('\n')
  const head = shared.findIndex((line) => line.startsWith('t ['))
  expect(lines.slice(0, head + 1)).toEqual(shared.slice(0, head + 1))
  // Every thirtieth row is one of the 41, but for the rounding of its instant.
  const rows = (of: readonly string[]) => of.slice(head + 1, -1).map((line) => line.split(',').map(Number))
  const [all, some] = [rows(lines), rows(shared)]
  expect([all.length, some.length]).toEqual([1201, 41])
  for (const [i, row] of some.entries())
    for (const [at, value] of row.entries())
      expect(Math.abs((all[30 * i]?.[at] ?? Number.NaN) - value)).toBeLessThan(1e-13)
  await lab.locator('.message [data-tool=close]').click()
})

const CHARTS = [
  ['lab', 'pendulum'],
  ['lab', 'angle'],
  ['lab', 'error'],
  ['lab', 'energy'],
  ['phase', 'phase'],
  ['phase', 'orbit-angle'],
  ['period', 'period'],
  ['period', 'period-error'],
  ['functions', 'functions'],
] as const

test('story 15: every chart is an SVG of its own, with text as text, the same from every screen and theme', async ({
  lab,
  browser,
}) => {
  const large = await opened(browser, LINK, { viewport: { width: 1920, height: 1080 } })
  for (const [view, chart] of CHARTS) {
    await show(lab, `view=${view}&${LINK}&theme=dark`)
    const { bytes } = await saved(lab, chart, /^SVG/)
    const text = bytes.toString('utf8')
    const about = await lab.evaluate((source) => {
      const parsed = new DOMParser().parseFromString(source, 'image/svg+xml')
      const root = parsed.documentElement
      return {
        broken: parsed.querySelector('parsererror')?.textContent ?? null,
        name: root.localName,
        size: [root.getAttribute('width'), root.getAttribute('height')],
        box: root.getAttribute('viewBox'),
        texts: [...parsed.querySelectorAll('text')].map((each) => [
          each.textContent?.trim(),
          each.getAttribute('font-family'),
          each.getAttribute('fill'),
        ]),
        desc: parsed.querySelector('desc')?.textContent,
        foreign: [...parsed.querySelectorAll('*')].filter(({ namespaceURI }) => !namespaceURI?.endsWith('/svg')).length,
        paper:
          parsed.querySelector('path')?.getAttribute('d') && parsed.querySelectorAll('path[fill="#ffffff"]').length,
      }
    }, text)
    expect(about.broken, chart).toBeNull()
    expect(about.name).toBe('svg')
    const [, , width = 0, height = 0] = (about.box ?? '').split(' ').map(Number)
    expect(about.size).toEqual([`${width / 4}mm`, `${height / 4}mm`])
    expect(about.texts.length).toBeGreaterThan(4)
    for (const [words, font, fill] of about.texts) {
      expect(words, chart).not.toBe('')
      expect(font).toMatch(/sans-serif$|serif$/)
      // Dark letters: the theme of the page is not that of the picture.
      expect(Number.parseInt((fill ?? '').slice(1, 3), 16)).toBeLessThan(0x80)
    }
    expect(about.desc).toMatch(/libration \d+\.\d+\.\d+, http/)
    expect(about.foreign).toBe(0)
    expect(about.paper).toBeGreaterThan(0)
    // Nothing that only the page knows: classes, variables, addresses.
    expect(text).not.toMatch(/ class=| style=|var\(|<style|<!--|href=|vector-effect|NaN|undefined/)
    await show(large, `view=${view}&${LINK}&theme=light`)
    const other = (await saved(large, chart, /^SVG/)).bytes.toString('utf8')
    expect(other.replace(/<desc>.*?<\/desc>/, '')).toBe(text.replace(/<desc>.*?<\/desc>/, ''))
  }
  await large.context().close()
})

test('story 15: a PNG has 300 dots per inch at its width, and the font of the page', async ({ lab }) => {
  // What is given to be drawn, beside its drawing.
  await lab.evaluate(() => {
    const { createObjectURL } = URL
    const kept = window as unknown as { svg: Promise<string> }
    URL.createObjectURL = (of: Blob) => {
      if (of.type === 'image/svg+xml') kept.svg = of.text()
      return createObjectURL(of)
    }
  })
  for (const [chart, mm, file] of [
    ['angle', 160, 'angle.png'],
    ['pendulum', 77, 'pendulum.png'],
  ] as const) {
    await show(lab, `${LINK}&theme=dark`)
    const { bytes, name } = await saved(lab, chart, /^PNG/)
    expect(name).toBe(file)
    const drawing = await lab.evaluate(() => (window as unknown as { svg: Promise<string> }).svg)
    expect(drawing.match(/@font-face[^}]*"Libration (Sans|Math)"[^}]*data:font\/woff2;base64,\w/g)).toHaveLength(2)
    expect(bytes.subarray(0, 8)).toEqual(Buffer.from([137, 80, 78, 71, 13, 10, 26, 10]))
    expect(bytes.readUInt32BE(16)).toBe(Math.round((mm / 25.4) * 300))
    // The chunk behind the header.
    expect(bytes.toString('latin1', 37, 41)).toBe('pHYs')
    expect([bytes.readUInt32BE(41), bytes.readUInt32BE(45), bytes[49]]).toEqual([11811, 11811, 1])
    // Paper is white, and there is ink on it.
    const seen = await lab.evaluate(async (text) => {
      const data = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0))
      const image = await createImageBitmap(new Blob([data], { type: 'image/png' }))
      const canvas = new OffscreenCanvas(image.width, image.height)
      const context = canvas.getContext('2d') as OffscreenCanvasRenderingContext2D
      context.drawImage(image, 0, 0)
      const pixels = context.getImageData(0, 0, image.width, image.height).data
      const dark = pixels.filter((value, i) => i % 4 === 0 && value < 0x40).length
      return { corner: [...pixels.slice(0, 4)], dark: dark / (pixels.length / 4) }
    }, bytes.toString('base64'))
    expect(seen.corner).toEqual([255, 255, 255, 255])
    expect(seen.dark).toBeGreaterThan(0.005)
    expect(seen.dark).toBeLessThan(0.2)
  }
})

test('story 15: frame i of a GIF is the core at t = i/fps, and one period has no seam', async ({ lab }) => {
  const swing = SWING()
  await show(lab, LINK)
  const { bytes, name, facts } = await film(lab, { format: 'GIF', width: 480 })
  expect(name).toBe('pendulum.gif')
  const count = Math.floor(25 * swing.period)
  expect(facts).toContain(`${count} frames of 480 × 402 pixels`)
  expect(facts).toContain('repeats without a seam')
  expect(facts.replaceAll('\u00a0', ' ')).toContain('takes 3.54 s and not 3.5351 s')
  expect(bytes.toString('latin1', 0, 6)).toBe('GIF89a')
  expect(bytes.includes('NETSCAPE2.0')).toBe(true)
  const perSecond = count / swing.period
  const wanted = [0, 1, 7, 22, 30, 44, 61, count - 1]
  const found = await decodedGif(lab, bytes, wanted)
  expect([found.frames, found.width, found.height]).toEqual([count, 480, 402])
  expect(found.delays.reduce((sum, each) => sum + each, 0)).toBe(Math.round(100 * swing.period))
  const places = (shift: number) => wanted.map((i) => place(swing.theta((i + shift) / perSecond), 480, 402))
  expectBobs(found.bobs, places(0))
  // A film that is a frame late is seen to be.
  expect(() => expectBobs(found.bobs, places(1))).toThrow()
})

test('story 15: the frame after a period is the first, to the pixel', async ({ lab }) => {
  const { period } = SWING()
  const { period: turn } = new Pendulum({ theta0: radians(20), velocity0: 7, length: 1, gravity: 9.81 })
  for (const [start, time] of [
    ['th0=150deg', period],
    ['th0=20deg&w0=7', turn],
  ] as const) {
    await show(lab, `${start}&L=1m&g=9.81&span=${2 * time}s&t=0s`)
    // An even number of frames in two periods: the middle one is the first again.
    const rate = [10, 20, 25, 30, 50].find((each) => Math.floor(2 * time * each * (1 + 1e-12)) % 2 === 0) ?? 0
    const count = Math.floor(2 * time * rate * (1 + 1e-12))
    const { bytes } = await film(lab, { format: 'GIF', rate, shows: /0 s to/ })
    const { frames, pixels } = await decodedGif(lab, bytes, [0, count / 2, 1, 1 + count / 2])
    expect(frames).toBe(count)
    expect(pixels[1]).toBe(pixels[0])
    expect(pixels[3]).toBe(pixels[2])
    expect(pixels[2]).not.toBe(pixels[0])
  }
})

test('story 15: an MP4 is avc1 in ftyp isom, and its frames are the core at t = i/fps', async ({ lab }) => {
  const turning = { theta0: radians(20), velocity0: 7, length: 1, gravity: 9.81 }
  for (const [link, pendulum] of [
    ['th0=150deg', SWING()],
    ['th0=20deg&w0=7', new Pendulum(turning)],
  ] as const) {
    await show(lab, `${link}&L=1m&g=9.81&t=0s`)
    const { bytes, name } = await film(lab, { format: 'MP4', width: 480 })
    expect(name).toBe('pendulum.mp4')
    expect(boxes(bytes).map(({ type }) => type)).toEqual(['ftyp', 'moov', 'mdat'])
    const brands = boxAt(bytes, 'ftyp')
    expect(brands.toString('latin1', 0, 4)).toBe('isom')
    expect(brands.toString('latin1', 8)).toContain('avc1')
    const track = boxAt(bytes, 'moov', 'trak', 'mdia', 'minf', 'stbl')
    const kind = boxAt(track, 'stsd')
    expect(kind.toString('latin1', 12, 16)).toBe('avc1')
    const count = Math.floor(25 * pendulum.period)
    expect(boxAt(track, 'stsz').readUInt32BE(8)).toBe(count)
    const perSecond = count / pendulum.period
    const wanted = [0, 3, Math.floor(count / 3), Math.floor(count / 2), count - 1]
    const found = await decodedVideo(
      lab,
      bytes,
      'video/mp4',
      wanted.map((i) => (i + 0.5) / perSecond),
    )
    expect([found.width, found.height]).toEqual([480, 402])
    expect(Math.abs(found.duration - pendulum.period)).toBeLessThan(2e-3)
    expectBobs(
      found.bobs,
      wanted.map((i) => place(pendulum.theta(i / perSecond), 480, 402)),
    )
    // A whole period further it is drawn at the same place.
    const [first, again] = [0, pendulum.period].map((t) => place(pendulum.theta(t), 480, 402)) as [Place, Place]
    expect(Math.hypot(again.x - first.x, again.y - first.y)).toBeLessThan(1e-6)
  }
})

test('story 15: without H.264 the film is WebM, without video a GIF, and the page says so', async ({ browser }) => {
  for (const [refused, format, said] of [
    ['avc1', 'WebM', 'writes no MP4 (H.264): the film is WebM (VP9)'],
    ['', 'GIF', 'writes no video: the film is a GIF'],
  ] as const) {
    const context = await browser.newContext({ serviceWorkers: 'block' })
    const page = await context.newPage()
    await page.addInitScript((prefix) => {
      const ask = VideoEncoder.isConfigSupported.bind(VideoEncoder)
      VideoEncoder.isConfigSupported = async (config) =>
        config.codec.startsWith(prefix) ? { config, supported: false } : ask(config)
    }, refused)
    await page.goto(`${address()}#${LINK}`)
    await ready(page)
    const dialog = await openFilm(page)
    await expect(dialog).toContainText(said)
    await expect(dialog.getByRole('button', { name: 'MP4', exact: true })).toHaveCount(0)
    await page.keyboard.press('Escape')
    const { bytes, name } = await film(page, { format, rate: 10 })
    expect(name).toBe(`pendulum.${format.toLowerCase()}`)
    if (format === 'WebM') {
      expect(bytes.readUInt32BE(0)).toBe(0x1a45dfa3)
      const { bobs, width, height } = await decodedVideo(page, bytes, 'video/webm', [0.02])
      expectBobs(bobs, [place(radians(150), width, height)])
    }
    await context.close()
  }
})

test('story 15: a film shows its progress, leaves the page at work, and can be cancelled', async ({ lab }) => {
  await show(lab, `${LINK}&span=30s`)
  const dialog = await openFilm(lab)
  await dialog.getByRole('button', { name: /0 s to 30 s/ }).click()
  await dialog.getByRole('button', { name: 'GIF', exact: true }).click()
  await dialog.getByRole('button', { name: '1080', exact: true }).click()
  await dialog.getByRole('button', { name: '50', exact: true }).click()
  let downloads = 0
  lab.on('download', () => downloads++)
  await dialog.locator('#film-make').click()
  await expect(dialog.locator('#film-state')).toContainText(/Frame [1-9]\d* of 1500/)
  await expect(dialog.locator('progress')).toHaveAttribute('aria-label', 'Progress of the film')
  // The page draws and answers between two frames.
  await drawn(lab)
  await dialog.locator('#film-cancel').focus()
  await lab.keyboard.press('Enter')
  await expect(dialog.locator('#film-state')).toContainText('Cancelled. Nothing was saved.')
  await expect(dialog.locator('#film-make')).toBeEnabled()
  expect(downloads).toBe(0)
  await lab.keyboard.press('Escape')
  await expect(lab.locator('.picture')).toHaveCount(0)
})

test('story 15: where there is no film the dialog says why', async ({ lab }) => {
  const separatrix = new Pendulum({ theta0: 0, length: 1, gravity: 9.81 }).separatrixVelocity(0)
  for (const [link, said] of [
    [`th0=0deg&w0=${separatrix}`, 'the period is infinite'],
    ['th0=180deg', 'At rest nothing moves'],
    ['th0=10deg&L=1000m&g=0.001', 'frames, more than 2000'],
    ['th0=10deg&L=0.001m&g=1000', 'too few to be seen moving'],
  ] as const) {
    await show(lab, link.includes('L=') ? `${link}&t=0s` : `${link}&L=1m&g=9.81&t=0s`)
    const dialog = await openFilm(lab)
    await dialog.getByRole('button', { name: /one/ }).click()
    await expect(dialog.getByRole('status').first()).toContainText(said)
    await expect(dialog.locator('#film-make')).toBeDisabled()
    await lab.keyboard.press('Escape')
    await expect(lab.locator('dialog')).toHaveCount(0)
  }
  // What no doubles start is no motion of the command line.
  await show(lab, 'th0=180deg&L=1m&g=9.81&t=0s')
  await menuOf(lab, 'pendulum').click()
  await expect(lab.getByRole('menuitem', { name: /^SVG/ })).toBeVisible()
  await expect(lab.getByRole('menuitem', { name: /CSV/ })).toHaveCount(0)
  await lab.keyboard.press('Escape')
})

test('story 15: by keys alone, in three languages, and nothing is asked for', async ({ browser }) => {
  const page = await opened(browser, LINK)
  await page.waitForLoadState('networkidle')
  const asked: string[] = []
  page.context().on('request', (request) => asked.push(request.url()))
  for (const [language, name, first, decimal] of [
    ['en', 'Save: Angle', 'CSV table', '.'],
    ['pt-BR', 'Salvar: Ângulo', 'Tabela CSV', ','],
    ['es', 'Guardar: Ángulo', 'Tabla CSV', ','],
  ] as const) {
    await show(page, `${LINK}&lang=${language}`)
    const button = page.getByRole('button', { name, exact: true })
    await button.focus()
    await page.keyboard.press('Enter')
    const items = page.getByRole('menuitem')
    await expect(items).toHaveCount(4)
    await page.keyboard.press('ArrowDown')
    await expect(items.first()).toBeFocused()
    await expect(items.first()).toContainText(first)
    const saving = page.waitForEvent('download')
    await page.keyboard.press('Enter')
    const text = await readFile(await (await saving).path(), 'utf8')
    expect(text).toContain(decimal === ',' ? '\r\n0;150;' : '\r\n0,150,')
    await expect(button).toBeFocused()
    await page.keyboard.press('Enter')
    await page.keyboard.press('ArrowUp')
    await expect(items.last()).toBeFocused()
    await page.keyboard.press('Escape')
    await expect(button).toBeFocused()
  }
  await show(page, LINK)
  await saved(page, 'angle', /^PNG/)
  await film(page, { format: 'MP4', rate: 10 })
  await film(page, { format: 'GIF', rate: 10 })
  expect(asked.filter((each) => !each.startsWith('blob:') && !each.startsWith('data:'))).toEqual([])
  await page.context().close()
})

test('story 15: the offline file saves from disk without a network', async ({ browser }) => {
  const context = await browser.newContext({ offline: true })
  const page = await context.newPage()
  await page.goto(`file://${DIST}offline.html#${LINK}`)
  await ready(page)
  expect((await saved(page, 'angle', /CSV table decimal point/)).bytes.length).toBeGreaterThan(10_000)
  expect((await saved(page, 'angle', /^SVG/)).bytes.toString('utf8')).toContain('</svg>')
  const { bytes } = await saved(page, 'angle', /^PNG/)
  expect(bytes.readUInt32BE(16)).toBe(1890)
  const gif = await film(page, { format: 'GIF', rate: 10 })
  const { bobs, width, height } = await decodedGif(page, gif.bytes, [0])
  expectBobs(bobs, [place(radians(150), width, height)])
  const mp4 = await film(page, { format: 'MP4', rate: 10 })
  expect(boxAt(mp4.bytes, 'ftyp').toString('latin1', 0, 4)).toBe('isom')
  await context.close()
})
