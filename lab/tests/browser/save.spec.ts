// Story 15: CSV, SVG and PNG, made on this machine; with keys alone, in three languages, and from disk. The films: film.spec.ts.

import { readFile } from 'node:fs/promises'
import type { Page } from '@playwright/test'
import { load } from 'libration'
import { decodedGif, expectBobs, place } from './decoded'
import { column, csvOf, expect, linkOf, opened, radians, ready, savedText, sheet, show, test, whole } from './lab'
import { film, LINK, menuOf, SWING, saved } from './saved'
import { DIST } from './server'

test.beforeAll(async () => {
  await load()
})

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

/** The picture of a chart, as its menu saves it. */
const svgOf = (page: Page, chart: string): Promise<string> =>
  savedText(page, async () => {
    await menuOf(page, chart).click()
    await page.getByRole('menuitem', { name: /^SVG/ }).click()
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
    const text = await svgOf(lab, chart)
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
    const other = await svgOf(large, chart)
    expect(other.replace(/<desc>.*?<\/desc>/, '')).toBe(text.replace(/<desc>.*?<\/desc>/, ''))
  }
  await large.context().close()
})

test('story 15: a picture shows every curve whichever is pointed at; one that goes is forgotten', async ({ lab }) => {
  const link = `${LINK}&curves=linear,fourier:4,rk45`
  await show(lab, link)
  const row = lab.locator('.compare li.row').nth(1)
  const faded = lab.locator('[data-chart=angle] .c.faded')
  const whole = await svgOf(lab, 'angle')
  await row.locator('input').focus()
  await expect(faded).toHaveCount(3)
  const pointed = await savedText(lab, async () => {
    await menuOf(lab, 'angle').dispatchEvent('click')
    await row.hover()
    await expect(faded).toHaveCount(3)
    await lab.getByRole('menuitem', { name: /^SVG/ }).dispatchEvent('click')
  })
  expect(pointed).toBe(whole)
  // The row is gone, or the view is another one, with the pointer where it was.
  for (const leave of [
    () => row.getByRole('button').last().dispatchEvent('click'),
    () => show(lab, `view=period&${link}`),
  ]) {
    await lab.mouse.move(0, 0)
    await show(lab, link)
    await row.hover()
    await expect(faded).toHaveCount(3)
    await leave()
    await expect(lab.locator('.faded')).toHaveCount(0)
  }
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

test('story 15: by keys alone, in three languages, and nothing is asked for', async ({ browser }) => {
  const page = await opened(browser, LINK)
  await whole(page)
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
  await context.close()
})
