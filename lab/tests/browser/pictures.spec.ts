// Draws docs/lab/*.png: every view in light and dark, on a phone and for a projector. `npm run pictures`; not part of the tests.

import { mkdirSync } from 'node:fs'
import { drawn, expect, opened, show, test } from './lab'

const FOLDER = new URL('../../../docs/lab/', import.meta.url).pathname
const VIEWS = {
  lab: 'th0=150deg&L=1m&g=9.81&curves=linear,harmonic,fourier:4,rk45&t=2.4s',
  phase: 'view=phase&th0=150deg&L=1m&g=9.81&orbits=60deg,0deg;7.5&t=0.9s',
  period: 'view=period&th0=150deg&L=1m&g=9.81&t=0s',
  functions: 'view=functions&th0=150deg&L=1m&g=9.81&t=0.75s',
} as const
const SIZES = {
  '1280-light': [1280, 720],
  '1280-dark': [1280, 720],
  '360-light': [360, 740],
  '1920-light': [1920, 1080],
} as const

for (const [size, [width, height]] of Object.entries(SIZES)) {
  test(`pictures of ${size}`, async ({ browser }) => {
    mkdirSync(FOLDER, { recursive: true })
    const page = await opened(browser, 't=0s', { viewport: { width, height } })
    for (const [view, link] of Object.entries(VIEWS)) {
      await page.setViewportSize({ width, height })
      await show(page, `${link}&theme=${size.endsWith('dark') ? 'dark' : 'light'}`)
      await expect(page.locator('main .plot-drawing').first()).toBeVisible()
      // A phone's page at its whole height, so that its play bar stands at the end.
      const tall = await page.evaluate(() => document.documentElement.scrollHeight)
      await page.setViewportSize({ width, height: width === 360 ? tall : height })
      await drawn(page)
      await page.mouse.move(0, 0)
      await page.screenshot({ path: `${FOLDER}${view}-${size}.png`, animations: 'disabled' })
    }
    await page.context().close()
  })
}

test('pictures of the errors a link may have', async ({ browser }) => {
  const page = await opened(browser, 'th0=200deg&L=1m&curves=magic&t=0s&theme=light')
  await page.locator('#field-length').fill('0')
  await page.screenshot({ path: `${FOLDER}faults-1280-light.png`, animations: 'disabled' })
  await page.context().close()
})
