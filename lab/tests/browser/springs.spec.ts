// Springs: what the page says, draws and exports of a spring is the core's; a click and keys set the start; a module is asked for once.

import type { Page } from '@playwright/test'
import { CubicQuintic, Duffing, load, loadMotions, Pendulum } from 'libration'
import { address, column, csvOf, drawn, expect, linkOf, ready, show, test, whole } from './lab'
import { DIST } from './server'

test.beforeAll(async () => {
  await load()
  await loadMotions()
})

test('springs say the escape of a softening spring, and hatch what is after it', async ({ lab }) => {
  await show(lab, 'view=springs&p=1&q=-0.5&u0=1.6&t=0s')
  const spring = new Duffing({ u0: 1.6, p: 1, q: -0.5 })
  await expect(lab.locator('#page .sentence')).toHaveText(
    `The softening spring escapes to infinity at t = ${spring.escapeTime.toFixed(3)}.`,
  )
  await expect(lab.locator('#spring-escape')).toHaveText(spring.escapeTime.toFixed(4))
  await expect(lab.locator('[data-chart=spring-time] .hatched')).toHaveCount(1)
  await expect(lab.locator('[data-chart=spring-time] .plot-note')).toContainText('no motion')
  const sheet = await csvOf(lab, 'spring-time')
  const [t, u] = [column(sheet, 't'), column(sheet, 'u')]
  for (let i = 0; i < t.length - 1; i += 37) expect(u[i]).toBe(spring.motion(t[i] as number).u)
  // The escape itself has no number.
  expect(Number.isNaN(u[u.length - 1] as number)).toBe(true)
  await show(lab, 'view=springs&p=1&q=-0.5&u0=-1.6&t=0s')
  await expect(lab.locator('#page .sentence')).toContainText('minus infinity')
})

test('springs by their examples are in every regime, with the numbers of the core', async ({ lab }) => {
  await show(lab, 'view=springs&th0=150deg&L=1m&g=9.81&t=0s')
  const choose = async (name: string) => {
    await lab.locator('#menu-springs').click()
    await lab.getByRole('menuitem', { name, exact: false }).first().click()
    await drawn(lab)
  }
  for (const [name, said, regime] of [
    ['Hardening spring', 'swings to ±1.5', 'swings about'],
    ['Between two unstable equilibria', 'from one unstable equilibrium to another', 'heteroclinic'],
    ['Double well, inside', 'on one side', 'on one side'],
    ['Double well, on the separatrix', 'on the separatrix', 'homoclinic'],
    ['Double well, outside', 'swings to ±2.1', 'swings about'],
    ['Spring stiffer on one side', 'between −1.402 and 1 once', 'swings'],
    ['Double well, tilted', 'in one of its two wells', 'in one of two wells'],
    ['Quadratic spring, on the separatrix', 'on the separatrix', 'homoclinic'],
    ['Cubic–quintic spring, escapes', 'escapes to infinity', 'escapes'],
  ] as const) {
    await choose(name)
    await expect(lab.locator('#page .sentence')).toContainText(said)
    await expect(lab.locator('#spring-regime')).toContainText(regime)
  }
  await choose('Bistable')
  const quintic = new CubicQuintic({ u0: 0.5, p: 1, q: -4, s: 3 })
  await expect(lab.locator('#spring-period')).toHaveText(quintic.period.toFixed(4))
  await expect(lab.locator('#spring-equilibria tbody tr')).toHaveCount(5)
  await choose('Companion of the pendulum')
  const pendulum = new Pendulum({ theta0: (150 * Math.PI) / 180, length: 1, gravity: 9.81 })
  await expect(lab.locator('#spring-period')).toHaveText(pendulum.period.toFixed(4))
  // One line undoes it.
  await lab.locator('.message').getByRole('button', { name: 'Undo' }).click()
  await expect(lab.locator('#spring-equilibria tbody tr')).toHaveCount(5)
})

test('springs with even powers: the numbers of the core, their fields, and the link', async ({ lab }) => {
  const link = 'spring=helmholtz-duffing&r=0.5&q=0.2&c=0.25&u0=1'
  await show(lab, `view=springs&${link}&t=0s&lang=en`)
  const beam = new Duffing({ u0: 1, p: 1, q: 0.2, r: 0.5, c: 0.25 })
  await expect(lab.locator('#spring-period')).toHaveText(beam.period.toFixed(4))
  await expect(lab.locator('#page .sentence')).toContainText('The spring with even powers swings between')
  const sheet = await csvOf(lab, 'spring-time')
  const [t, u] = [column(sheet, 't'), column(sheet, 'u')]
  for (let i = 0; i < t.length; i += 37) expect(u[i]).toBe(beam.motion(t[i] as number).u)
  expect(await linkOf(lab)).toContain(link)
  await lab.locator('#field-c').fill('1')
  await expect(lab.locator('#spring-period')).toHaveText(
    new Duffing({ u0: 1, p: 1, q: 0.2, r: 0.5, c: 1 }).period.toFixed(4),
  )
  // A force that is the same everywhere has no equilibrium.
  await show(lab, 'view=springs&spring=helmholtz-duffing&p=0&q=0&c=1&t=0s&lang=en')
  await expect(lab.locator('#spring-equilibria tbody')).toContainText('none')
  await expect(lab.locator('#page .sentence')).toContainText('runs away')
  // Duffing's own has neither field.
  await lab.getByRole('button', { name: 'Duffing', exact: true }).click()
  await expect(lab.locator('#field-r, #field-c')).toHaveCount(0)
})

test('springs of any size have charts, and their times digits', async ({ lab }) => {
  const errors: string[] = []
  lab.on('console', (message) => message.type() === 'error' && errors.push(message.text()))
  for (const [link, time] of [
    ['p=1e-6&q=1e-6&u0=1e-300', '6283.1853'],
    ['p=0&q=1&u0=1e-160', '7.416\u00a0×\u00a010160'],
    ['q=1e6&u0=1000&v0=-1e6', '7.416\u00a0×\u00a010−6'],
  ] as const) {
    await show(lab, `view=springs&${link}&t=0s&lang=en`)
    await expect(lab.locator('#spring-period')).toHaveText(time)
  }
  expect(errors).toEqual([])
})

test('springs start where the portrait is clicked, and by the arrow keys', async ({ lab }) => {
  await show(lab, 'view=springs&p=1&q=1&u0=1.5&t=0s')
  const plot = lab.locator('[data-plot=spring-portrait]')
  const box = await plot.boundingBox()
  if (!box) throw new Error('no plot')
  await plot.click({ position: { x: Math.round(0.75 * box.width), y: Math.round(0.25 * box.height) } })
  // It plays from there; the start is in the link.
  await lab.keyboard.press('Space')
  const [, u0 = '', v0 = ''] = /u0=([-\d.]+)&v0=([-\d.]+)/.exec(await linkOf(lab)) ?? []
  expect(Math.abs(Number(u0) - 1)).toBeLessThan(4 / box.width)
  expect(Number(v0)).toBeGreaterThan(0)
  await show(lab, 'view=springs&p=1&q=1&u0=1.5&t=0s')
  await plot.focus()
  await lab.keyboard.press('ArrowLeft')
  await lab.keyboard.press('ArrowUp')
  await drawn(lab)
  const link = await linkOf(lab)
  expect(Number(/u0=([-\d.]+)/.exec(link)?.[1])).toBeLessThan(1.5)
  expect(Number(/v0=([-\d.]+)/.exec(link)?.[1])).toBeGreaterThan(0)
  await expect(plot).toHaveAttribute('aria-valuetext', /velocity .*swings about u = 0/)
})

test('springs stand in the link, and a bad value is named', async ({ lab }) => {
  const link = 'view=springs&spring=cubic-quintic&p=1&q=-4&s=3&u0=0.25&v0=-0.125'
  await show(lab, `${link}&t=0s`)
  expect(await linkOf(lab)).toContain('spring=cubic-quintic&q=-4&s=3&u0=0.25&v0=-0.125')
  await lab.locator('#field-q').fill('much')
  await expect(lab.locator('#field-q-fault')).toContainText('Cubic part')
  await expect(lab.locator('#field-q-fault')).toContainText('not a number')
  await lab.keyboard.press('Escape')
  await show(lab, 'view=springs&u0=2000&spring=steel&t=0s')
  for (const said of ['u0=2000', '−1000 to 1000', 'spring=steel', 'duffing, helmholtz-duffing, cubic-quintic'])
    await expect(lab.locator('.message')).toContainText(said)
  await show(lab, 'view=springs&t=0s')
})

test('springs: their module is asked for when the view opens, once, and nothing after it', async ({ browser }) => {
  const context = await browser.newContext({ serviceWorkers: 'block' })
  const page = await context.newPage()
  const asked: string[] = []
  page.on('request', (request) => asked.push(request.url()))
  await page.goto(`${address()}#view=lab&t=0s`)
  await expect(page.locator('main .plot-drawing').first()).toBeVisible()
  await whole(page)
  const modules = () => asked.filter((url) => url.includes('libration-motions')).length
  expect(modules()).toBe(0)
  await page.locator('[data-view=springs]').click()
  await expect(page.locator('[data-chart=spring-portrait] .plot-drawing').first()).toBeVisible()
  expect(modules()).toBe(1)
  const before = asked.length
  await page.locator('#field-u0').fill('0.7')
  await page.locator('[data-view=lab]').click()
  await page.locator('[data-view=springs]').click()
  await expect(page.locator('[data-chart=spring-portrait] .plot-drawing').first()).toBeVisible()
  expect(asked.length).toBe(before)
  await context.close()
})

/** Both views by their tabs. */
async function openBoth(page: Page): Promise<void> {
  await page.locator('[data-view=springs]').click()
  await expect(page.locator('#spring-regime')).toHaveText('swings about u = 0')
  await page.locator('[data-view=friction]').click()
  await expect(page.locator('#friction-half')).toBeVisible()
}

test('springs and friction are in the offline file, which asks for nothing', async ({ browser }) => {
  const context = await browser.newContext({ offline: true })
  const page = await context.newPage()
  const asked: string[] = []
  page.on('request', (request) => asked.push(request.url()))
  await page.goto(`file://${DIST}offline.html#t=0s`)
  await ready(page)
  await openBoth(page)
  expect(asked.filter((each) => !each.startsWith('data:') && !each.startsWith('blob:')).length).toBe(1)
  await context.close()
})

test('springs that a visit has opened need no network in the third one after it', async ({ browser }) => {
  const context = await browser.newContext()
  const page = await context.newPage()
  const visit = async () => {
    await page.goto('about:blank')
    await page.goto(`${address()}#t=0s`)
    await expect(page.locator('html')).toHaveAttribute('data-kept')
  }
  await visit()
  await openBoth(page)
  // What the worker keeps, it keeps when the module has come.
  const kept = () =>
    page.evaluate(async () => {
      const cache = await caches.open('libration-lab')
      return (await cache.keys()).some(({ url }) => url.includes('libration-motions'))
    })
  await expect.poll(kept).toBe(true)
  const session = await context.newCDPSession(page)
  await session.send('Network.clearBrowserCache')
  await context.setOffline(true)
  await visit()
  await visit()
  await openBoth(page)
  await context.close()
})

test('springs say where their module does not come, and it can be asked for again', async ({ browser }) => {
  const context = await browser.newContext({ serviceWorkers: 'block' })
  const page = await context.newPage()
  await page.route('**/libration-motions*', (route) => route.abort())
  await page.goto(`${address()}#view=springs&t=0s`)
  await expect(page.locator('.refusal')).toContainText('could not be loaded')
  await page.unroute('**/libration-motions*')
  await page.getByRole('button', { name: 'Try again' }).click()
  await expect(page.locator('#spring-regime')).toHaveText('swings about u = 0')
  await context.close()
})
