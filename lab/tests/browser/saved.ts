// What the menus "Save" give, as a reader takes it: the file of a choice, and a film made in its dialog.

import { readFile } from 'node:fs/promises'
import type { Locator, Page } from '@playwright/test'
import { Pendulum } from 'libration'
import { expect, radians } from './lab'

export const LINK = 'th0=150deg&L=1m&g=9.81&t=0s'
export const SWING = () => new Pendulum({ theta0: radians(150), length: 1, gravity: 9.81 })

export const menuOf = (page: Page, chart: string): Locator =>
  page.locator(chart === 'pendulum' ? '.drawing .menu.save > button' : `[data-chart=${chart}] .menu.save > button`)

/** What a choice of a menu saves. */
export async function saved(page: Page, chart: string, item: RegExp): Promise<{ bytes: Buffer; name: string }> {
  await menuOf(page, chart).click()
  const saving = page.waitForEvent('download')
  await page.getByRole('menuitem', { name: item }).click()
  const file = await saving
  return { bytes: await readFile(await file.path()), name: file.suggestedFilename() }
}

export async function openFilm(page: Page): Promise<Locator> {
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
export async function film(page: Page, { format, width = 320, rate = 25, shows = /one/ }: Choice) {
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
