// What the tests of the view Data share: the view in a page of its own, files, what is typed, made records.

import { readFile } from 'node:fs/promises'
import type { Browser, Page } from '@playwright/test'
import { Pendulum } from 'libration'
import { address, expect, opened, show, whole } from './lab'

export const RECORD = new URL('../record-70deg.csv', import.meta.url).pathname
export const WANTED = JSON.parse(await readFile(RECORD.replace('.csv', '.json'), 'utf8'))

const VIEW = 'view=data&t=0s&lang=en'

/** The view in a page of its own: what is measured stays with a visit. */
export async function opening(browser: Browser): Promise<{ readonly page: Page }> {
  const context = await browser.newContext({ serviceWorkers: 'block' })
  const page = await context.newPage()
  await page.goto(`${address()}#${VIEW}`)
  await expect(page.locator('#data-file')).toBeAttached()
  return { page }
}

/** The same in a page that has loaded all of its parts, with the addresses that it asks for from then on. */
export async function watched(browser: Browser) {
  const page = await opened(browser, 't=0s&lang=en')
  await whole(page)
  const asked: string[] = []
  page.on('request', (request) => asked.push(request.url()))
  await show(page, VIEW)
  await expect(page.locator('#data-file')).toBeAttached()
  return { page, asked }
}

export async function give(page: Page, name: string, text: string): Promise<void> {
  await page.locator('#data-file').setInputFiles({ name, mimeType: 'text/plain', buffer: Buffer.from(text) })
}

export async function state(page: Page, length: string, u: string): Promise<void> {
  await page.locator('#data-length').fill(length)
  await page.locator('#data-lengthU').fill(u)
  await page.locator('#data-lengthU').blur()
}

/** `9.81 ± 0.01 m/s²` as its two numbers. */
export const numbers = (text: string | null): number[] => [...(text ?? '').matchAll(/\d+(?:\.\d+)?/g)].map(Number)

/** A swing of 0.8 m from 1 rad, 30 times a second, with a scatter of some 0.002 rad. */
export function swing(count: number, rate = 30) {
  const pendulum = new Pendulum({ theta0: 1, length: 0.8, gravity: 9.81 })
  let seed = 1
  const scatter = () => {
    seed = (seed * 48271) % 2147483647
    return 0.007 * (seed / 2147483647 - 0.5)
  }
  const t = Array.from({ length: count }, (_, i) => i / rate)
  const { theta, velocity } = pendulum.motion(Float64Array.from(t))
  return t.map((time, i) => ({
    t: time,
    theta: (theta[i] as number) + scatter(),
    velocity: (velocity[i] as number) + 3 * scatter(),
  }))
}

export type Row = ReturnType<typeof swing>[number]
export const rows = (
  head: string,
  each: (row: Row) => readonly number[],
  between: string,
  point = '.',
  count = 300,
  rate = 30,
) =>
  `${head}\n${swing(count, rate)
    .map((row) =>
      each(row)
        .map((value) => value.toFixed(6).replace('.', point))
        .join(between),
    )
    .join('\n')}\n`
export const angle = ({ t, theta }: Row) => [t, (theta * 180) / Math.PI]
export const place = ({ t, theta }: Row) => [t, 0.8 * Math.sin(theta) + 0.1, -0.8 * Math.cos(theta) + 0.2]

/** T, the length and the swing of the story, as they are typed. */
export async function time(page: Page, all: Readonly<Record<string, string>>): Promise<void> {
  for (const [name, text] of Object.entries(all)) await page.locator(`#timing-${name}`).fill(text)
}

export const GATE = RECORD.replace('record-70deg', 'gate-100deg')

/** Tables of periods against release angles at three lengths, each 12 mm short. */
export const LENGTHS = JSON.parse(await readFile(RECORD.replace('record-70deg.csv', 'fits.json'), 'utf8'))[0]
