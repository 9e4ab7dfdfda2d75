// Story 8: the derivation line by line with the reader's own numbers, its steps by keys, and the errata of the papers.

import type { Page } from '@playwright/test'
import { drawn, expect, opened, show, test } from './lab'

interface Bound {
  readonly id: string
  readonly left: number
  readonly right: number
  readonly apart: number
  readonly text: string
}

/** The page's own list: what each displayed equality is bound to; those without numbers say why. */
function bound(page: Page): Promise<Bound[]> {
  return page.locator('[data-equality]').evaluateAll((all) =>
    all.map((each) => {
      const { equality, left, right, apart } = (each as HTMLElement).dataset
      const text = each.querySelector('.sides')?.textContent?.replace(/\s+/g, ' ').trim() ?? ''
      const number = (value: string | undefined) => (value === undefined ? Number.NaN : Number(value))
      return { id: equality ?? '', left: number(left), right: number(right), apart: number(apart), text }
    }),
  )
}

const reading = (page: Page, erratum: string, key: string): Promise<number> =>
  page.locator(`[data-erratum=${erratum}] [data-reading=${key}]`).first().getAttribute('data-exact').then(Number)

const ENTRIES = ['novice', 'lima', 'salas'] as const

test('story 8: both sides of every displayed equality are the same number', async ({ lab }) => {
  for (const entry of ENTRIES) {
    for (const state of [
      'th0=150deg&t=0.4s',
      'th0=-60deg&w0=2&t=7.3s',
      'th0=30deg&w0=9&L=0.7m&t=2.1s',
      'th0=0deg&t=1s',
    ]) {
      await show(lab, `view=derivation&entry=${entry}&${state}`)
      const all = await bound(lab)
      expect(all.length).toBeGreaterThan(10)
      const shown = all.filter(({ left }) => !Number.isNaN(left))
      expect(shown.length, `${entry} ${state}`).toBeGreaterThan(state.startsWith('th0=0deg') ? 0 : 5)
      for (const { id, left, right, apart, text } of shown) {
        // The sides as they are, and their difference against what they are measured by.
        const size = Math.max(Math.abs(left), Math.abs(right))
        expect([id, state, apart <= 1e-9]).toEqual([id, state, true])
        if (size > 1e-3)
          expect([id, state, Math.abs(left - right) <= 1e-8 * Math.max(size, 1)]).toEqual([id, state, true])
        expect(text).toMatch(/digits agree$/)
      }
      for (const { text } of all.filter(({ left }) => Number.isNaN(left))) expect(text).toMatch(/\.$/)
    }
  }
})

test('story 8: another angle, another time, and every number is another one', async ({ lab }) => {
  // What no angle and no time changes.
  const fixed = new Set(['omega0', 'small-period', 'ellipse', 'nine-second', 'duffing-rate', 'nine-first'])
  const ofOrbit =
    /^(energy|kappa|circle|turning|separatrix|quarter|period|mean|ratio|period-series|start-.*|nome|coefficient|series-sum|duffing-energy|ten-.*|duffing-parameter|salas-.*)$/
  for (const entry of ENTRIES) {
    await show(lab, `view=derivation&entry=${entry}&th0=150deg&w0=1&t=0.4s`)
    const before = await bound(lab)
    await lab.locator('#field-theta0').fill('110')
    await lab.keyboard.press('Enter')
    await drawn(lab)
    const after = await bound(lab)
    for (const [i, { id, left }] of before.entries()) {
      if (Number.isNaN(left) || fixed.has(id) || id === 'small-sn' || id === 'time' || id === 'start-cosine') continue
      expect([entry, id, after[i]?.left !== left]).toEqual([entry, id, true])
    }
    await lab.locator('#field-t-bar').fill('0.9')
    await lab.keyboard.press('Enter')
    await drawn(lab)
    const later = await bound(lab)
    for (const [i, { id, left }] of after.entries()) {
      if (Number.isNaN(left) || fixed.has(id) || ofOrbit.test(id)) continue
      expect([entry, id, later[i]?.left !== left]).toEqual([entry, id, true])
    }
  }
})

test('story 8: a swing whose numbers no double holds says so', async ({ lab }) => {
  for (const entry of ['novice', 'lima', 'salas']) {
    await show(lab, `view=derivation&entry=${entry}&th0=1e-300rad&L=1m&g=9.81&t=0.7s&lang=en`)
    await expect(lab.locator('.sides').filter({ hasText: 'smaller than the computer can hold' }).first()).toBeVisible()
    await expect(lab.locator('.sides').filter({ hasText: '12 digits agree' }).first()).toBeVisible()
    await expect(lab.locator('.sides').filter({ hasText: /NaN|∞/ })).toHaveCount(0)
  }
})

test('story 8: numbers go on with the time while it plays', async ({ lab }) => {
  await show(lab, 'view=derivation&th0=150deg&t=0s')
  const left = () => lab.locator('[data-equality=pendulum]').getAttribute('data-left')
  const before = await left()
  await lab.locator('#play').click()
  await expect.poll(left).not.toBe(before)
  await lab.locator('#play').click()
})

test('story 8: next and previous step by keys, and in the link', async ({ lab }) => {
  await show(lab, 'view=derivation&th0=150deg&t=0s')
  await expect(lab.locator('.step.on')).toHaveAttribute('id', 'step-1')
  await expect(lab.locator('[data-step=back]')).toBeDisabled()
  await lab.evaluate(() => (document.activeElement as HTMLElement | null)?.blur())
  await lab.keyboard.press('n')
  await lab.keyboard.press('n')
  await expect(lab.locator('.step.on')).toHaveAttribute('id', 'step-3')
  await expect(lab.locator('#page .sentence')).toContainText('Step 3 of 9')
  await expect(lab.locator('#step-3 h2')).toBeInViewport()
  await lab.keyboard.press('p')
  await expect(lab.locator('.step.on')).toHaveAttribute('id', 'step-2')
  for (let i = 0; i < 12; i++) await lab.keyboard.press('n')
  await expect(lab.locator('.step.on')).toHaveAttribute('id', 'step-9')
  await expect(lab.locator('[data-step=next]')).toBeDisabled()
  await lab.keyboard.press('s')
  expect(await lab.locator('#share-link').inputValue()).toContain('step=9')
  await lab.keyboard.press('Escape')
  await expect(lab.locator('dialog')).toHaveCount(0)
  await lab.keyboard.press('?')
  await expect(lab.locator('dialog')).toContainText('next step, previous step')
  await lab.keyboard.press('Escape')
  await expect(lab.locator('dialog')).toHaveCount(0)
  // Another way through begins at its first step.
  await lab.getByRole('button', { name: 'Readers of Salas' }).click()
  await expect(lab.locator('.step.on')).toHaveAttribute('id', 'step-1')
  await expect(lab.locator('.step')).toHaveCount(7)
  // The step that has the focus is the current one.
  await show(lab, 'view=derivation&entry=lima&step=4&th0=150deg&t=0s')
  await expect(lab.locator('#step-4 h2')).toBeInViewport()
  await lab.locator('#step-5 h2').click()
  await expect(lab.locator('.step.on')).toHaveAttribute('id', 'step-5')
  await show(lab, 'view=derivation&step=17&th0=150deg&t=0s')
  await expect(lab.locator('.messages')).toContainText('step=17')
})

test('story 8: errata, each with what the printed line gives', async ({ lab }) => {
  const close = (a: number, b: number) => Math.abs(a - b) <= 1e-9 * Math.max(1, Math.abs(b))
  for (const [entry, names] of [
    ['novice', ['salas-25', 'horsley-3']],
    ['lima', ['lima-16']],
    ['salas', ['salas-9', 'salas-10', 'salas-25', 'salas-26', 'salas-27', 'salas-28']],
  ] as const) {
    for (const state of ['th0=150deg&t=0.4s', 'th0=60deg&w0=1&t=1.7s']) {
      await show(lab, `view=derivation&entry=${entry}&${state}`)
      await expect(lab.locator('[data-erratum]')).toHaveCount(names.length)
      for (const name of names) {
        const [printed, corrected, truth] = await Promise.all([
          reading(lab, name, 'printed'),
          reading(lab, name, 'corrected'),
          reading(lab, name, 'truth'),
        ])
        expect([name, close(printed, truth)]).toEqual([name, false])
        const approximate = /salas-2[678]/.test(name)
        expect([name, approximate ? Math.abs(corrected / truth - 1) < 0.2 : close(corrected, truth)]).toEqual([
          name,
          true,
        ])
      }
    }
  }
  // Where the printed line has no real value it says so, and what the arcsine is asked for.
  await show(lab, 'view=derivation&entry=novice&th0=150deg&t=0.4s')
  await expect(lab.locator('[data-erratum=horsley-3]')).toContainText('no real value: the arcsine of 1.')
  await show(lab, 'view=derivation&entry=salas&th0=0deg&w0=8&t=0.1s')
  await expect(lab.locator('[data-erratum=salas-25]')).toContainText('no real value')
  await expect(lab.locator('[data-erratum=salas-26]')).toContainText('not about this motion')
})

test('story 8: no formula is wider than a phone, and functions are called as the language calls them', async ({
  browser,
}) => {
  const page = await opened(browser, 'th0=150deg&t=0s', { viewport: { width: 360, height: 740 } })
  for (const [language, sine] of [
    ['en', 'sin'],
    ['pt-BR', 'sen'],
    ['es', 'sen'],
  ] as const) {
    for (const entry of ENTRIES) {
      await show(page, `view=derivation&entry=${entry}&th0=150deg&t=0.4s&lang=${language}`)
      const wide = await page
        .locator('.step math')
        .evaluateAll((all) =>
          all.filter((each) => each.getBoundingClientRect().right > innerWidth).map((each) => each.textContent),
        )
      expect(wide).toEqual([])
      const named = await page.locator('.step math mi').allTextContents()
      expect(named).toContain(sine)
      expect(named.includes(sine === 'sin' ? 'sen' : 'sin')).toBe(false)
    }
  }
  // Set in the page's own font, which has the table for formulas.
  expect(await page.evaluate(() => document.fonts.check('1em "Libration Formulas"'))).toBe(true)
  await page.context().close()
})
