// Draws docs/lab/*.png: every view in light and dark, on a phone and for a projector, in 256 colours. `npm run pictures`; not part
// of the tests.

import { mkdirSync, readFileSync, writeFileSync } from 'node:fs'
import type { Page } from '@playwright/test'
import { drawn, expect, opened, show, test } from './lab'
import { inPalette } from './palette'

const FOLDER = new URL('../../../docs/lab/', import.meta.url).pathname
const VIEWS = {
  lab: 'th0=150deg&L=1m&g=9.81&curves=linear,harmonic,fourier:4,rk45&t=2.4s',
  phase: 'view=phase&th0=150deg&L=1m&g=9.81&orbits=60deg,0deg;7.5&t=0.9s',
  period: 'view=period&th0=150deg&L=1m&g=9.81&t=0s',
  functions: 'view=functions&th0=150deg&L=1m&g=9.81&t=0.75s',
  derivation: 'view=derivation&th0=150deg&L=1m&g=9.81&t=0.4s&step=5',
  handouts: 'view=handouts&seed=7&t=0s',
  springs: 'view=springs&spring=cubic-quintic&p=1&q=-4&s=3&u0=0.5&t=3s',
  friction: `view=friction&L=9.81m&g=9.81&th0=0deg&linear=0.25&drive=1.5&omega=${2 / 3}&until=100s&t=40s`,
} as const
const SIZES = {
  '1280-light': [1280, 720],
  '1280-dark': [1280, 720],
  '360-light': [360, 740],
  '1920-light': [1920, 1080],
} as const

async function picture(page: Page, name: string): Promise<void> {
  const png = await page.screenshot({ animations: 'disabled' })
  writeFileSync(`${FOLDER}${name}.png`, await inPalette(page, png))
}

for (const [size, [width, height]] of Object.entries(SIZES)) {
  test(`pictures of ${size}`, async ({ browser }) => {
    mkdirSync(FOLDER, { recursive: true })
    const page = await opened(browser, 't=0s', { viewport: { width, height } })
    // From here on, so that no picture is taken on the way to a step, and none says that it stands still.
    await page.emulateMedia({ reducedMotion: 'reduce' })
    for (const [view, link] of Object.entries(VIEWS)) {
      await page.setViewportSize({ width, height })
      await show(page, `${link}&theme=${size.endsWith('dark') ? 'dark' : 'light'}`)
      await expect(page.locator('main .plot-drawing, main .step').first()).toBeVisible()
      // A phone's page at its whole height, so that its play bar stands at the end; a text to read is too long for that.
      const tall = await page.evaluate(() => document.documentElement.scrollHeight)
      await page.setViewportSize({ width, height: width === 360 && !/derivation|handouts/.test(view) ? tall : height })
      // A page of before may have been scrolled.
      if (view !== 'derivation') await page.evaluate(() => scrollTo(0, 0))
      if (view === 'derivation') await expect(page.locator('.step.on h2')).toBeInViewport()
      await drawn(page)
      await expect(page.locator('.section-progress progress')).toHaveCount(0)
      await page.mouse.move(0, 0)
      await picture(page, `${view}-${size}`)
    }
    await page.context().close()
  })
}

for (const [size, [width, height]] of Object.entries(SIZES)) {
  test(`pictures of a fit of ${size}`, async ({ browser }) => {
    const page = await opened(browser, 't=0s', { viewport: { width, height } })
    await show(page, `view=data&t=0s&theme=${size.endsWith('dark') ? 'dark' : 'light'}`)
    await page.locator('#data-length').fill('0.8')
    await page.locator('#data-lengthU').fill('0.001')
    await page.locator('#data-file').setInputFiles(new URL('../record-70deg.csv', import.meta.url).pathname)
    await expect(page.locator('#data-g')).toBeVisible()
    const tall = await page.evaluate(() => document.documentElement.scrollHeight)
    await page.setViewportSize({ width, height: width === 360 ? tall : height })
    await page.locator('h1').first().click()
    await drawn(page)
    await page.mouse.move(0, 0)
    await picture(page, `data-${size}`)
    await page.context().close()
  })

  test(`pictures of a timed period of ${size}`, async ({ browser }) => {
    const page = await opened(browser, 't=0s', { viewport: { width, height } })
    await show(page, `view=data&from=period&t=0s&theme=${size.endsWith('dark') ? 'dark' : 'light'}`)
    await page.locator('#timing-example').click()
    await page.locator('#timing-latitude').fill('-23.3')
    await page.locator('#timing-height').fill('585')
    await expect(page.locator('#timing-difference')).toBeVisible()
    const tall = await page.evaluate(() => document.documentElement.scrollHeight)
    await page.setViewportSize({ width, height: width === 360 ? tall : height })
    await page.locator('h1').first().click()
    await drawn(page)
    await page.mouse.move(0, 0)
    await picture(page, `data-period-${size}`)
    await page.context().close()
  })
}

test('pictures of code and of the form of a frame', async ({ browser }) => {
  const page = await opened(browser, 't=0s&theme=light')
  for (const part of ['code', 'embed']) {
    await show(page, `view=handouts&handout=${part}&th0=150deg&t=0s&theme=light&lang=en`)
    await picture(page, `handouts-${part}-1280-light`)
  }
  await page.context().close()
})

test('a picture of a spring with even powers', async ({ browser }) => {
  const page = await opened(browser, 't=0s&theme=light')
  await show(page, 'view=springs&spring=helmholtz-duffing&p=-1&q=1&c=0.125&u0=-1.25&t=2s&theme=light&lang=en')
  await expect(page.locator('[data-chart=spring-time] .plot-drawing')).toBeVisible()
  await picture(page, 'springs-even-1280-light')
  await page.context().close()
})

test('pictures of a light gate and of several lengths', async ({ browser }) => {
  const page = await opened(browser, 't=0s')
  await show(page, 'view=data&t=0s&theme=light')
  await page.locator('#data-length').fill('0.8')
  await page.locator('#data-lengthU').fill('0.001')
  await page.locator('#data-file').setInputFiles(new URL('../gate-100deg.csv', import.meta.url).pathname)
  await expect(page.locator('#data-period0')).toBeVisible()
  await page.locator('h1').first().click()
  await drawn(page)
  await picture(page, 'data-gate-1280-light')
  const [several] = JSON.parse(readFileSync(new URL('../fits.json', import.meta.url), 'utf8'))
  const files = (several.files as { name: string; text: string }[]).map(({ name, text }) => ({
    name,
    mimeType: 'text/plain',
    buffer: Buffer.from(text),
  }))
  await page.locator('#data-file').setInputFiles(files)
  await expect(page.locator('#data-records')).toBeVisible()
  for (const [i, length] of ['0.400', '0.700', '1.000'].entries()) {
    await page.locator(`#data-length-${i}`).fill(length)
    await page.locator(`#data-lengthU-${i}`).fill('0.0005')
  }
  await page.locator('h1').first().click()
  await expect(page.locator('#data-offset')).toBeVisible()
  await drawn(page)
  await picture(page, 'data-lengths-1280-light')
  await page.context().close()
})

test('pictures of the errors a link may have', async ({ browser }) => {
  const page = await opened(browser, 'th0=200deg&L=1m&curves=magic&t=0s&theme=light')
  await page.locator('#field-length').fill('0')
  await picture(page, 'faults-1280-light')
  await page.context().close()
})

test('a picture of the errors against the step', async ({ browser }) => {
  const page = await opened(browser, `${VIEWS.lab}&theme=light`)
  await page.locator('#convergence').click()
  await expect(page.locator('dialog .plot-drawing')).toBeVisible()
  await drawn(page)
  await picture(page, 'convergence-1280-light')
  await page.context().close()
})
