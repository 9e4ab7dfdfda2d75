// Stories 9 and 12: code that is right, and a sheet to print.

import { readFileSync } from 'node:fs'
import type { Page } from '@playwright/test'
import { readLink } from '../../src/link'
import { CODES, type Code, LANGUAGES } from '../../src/state'
import { drawn, expect, heldTimers, opened, show, test } from './lab'
import { DIST } from './server'

const SNIPPETS = JSON.parse(readFileSync(new URL('../snippets.json', import.meta.url), 'utf8')) as readonly {
  readonly start: {
    readonly theta0: number
    readonly velocity0: number
    readonly length: number
    readonly gravity: number
  }
  readonly texts: Readonly<Record<Code, readonly string[]>>
}[]

test('story 9: the page gives the texts that are run against the core, and copies them', async ({ browser }) => {
  const page = await opened(browser, 't=0s', { permissions: ['clipboard-read', 'clipboard-write'] })
  for (const { start, texts } of [SNIPPETS[0], SNIPPETS[7], SNIPPETS[10], SNIPPETS[13]].flatMap((each) => each ?? [])) {
    const { theta0, velocity0, length, gravity } = start
    for (const code of CODES) {
      await show(
        page,
        `view=handouts&handout=code&code=${code}&th0=${theta0}rad&w0=${velocity0}&L=${length}m&g=${gravity}&t=0s&lang=en`,
      )
      await expect(page.locator('#code-text')).toHaveText(`${texts[code].join('\n')}\n`, { useInnerText: false })
      if (theta0 !== SNIPPETS[0]?.start.theta0) continue
      await page.locator('#copy-code').click()
      await expect.poll(() => page.evaluate(() => navigator.clipboard.readText())).toBe(`${texts[code].join('\n')}\n`)
    }
  }
  // It says so, for two seconds.
  const timers = await heldTimers(page, 2000)
  await page.locator('#copy-code').click()
  // The words may still be those of the copy before; this one's time has begun when it waits.
  await expect.poll(timers.count).toBe(1)
  await expect(page.locator('#copy-code')).toHaveText('Copied')
  await timers.fire()
  await expect(page.locator('#copy-code')).not.toHaveText('Copied')
  await page.context().close()
})

test('story 9: k, m or the modular angle shows the others and what the wrong one does', async ({ browser }) => {
  // What is typed stays with a visit.
  const page = await opened(browser, 't=0s')
  await show(page, 'view=handouts&handout=code&th0=150deg&t=0s&lang=en')
  // Until something is typed they are those of the pendulum of the page.
  await expect(page.locator('#modulus-theta0')).toHaveValue('150')
  await page.locator('#modulus-theta0').fill('20')
  await expect(page.locator('#k-for-m')).toContainText('+4.03 %')
  await page.locator('#modulus-alpha').fill('22.5')
  await expect(page.locator('#modulus-theta0')).toHaveValue('45')
  expect(100 * Number(await page.locator('#k-for-m').getAttribute('data-exact'))).toBeCloseTo(8.1, 1)
  await page.locator('#modulus-m').fill('0,5')
  await expect(page.locator('#modulus-k')).toHaveValue('0.7071068')
  await expect(page.locator('#modulus-alpha')).toHaveValue('45')
  await expect(page.locator('#k-for-m')).toContainText('+12.5 %')
  await page.locator('#modulus-k').fill('1.2')
  await expect(page.locator('#modulus-fault')).toContainText('modulus k: 1.2 is not a number from 0 to 0.999999')
  await page.locator('#modulus-k').fill('0.5')
  await expect(page.locator('#modulus-m')).toHaveValue('0.25')
  await show(page, 'view=handouts&handout=code&lang=pt-BR&t=0s')
  await expect(page.locator('#modulus-m')).toHaveValue('0,25')
  await page.context().close()
})

/** How many pages, and what else is in a PDF: Chromium writes its objects as they are. */
function objectsOf(pdf: Buffer) {
  const text = pdf.toString('latin1')
  const count = (pattern: RegExp) => text.match(pattern)?.length ?? 0
  const boxes = [...text.matchAll(/\/MediaBox\s*\[([^\]]*)\]/g)].map(([, box = '']) =>
    box.trim().split(/\s+/).map(Number),
  )
  return {
    pages: count(/\/Type\s*\/Page\b(?!s)/g),
    images: count(/\/Subtype\s*\/Image\b/g),
    fonts: count(/\/Type\s*\/Font\b/g),
    boxes,
  }
}

/** Elements of the printed page that are wider than it, and what is shown besides the sheet. */
async function printedFaults(page: Page, width: number): Promise<string[]> {
  await page.emulateMedia({ media: 'print' })
  const before = page.viewportSize() ?? { width: 1280, height: 720 }
  await page.setViewportSize({ width, height: 1000 })
  const faults = await page.evaluate((most) => {
    const shown = (element: Element) =>
      element.getClientRects().length > 0 && element.closest('.unseen, .definitions') === null
    const all = [...document.querySelectorAll('#page *')].filter(shown)
    const wide = all.filter((element) => {
      const { left, right } = element.getBoundingClientRect()
      // The grid of a chart is cut at its frame.
      return (left < -0.5 || right > most + 0.5) && element.closest('.clip') === null
    })
    const other = all.filter((element) => element.matches('button, input, nav, h1'))
    return [...wide, ...other].map(
      (element) => `${element.tagName} ${element.getAttribute('class')}: ${element.textContent?.slice(0, 30)}`,
    )
  }, width)
  await page.setViewportSize(before)
  await page.emulateMedia({ media: null })
  return faults
}

/** Of the content in pixels of 1/96 inch, and in points. */
const PAPERS = {
  A4: { content: Math.floor(((210 - 28) / 25.4) * 96), points: [595, 842] },
  Letter: { content: Math.floor(((215.9 - 28) / 25.4) * 96), points: [612, 792] },
} as const

test('story 12: a sheet prints on two pages of A4 or Letter, its answers on a third, in vectors', async ({ lab }) => {
  for (const [paper, { content, points }] of Object.entries(PAPERS)) {
    for (const language of LANGUAGES) {
      // With the answers the sheet is the same, and a page longer.
      for (const key of language === 'en' ? [0, 1] : [1]) {
        await show(lab, `view=handouts&seed=${11 + key}&key=${key}&paper=${paper}&lang=${language}&t=0s`)
        await expect(lab.locator('[data-sheet-chart] .plot-drawing')).toHaveCount(3)
        const where = `${paper} ${language} ${key}`
        const { pages, images, fonts, boxes } = objectsOf(await lab.pdf({ preferCSSPageSize: true }))
        expect(pages, where).toBe(2 + key)
        expect(images, where).toBe(0)
        expect(fonts, where).toBeGreaterThan(0)
        for (const [, , width, height] of boxes)
          expect(
            [width, height].map((each) => Math.round(each ?? 0)),
            where,
          ).toEqual(points)
        expect(await printedFaults(lab, content), where).toEqual([])
      }
    }
  }
  await show(lab, 't=0s')
})

test('story 12: the ruler for pages sees an image and an element that is too wide', async ({ lab }) => {
  await show(lab, 'view=handouts&seed=1&t=0s')
  await lab.evaluate(() => {
    const canvas = document.createElement('canvas')
    canvas.id = 'spoiled'
    canvas.width = 900
    canvas.getContext('2d')?.fillRect(0, 0, 50, 50)
    document.querySelector('.sheet')?.append(canvas)
  })
  expect(objectsOf(await lab.pdf({ preferCSSPageSize: true })).images).toBeGreaterThan(0)
  expect((await printedFaults(lab, PAPERS.A4.content)).length).toBe(1)
  await lab.evaluate(() => document.getElementById('spoiled')?.remove())
  await show(lab, 't=0s')
})

test('story 12: thirty seeds are thirty sheets, and answers stand there with key=1 alone', async ({ lab }) => {
  const sheets = new Set<string>()
  for (let seed = 1; seed <= 30; seed++) {
    await show(lab, `view=handouts&seed=${seed}&key=${seed % 2}&lang=en&t=0s`)
    sheets.add((await lab.locator('.exercises').first().textContent()) ?? '')
    await expect(lab.locator('[data-answer]')).toHaveCount(8 * (seed % 2))
    await expect(lab.locator('.sheet-head').first()).toContainText(`Sheet ${seed}`)
  }
  expect(sheets.size).toBe(30)
  await show(lab, 't=0s')
})

test('story 12: the sheet is chosen by keys, and what cannot be is said', async ({ lab }) => {
  await show(lab, 'view=handouts&lang=en&t=0s')
  await lab.locator('#seed').fill('7')
  await expect(lab.locator('[data-exercise=small]')).toContainText('A pendulum of 113 cm swings by 9°')
  await lab.locator('#seed').fill('0.5')
  await expect(lab.locator('#seed-fault')).toContainText('a whole number from 1 to 999999')
  await expect(lab.locator('[data-exercise=small]')).toContainText('113 cm')
  await lab.locator('#another').press('Enter')
  await expect(lab.locator('#seed')).toHaveValue('8')
  await lab.locator('#key').press('Space')
  await expect(lab.locator('[data-answer]')).toHaveCount(8)
  await expect(lab.locator('[data-answer=small]')).toContainText(/T0 = \d\.\d{3}\ss/)
  await lab.getByRole('button', { name: 'Letter' }).press('Enter')
  await expect
    .poll(() => readLink(new URL(lab.url()).hash).state)
    .toMatchObject({ seed: 8, key: true, paper: 'Letter', view: 'handouts' })
  await show(lab, 't=0s')
})

test('bad values of the hand-outs and of embedding are named', async ({ lab }) => {
  for (const [link, said] of [
    ['seed=0', ['seed=0', '1 to 999999']],
    ['seed=1.5', ['seed=1.5', 'not a whole number']],
    ['seed=x', ['seed=x', 'not a number']],
    ['key=yes', ['key=yes', '1, 0']],
    ['embed=maybe', ['embed=maybe', '1, 0']],
    ['lock=mass', ['lock=mass', 'th0, w0, L, g, curves']],
    ['show=moon', ['show=moon', 'phase', 'pendulum']],
    ['hide=L', ['hide=L', 'g, 0']],
    ['hide=g&g=3.7&view=phase', ['view=phase', 'lab, data']],
    ['handout=poster', ['handout=poster', 'worksheet, code, embed']],
    ['paper=A5', ['paper=A5', 'A4, Letter']],
    ['code=fortran', ['code=fortran', 'scipy']],
  ] as const) {
    await show(lab, `${link}&t=0s&lang=en`)
    await expect(lab.locator('.message'), link).toHaveCount(1)
    for (const text of said) await expect(lab.locator('.message'), link).toContainText(text)
  }
  await show(lab, 'view=lab&t=0s')
  await drawn(lab)
})

test('the offline file has the hand-outs', async ({ browser }) => {
  const context = await browser.newContext({ offline: true })
  const page = await context.newPage()
  await page.goto(`file://${DIST}offline.html#view=handouts&seed=3&key=1&t=0s`)
  await expect(page.locator('[data-sheet-chart] .plot-drawing')).toHaveCount(3)
  await expect(page.locator('[data-answer]')).toHaveCount(8)
  await context.close()
})
