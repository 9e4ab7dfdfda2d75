// Stories 10 and 13: links carry all of the picture, old ones open, bad ones are named; no network is needed after loading.

import type { Page } from '@playwright/test'
import { encode } from 'uqr'
import { readLink } from '../../src/link'
import { keptLinks } from '../links'
import { address, drawn, expect, linkOf, opened, ready, show, test, whole } from './lab'
import { DIST } from './server'

/** The drawn charts as text, without the comments in which the renderer keeps its places. */
const charts = (page: Page): Promise<string[]> =>
  page.locator('.plot-drawing').evaluateAll((all) => all.map((each) => each.outerHTML.replace(/<!--.*?-->/gs, '')))

test('story 10: a shared link opens the same state and draws the same charts in a fresh profile', async ({
  lab,
  browser,
}) => {
  await show(lab, 'th0=150deg&L=1m&g=9.81&curves=harmonic,fourier:4,trigonometric,rk45&span=T&t=1.234s')
  const link = await linkOf(lab)
  expect(link.length).toBeLessThanOrEqual(300)
  expect(link).toContain('#v=1&th0=150deg&L=1m&g=9.81&curves=harmonic,fourier:4,trigonometric,rk45&t=1.234s&span=T')
  const before = await charts(lab)
  expect(before.length).toBe(4)
  const fresh = await opened(browser, link.replace(/^.*#/, ''))
  await drawn(fresh)
  expect(await linkOf(fresh)).toBe(link)
  await expect.poll(() => charts(fresh)).toEqual(before)
  await fresh.context().close()
  // The QR code is that of the link.
  await lab.locator('#share').click()
  const { size, data } = encode(link, { ecc: 'L', border: 0 })
  const d = data.flatMap((line, y) => line.flatMap((dark, x) => (dark ? [`M${x} ${y}h1v1h-1z`] : []))).join('')
  await expect(lab.locator('dialog svg.qr path').last()).toHaveAttribute('d', d)
  await expect(lab.locator('dialog svg.qr')).toHaveAttribute('viewBox', `-4 -4 ${size + 8} ${size + 8}`)
  await expect(lab.locator('dialog')).toContainText(`${link.length} characters`)
  await lab.keyboard.press('Escape')
  await expect(lab.locator('#share')).toBeFocused()
})

test('story 10: a link that nobody else can open says so, in every language; that of a server does not', async ({
  lab,
  browser,
}) => {
  for (const [language, said] of [
    ['en', 'This address is of your own machine. Put the page on a server first'],
    ['pt-BR', 'Este endereço é da sua própria máquina. Ponha antes a página num servidor'],
    ['es', 'Esta dirección es de su propia máquina. Ponga antes la página en un servidor'],
  ] as const) {
    await show(lab, `th0=150deg&t=0s&lang=${language}`)
    await lab.locator('#share').click()
    await expect(lab.locator('dialog .local')).toContainText(said)
    await lab.keyboard.press('Escape')
  }
  // The same page under the name of a server.
  const context = await browser.newContext({ serviceWorkers: 'block' })
  const page = await context.newPage()
  const server = 'http://lab.example/'
  await context.route(`${server}**`, async (route) => {
    const url = route.request().url().replace(server, address())
    await route.fulfill({ response: await route.fetch({ url }) })
  })
  await page.goto(`${server}#th0=150deg&t=0s&lang=en`)
  await ready(page)
  await page.locator('#share').click()
  await expect(page.locator('#share-link')).toHaveValue(/^http:\/\/lab\.example\//)
  await expect(page.locator('dialog .local')).toHaveCount(0)
  await context.close()
})

test('story 10: every kept link opens with its state', async ({ lab }) => {
  for (const { link, state } of keptLinks()) {
    await show(lab, link)
    await expect(lab.locator('.message')).toHaveCount(0)
    await expect(lab.locator('main').locator('.plot-drawing, .step, .code').first()).toBeVisible()
    const back = readLink((await linkOf(lab)).replace(/^.*#/, '')).state
    expect(back, link).toMatchObject(state)
  }
  await show(lab, 't=0s')
})

const BAD: readonly (readonly [string, readonly string[]])[] = [
  ['th0=200deg', ['th0=200deg', '−180° to 180°', '150°']],
  ['th0=north', ['th0=north', 'not a number']],
  ['L=-1m', ['L=-1m', '0.001', '1000']],
  ['g=NaN', ['g=NaN', 'not a number']],
  ['L=0&g=1e9', ['L=0', 'g=1e9']],
  ['view=moon', ['view=moon', 'lab, phase, period, functions']],
  ['curves=magic', ['magic', 'not a curve']],
  ['curves=fourier:0', ['fourier:0', '1 to 50']],
  ['curves=rk4:5', ['rk4:5', '0.0001 to 1']],
  ['curves=linear,linear', ['linear', 'twice']],
  ['periods=nobody', ['periods=nobody']],
  ['orbits=10deg;x', ['orbits', '10deg;x']],
  ['span=1e6s', ['span=1e6s', '600']],
  ['lang=de', ['lang=de', 'pt-BR']],
  ['v=9', ['v=9']],
  ['shape=round', ['shape=round', 'not known']],
  ['th0=%E0%A4%A', ['th0']],
]

test('bad links: each bad value is named with what is shown instead, and the rest works', async ({ lab }) => {
  for (const [link, said] of BAD) {
    await show(lab, `${link}&t=0s`)
    const message = lab.locator('.message')
    await expect(message, link).toHaveCount(1)
    for (const text of said) await expect(message, link).toContainText(text)
    await expect(lab.locator('main .plot-drawing').first(), link).toBeVisible()
    await expect(lab.locator('#page .sentence'), link).toHaveText(/\d/)
  }
  await lab.getByRole('button', { name: 'Close this message' }).click()
  await expect(lab.locator('.message')).toHaveCount(0)
})

test('bad links: what they hold is told as it is, and is no wider than the page', async ({ lab }) => {
  await show(lab, `__proto__=1&utm_a=b_c&x*y=*z*&p={kept}&th0=${'9'.repeat(400)}&${'k'.repeat(2000)}=1&t=0s&lang=en`)
  const message = lab.locator('.message')
  for (const text of ['__proto__=1 is not', 'utm_a=b_c is not', 'x*y=*z* is not', 'p={kept} is not a number'])
    await expect(message).toContainText(text)
  expect(await lab.evaluate(() => document.documentElement.scrollWidth - innerWidth)).toBeLessThanOrEqual(0)
  await show(lab, 'view=phase&w0=100&t=100000s&lang=en')
  expect(await lab.evaluate(() => document.documentElement.scrollWidth - innerWidth)).toBeLessThanOrEqual(0)
  await show(lab, 'view=lab&t=0s')
})

test('fields out of range: one sentence with value and range, the motion stays', async ({ lab }) => {
  await show(lab, 'th0=150deg&L=1m&g=9.81&t=0s')
  for (const [name, typed, said] of [
    ['theta0', '200', 'Release angle: 200° is outside −180° to 180°. The motion still shows 150°.'],
    ['length', '0', 'Length: 0 m is outside 0.001 m to 1000 m. The motion still shows 1 m.'],
    ['gravity', 'much', 'Gravity: “much” is not a number. The motion still shows 9.81 m/s².'],
    [
      'velocity0',
      '1e3',
      'Start velocity: 1e3 rad/s is outside −100 rad/s to 100 rad/s. The motion still shows 0 rad/s.',
    ],
  ] as const) {
    const field = lab.locator(`#field-${name}`)
    await field.fill(typed)
    await expect(field).toHaveAttribute('aria-invalid', 'true')
    await expect(lab.locator(`#field-${name}-fault`)).toHaveText(said)
    await expect(lab.locator('#page .sentence')).toContainText('Released at 150°')
    await lab.keyboard.press('Escape')
    await expect(field).toHaveAttribute('aria-invalid', 'false')
  }
})

test('a link opened over a wrong value in a field leaves nothing of it', async ({ lab }) => {
  await show(lab, 'th0=150deg&t=0s')
  const field = lab.locator('#field-theta0')
  await field.fill('200')
  await expect(field).toHaveAttribute('aria-invalid', 'true')
  await show(lab, 'th0=60deg&t=0s')
  await expect(field).toHaveValue('60')
  await expect(field).toHaveAttribute('aria-invalid', 'false')
})

test('where the second module does not come, the Lab works and the views that need it say so', async ({ browser }) => {
  const context = await browser.newContext({ serviceWorkers: 'block' })
  const page = await context.newPage()
  await page.route('**/libration-second*.wasm', (route) => route.abort())
  await page.goto(`${address()}#th0=150deg&t=0s`)
  await ready(page)
  for (const view of ['period', 'functions']) {
    await page.locator(`[data-view=${view}]`).click()
    await expect(page.locator('.waiting-line')).toContainText('could not be loaded')
  }
  await page.locator('[data-view=phase]').click()
  await expect(page.locator('[data-plot=phase]')).toBeVisible()
  await page.locator('[data-view=lab]').click()
  await expect(page.locator('#page .sentence')).toContainText('Released at 150°')
  await context.close()
})

test('a browser without vectors gets the scalar module, and the same numbers', async ({ lab, browser }) => {
  const context = await browser.newContext({ serviceWorkers: 'block' })
  const page = await context.newPage()
  const asked: string[] = []
  page.on('request', (request) => asked.push(request.url()))
  await page.addInitScript(() => {
    WebAssembly.validate = () => false
  })
  await page.goto(`${address()}#th0=150deg&t=7.7s`)
  await ready(page)
  expect(asked.filter((each) => each.includes('scalar')).length).toBeGreaterThan(0)
  expect(asked.filter((each) => each.includes('simd')).length).toBe(0)
  await show(lab, 'th0=150deg&t=7.7s')
  const angle = async (of: Page) => Number(await of.locator('.bob-handle').getAttribute('data-exact'))
  expect(Math.abs((await angle(page)) - (await angle(lab)))).toBeLessThan(1e-13)
  await context.close()
})

test('where the core cannot start the page says so, and the table of periods stands', async ({ browser }) => {
  const context = await browser.newContext({ serviceWorkers: 'block' })
  const page = await context.newPage()
  await page.route('**/*.wasm', (route) => route.abort())
  await page.goto(address())
  await expect(page.locator('.message')).toContainText('The exact core did not start')
  await expect(page.locator('#still table')).toContainText('1.7622')
  await page.unroute('**/*.wasm')
  await page.route('**/*.wasm', (route) => route.fulfill({ contentType: 'application/wasm', body: 'not a module' }))
  await page.reload()
  await expect(page.locator('.message')).toContainText('The exact core did not start')
  await page.unroute('**/*.wasm')
  await page.addInitScript(() => Reflect.deleteProperty(window, 'WebAssembly'))
  await page.reload()
  await expect(page.locator('.message')).toContainText('does not start WebAssembly')
  await expect(page.locator('.message a').first()).toHaveAttribute('href', '#still')
  await context.close()
})

test('where no script of the page runs, or modules are blocked, the page says what to do', async ({ browser }) => {
  for (const scripts of [true, false]) {
    const context = await browser.newContext({ serviceWorkers: 'block', javaScriptEnabled: scripts })
    const page = await context.newPage()
    await page.route('**/*.js', (route) => route.abort())
    await page.goto(address())
    await expect(page.getByRole('heading', { name: 'The exact pendulum' })).toBeVisible()
    await expect(page.locator('#still')).toContainText('modules of JavaScript may be blocked')
    await expect(page.locator('#still table')).toContainText('1.7622')
    await expect(page.getByRole('link', { name: 'The offline file' })).toBeVisible()
    await context.close()
  }
})

/** Every view, a drag, a table, another language: nothing of it needs a network. */
async function useAll(page: Page): Promise<void> {
  await page.locator('[data-view=derivation]').click()
  await expect(page.locator('main .step math').first()).toBeVisible()
  for (const view of ['phase', 'period', 'functions', 'handouts', 'lab']) {
    await page.locator(`[data-view=${view}]`).click()
    await expect(page.locator('main .plot-drawing').first()).toBeVisible()
  }
  await page.locator('#field-theta0').fill('60')
  await expect(page.locator('#page .sentence')).toContainText('Released at 60°')
  await expect(page.locator('#period-value')).toHaveText(/^2\.1529/)
  await page.locator('[data-chart=angle] [data-tool=table]').click()
  await expect(page.locator('[data-chart=angle] tbody tr')).not.toHaveCount(0)
  await page.locator('#menu-save-angle').click()
  const saving = page.waitForEvent('download')
  await page.getByRole('menuitem', { name: /^PNG/ }).click()
  expect((await saving).suggestedFilename()).toBe('angle.png')
  await page.locator('#share').click()
  await expect(page.locator('dialog svg.qr')).toBeVisible()
  await page.keyboard.press('Escape')
}

test('zero requests after the page has loaded', async ({ browser }) => {
  const page = await opened(browser, 'th0=150deg&L=1m&g=9.81&t=0s&theme=dark')
  await whole(page)
  const asked: string[] = []
  page.context().on('request', (request) => asked.push(request.url()))
  await useAll(page)
  // A picture that is saved is read from the memory of the page.
  expect(asked.filter((each) => !each.startsWith('blob:'))).toEqual([])
  expect(await page.context().cookies()).toEqual([])
  await page.context().close()
})

test('story 13: the offline file works from disk without a network', async ({ browser }) => {
  const context = await browser.newContext({ offline: true })
  const page = await context.newPage()
  const asked: string[] = []
  page.on('request', (request) => asked.push(request.url()))
  await page.goto(`file://${DIST}offline.html#th0=150deg&L=1m&g=9.81&t=0s`)
  await ready(page)
  await useAll(page)
  expect(asked.filter((each) => !each.startsWith('data:') && !each.startsWith('blob:')).length).toBe(1)
  await context.close()
})

/** A visit until all of it is kept, as the page says. */
async function keptVisit(page: Page): Promise<void> {
  await page.goto('about:blank')
  await page.goto(`${address()}#th0=150deg&L=1m&g=9.81&t=0s`)
  await expect(page.locator('html')).toHaveAttribute('data-kept')
}

/** From now on without a network, and without what the browser itself keeps. */
async function cutOff(page: Page): Promise<void> {
  const session = await page.context().newCDPSession(page)
  await session.send('Network.clearBrowserCache')
  await page.context().setOffline(true)
}

test('story 13: a second visit needs no network, nor does a third', async ({ browser }) => {
  const context = await browser.newContext()
  const page = await context.newPage()
  await keptVisit(page)
  await cutOff(page)
  await keptVisit(page)
  // The third is of what the second has kept.
  await keptVisit(page)
  await useAll(page)
  await context.close()
})

test('story 13: a network that goes while a visit is being kept takes nothing of the visit before', async ({
  browser,
}) => {
  const context = await browser.newContext()
  const page = await context.newPage()
  await keptVisit(page)
  // The page itself comes, and after it nothing more.
  let visits = 0
  await context.route(address(), (route) => (visits++ === 0 ? route.continue() : route.abort()))
  await cutOff(page)
  await context.setOffline(false)
  await page.goto('about:blank')
  await page.goto(`${address()}#th0=150deg&L=1m&g=9.81&t=0s`)
  await expect.poll(() => visits).toBe(2)
  await cutOff(page)
  await keptVisit(page)
  await useAll(page)
  await context.close()
})

test('story 13: a worker that the browser ends while it answers loses no part', async ({ browser }) => {
  const context = await browser.newContext()
  const page = await context.newPage()
  await keptVisit(page)
  // A part that the worker has to fetch again, so that it is still answering when it is ended; and once more for the second try.
  await page.evaluate(async () => {
    const cache = await caches.open('libration-lab')
    for (const request of await cache.keys()) if (request.url.includes('libration-second')) await cache.delete(request)
  })
  const session = await context.newCDPSession(page)
  await session.send('Network.clearBrowserCache')
  await session.send('ServiceWorker.enable')
  let ended = 0
  await context.route('**/libration-second*.wasm', async (route) => {
    if (ended === 2) return route.continue()
    ended++
    await session.send('ServiceWorker.stopAllWorkers')
  })
  await keptVisit(page)
  expect(ended).toBe(2)
  await useAll(page)
  await context.close()
})

test('a part whose answer is lost is asked for again', async ({ browser }) => {
  const context = await browser.newContext({ serviceWorkers: 'block' })
  const page = await context.newPage()
  const lost = new Set<string>()
  for (const part of ['**/later-*.js', '**/libration-second*.wasm', '**/libration-simd*.wasm'])
    await page.route(part, (route) => {
      if (lost.has(part)) return route.continue()
      lost.add(part)
      return route.abort()
    })
  await page.goto(`${address()}#th0=150deg&L=1m&g=9.81&t=0s`)
  await ready(page)
  await useAll(page)
  expect(lost.size).toBe(3)
  await context.close()
})

test('story 10: a wrong value of a field keeps the page within the screen, in every language', async ({ lab }) => {
  for (const language of ['en', 'pt-BR', 'es']) {
    await show(lab, `t=0s&lang=${language}`)
    for (const [name, text] of [
      ['length', '0'],
      ['velocity0', '-123456.789'],
    ] as const) {
      await lab.locator(`#field-${name}`).fill(text)
      await expect(lab.locator(`#field-${name}-fault`)).toBeVisible()
      await drawn(lab)
      await expect
        .poll(() => lab.evaluate(() => document.documentElement.scrollHeight), { message: `${language} ${name}` })
        .toBe(720)
      await lab.keyboard.press('Escape')
    }
  }
})
