// What the stories share: one page of the lab for each worker, its state by the address, its numbers as the page exports them.

import { readFile } from 'node:fs/promises'
import { type Browser, type BrowserContextOptions, test as base, expect, type Page } from '@playwright/test'

export { expect }

export const address = (): string => process.env.LAB_ADDRESS as string

/** A page of its own, opened by a link; ready when the exact core is. */
export async function opened(browser: Browser, link = '', options: BrowserContextOptions = {}): Promise<Page> {
  const context = await browser.newContext({ serviceWorkers: 'block', ...options })
  const page = await context.newPage()
  await page.goto(`${address()}#${link}`)
  await ready(page)
  return page
}

export async function ready(page: Page): Promise<void> {
  await expect(page.locator('main .plot-drawing').first()).toBeVisible()
  await page.evaluate(() => document.fonts.ready)
}

/** Waits until every part of the page has come: the scripts that its first one asks for later, and the fonts of their styles. */
export async function whole(page: Page): Promise<void> {
  const missing = () =>
    page.evaluate(async () => {
      const first = document.querySelector<HTMLScriptElement>('script[type=module]')?.src ?? ''
      const script = await (await fetch(first, { cache: 'force-cache' })).text()
      const named = [...script.matchAll(/import\([`'"]\.\/([^`'"]+\.js)/g)].map(([, name]) => name as string)
      const loaded = performance.getEntriesByType('resource').map(({ name }) => name)
      const absent = named.filter((name) => !loaded.some((each) => each.endsWith(name)))
      return named.length === 0 || !document.fonts.check('1em "Libration Formulas"') ? ['parts'] : absent
    })
  await expect.poll(missing).toEqual([])
}

interface Shared {
  /** One page for all stories of a worker: each sets its state by the address. */
  readonly lab: Page
}

export const test = base.extend<object, Shared>({
  lab: [
    async ({ browser }, use) => {
      const page = await opened(browser, 't=0s')
      const errors: string[] = []
      page.on('pageerror', (error) => errors.push(String(error)))
      await use(page)
      expect(errors).toEqual([])
      await page.context().close()
    },
    { scope: 'worker', timeout: 240_000 },
  ],
})

/** Two frames: what was asked for is drawn and measured. */
export async function drawn(page: Page): Promise<void> {
  await page.evaluate(
    () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(done, 0)))),
  )
}

/** Shows the state of a link in a page that is open. It stands at the time of the link. */
export async function show(page: Page, link: string): Promise<void> {
  // The same link twice is no change for a browser, so another one first.
  await page.evaluate((hash) => {
    for (const close of document.querySelectorAll<HTMLElement>('.message [data-tool=close]')) close.click()
    history.replaceState(null, '', '#')
    location.hash = hash
  }, link)
  await drawn(page)
  await expect(page.locator('#still')).toBeHidden()
  // The parts that follow the first are there.
  await expect(page.locator('.waiting-line')).toHaveCount(0)
}

/** The link that the page has written for what it shows. */
export async function linkOf(page: Page): Promise<string> {
  await page.locator('#share').click()
  const link = await page.locator('#share-link').inputValue()
  await page.keyboard.press('Escape')
  await expect(page.locator('dialog')).toHaveCount(0)
  return link
}

export interface Sheet {
  readonly about: string
  readonly link: string
  readonly header: readonly string[]
  readonly columns: Readonly<Record<string, Float64Array>>
  readonly text: string
}

/** The CSV of a chart, as a reader saves it; decimal point. Closes the table behind it. */
export async function csvOf(page: Page, chart: string): Promise<Sheet> {
  const figure = page.locator(`[data-chart=${chart}]`)
  const tool = figure.locator('[data-tool=table]')
  // A table that was just closed stands until its frame.
  await drawn(page)
  if ((await tool.getAttribute('aria-pressed')) !== 'true') await tool.click()
  const saving = page.waitForEvent('download')
  await figure.getByRole('button', { name: 'CSV', exact: true }).click()
  const text = await readFile(await (await saving).path(), 'utf8')
  await tool.click()
  return sheet(text)
}

/** A CSV as columns of doubles; an empty cell is NaN. */
export function sheet(text: string, between = ',', point = '.'): Sheet {
  const lines = text.replace(/^\ufeff/, '').split('\r\n')
  const [about = '', link = ''] = lines.filter((line) => line.startsWith('#')).map((line) => line.slice(2))
  const [head = '', ...rows] = lines.filter((line) => line !== '' && !line.startsWith('#'))
  // Titles with a separator of their own stand in quotes; a space that does not break is a space.
  const header = [...head.matchAll(/"((?:[^"]|"")*)"|[^",;]+/g)].map(([all, inside]) =>
    (inside ?? all).replaceAll('""', '"').replaceAll('\u00a0', ' '),
  )
  const cells = rows.map((row) =>
    row.split(between).map((cell) => (cell === '' ? Number.NaN : Number(cell.replace(point, '.')))),
  )
  const columns: Record<string, Float64Array> = {}
  header.forEach((name, i) => {
    columns[name] = Float64Array.from(cells, (row) => row[i] ?? Number.NaN)
  })
  return { about, link, header, columns, text }
}

export function column(of: Sheet, name: string): Float64Array {
  const found = of.columns[name]
  if (!found) throw new Error(`no column ${name}: ${of.header.join(', ')}`)
  return found
}

/** Largest size; NaN if any value is NaN, so that nothing is close to nothing. */
export function largest(values: ArrayLike<number>): number {
  return Array.from(values).reduce((most, value) => (Number.isNaN(value) ? value : Math.max(most, Math.abs(value))), 0)
}

export const radians = (degrees: number): number => (degrees * Math.PI) / 180
