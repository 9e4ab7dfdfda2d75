// What the stories share: one page of the lab for each worker, its state by the address, its numbers as the page exports them.

import { type Browser, type BrowserContextOptions, test as base, expect, type Frame, type Page } from '@playwright/test'

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

/** Waits until every part of the page has come: what is asked for after it is for a view. */
export async function whole(page: Page | Frame): Promise<void> {
  await expect(page.locator('html')).toHaveAttribute('data-whole', '')
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
    { scope: 'worker', timeout: 900_000 },
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
  const whole = await page.evaluate(async (hash) => {
    for (const close of document.querySelectorAll<HTMLElement>('.message [data-tool=close]')) close.click()
    // The same link twice is no change for a browser, so another one first.
    history.replaceState(null, '', '#')
    location.hash = hash
    // The page hears of it before this does. Of a link before it may be heard first.
    const { href } = location
    await new Promise<void>((done) => {
      addEventListener('hashchange', function heard({ newURL }) {
        if (newURL !== href) return
        removeEventListener('hashchange', heard)
        done()
      })
    })
    const frame = () => new Promise((done) => requestAnimationFrame(done))
    await frame()
    await frame()
    return document.querySelector('#still:not([hidden]), .waiting-line') === null
  }, link)
  if (whole) return
  await expect(page.locator('#still')).toBeHidden()
  // The parts that follow the first are there.
  await expect(page.locator('.waiting-line')).toHaveCount(0)
}

/** Timers of a page that wait for the test, of so many ms: how many there are, and what they do when it lets them. */
export async function heldTimers(page: Page, ms: number) {
  await page.evaluate((held) => {
    const [set, clear] = [window.setTimeout, window.clearTimeout]
    const waiting = new Map<number, () => void>()
    let last = 0
    Object.assign(window, {
      waiting,
      setTimeout: (act: () => void, time?: number, ...rest: unknown[]) => {
        if (time !== held) return set(act, time, ...rest)
        waiting.set(--last, act)
        return last
      },
      clearTimeout: (id?: number) => (id !== undefined && id < 0 ? waiting.delete(id) : clear(id)),
      letTimersGo: () => Object.assign(window, { setTimeout: set, clearTimeout: clear }),
    })
  }, ms)
  type Held = { waiting: Map<number, () => void>; letTimersGo: () => void }
  return {
    count: () => page.evaluate(() => (window as unknown as Held).waiting.size),
    fire: () =>
      page.evaluate(() => {
        const { waiting } = window as unknown as Held
        const all = [...waiting.values()]
        waiting.clear()
        for (const act of all) act()
      }),
    /** The page has its own again; what still waits is done. */
    end: () =>
      page.evaluate(() => {
        const { waiting, letTimersGo } = window as unknown as Held
        letTimersGo()
        for (const act of waiting.values()) act()
      }),
  }
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

/** Lets the page save a file by a click of the test, and has its text instead of the file. */
export async function savedText(page: Page, click: () => Promise<void>): Promise<string> {
  await page.evaluate(() => {
    const kept = window as unknown as { saved: Promise<string> }
    const { createObjectURL } = URL
    const { click: usual } = HTMLAnchorElement.prototype
    kept.saved = new Promise((done) => {
      URL.createObjectURL = (of: Blob) => {
        URL.createObjectURL = createObjectURL
        const decoder = new TextDecoder('utf-8', { ignoreBOM: true })
        void of.arrayBuffer().then((bytes) => done(decoder.decode(bytes)))
        return 'about:blank'
      }
    })
    HTMLAnchorElement.prototype.click = function act() {
      HTMLAnchorElement.prototype.click = usual
      if (!this.download) usual.call(this)
    }
  })
  await click()
  return page.evaluate(() => (window as unknown as { saved: Promise<string> }).saved)
}

/** The CSV of a chart, as a reader saves it from its table; decimal point. Closes the table behind it. */
export async function csvOf(page: Page, chart: string): Promise<Sheet> {
  const figure = page.locator(`[data-chart=${chart}]`)
  await expect(figure.locator('[data-tool=table]')).toBeVisible()
  const text = await savedText(page, () =>
    figure.evaluate(async (element) => {
      const frame = () => new Promise((done) => requestAnimationFrame(done))
      const tool = element.querySelector<HTMLElement>('[data-tool=table]')
      const button = () =>
        [...element.querySelectorAll<HTMLElement>('caption button')].find(
          ({ textContent }) => textContent?.trim() === 'CSV',
        )
      // A table that was just closed stands until its frame.
      await frame()
      await frame()
      if (tool?.getAttribute('aria-pressed') !== 'true') tool?.click()
      while (!button()) await frame()
      button()?.click()
      tool?.click()
      await frame()
    }),
  )
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
