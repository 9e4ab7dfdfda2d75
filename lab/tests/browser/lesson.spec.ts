// A teacher's lesson from the first click to the pupils' phones, with its clicks counted; docs/lab.md tells it in these numbers.

import { readFileSync } from 'node:fs'
import type { Locator, Page } from '@playwright/test'
import { expect, heldTimers, opened, ready, test } from './lab'

const GUIDE = new URL('../../../docs/lab.md', import.meta.url).pathname

const result = (page: Page, key: string): Locator =>
  page.locator('.row', { has: page.locator(`[id="curve-${key}"]`) }).locator('.result')

/** What the lesson is about, as a page shows it. */
async function findings(page: Page): Promise<string[]> {
  const errors = await Promise.all(['linear', 'harmonic', 'fourier:4'].map((key) => result(page, key).textContent()))
  return [await page.locator('#period-value').textContent(), ...errors].map((text) =>
    (text ?? '').replaceAll('\u00a0', ' '),
  )
}

test('lesson: 150 degrees, three formulas, the period, a link, a phone', async ({ browser }) => {
  const page = await opened(browser, 'th0=30deg&t=0s', { permissions: ['clipboard-read', 'clipboard-write'] })
  let clicks = 0
  const click = async (place: Locator) => {
    clicks++
    await place.click()
  }
  // The angle is typed.
  await click(page.locator('#field-theta0'))
  await page.keyboard.press('Control+a')
  await page.keyboard.type('150')
  await expect(page.locator('#page .sentence')).toContainText('Released at 150°')
  // Of the curves that are there, the three formulas; their largest errors over one period, as Lima has them.
  await click(page.locator('[id="curve-rk45"]'))
  await click(page.getByRole('group', { name: 'Shown' }).getByRole('button', { name: '1 T' }))
  await expect(page.locator('.compare .caption')).toContainText('largest error over 1 T')
  const seen = await findings(page)
  // The link, to the clipboard.
  await click(page.locator('#share'))
  await heldTimers(page, 2000)
  await click(page.getByRole('button', { name: 'Copy link' }))
  await expect(page.getByRole('button', { name: 'Copied' })).toBeVisible()
  const link = await page.evaluate(() => navigator.clipboard.readText())
  await page.context().close()
  // A phone that opens it shows the same, and nothing is wider than it.
  const context = await browser.newContext({
    serviceWorkers: 'block',
    viewport: { width: 360, height: 740 },
    hasTouch: true,
    isMobile: true,
    // It stands at the start: played on, the plots would go over to the second period.
    reducedMotion: 'reduce',
  })
  const phone = await context.newPage()
  await phone.goto(link)
  await ready(phone)
  await expect(phone.locator('#page .sentence')).toContainText('Released at 150°')
  await expect(phone.locator('[data-chart=angle] path.c')).toHaveCount(4)
  expect(await findings(phone)).toEqual(seen)
  expect(await phone.evaluate(() => document.documentElement.scrollWidth)).toBe(360)
  await context.close()
  // The guide says what was seen.
  const guide = readFileSync(GUIDE, 'utf8')
  for (const value of seen) expect(guide).toContain(value)
  expect(guide).toContain(`**${clicks} clicks**`)
})
