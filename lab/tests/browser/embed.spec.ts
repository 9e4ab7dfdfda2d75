// Story 11: the page in a page of others, with parts locked; and planet X, where g is to be measured.

import { createServer, type Server } from 'node:http'
import type { AddressInfo } from 'node:net'
import type { Frame, Page } from '@playwright/test'
import { readLink } from '../../src/link'
import { LANGUAGES } from '../../src/state'
import { address, csvOf, drawn, expect, opened, show, test, whole } from './lab'
import { layoutFaults } from './layout'

/** A page of others: what a course's site does with a frame. It has an address of its own and gives the frame nothing. */
async function course(frame: string): Promise<{ readonly server: Server; readonly url: string }> {
  const server = createServer((_, response) => {
    response
      .writeHead(200, { 'content-type': 'text/html; charset=utf-8' })
      .end(`<!doctype html><title>course</title>${frame}`)
  })
  await new Promise<void>((ready) => server.listen(0, '127.0.0.1', ready))
  return { server, url: `http://127.0.0.1:${(server.address() as AddressInfo).port}/` }
}

/** The page in a frame that may run scripts and nothing else: no storage, no address of its own. */
async function inFrame(page: Page, source: string): Promise<{ readonly frame: Frame; readonly server: Server }> {
  const { server, url } = await course(
    `<iframe sandbox="allow-scripts" src="${source.replaceAll('&', '&amp;')}" width="360" height="640" style="border:0"></iframe>`,
  )
  await page.goto(url)
  const frame = page.frames()[1] as Frame
  await expect(frame.locator('main .plot-drawing').first()).toBeVisible()
  return { frame, server }
}

test('story 11: in a sandboxed frame without storage it shows what was named, locked, and asks for nothing', async ({
  browser,
}) => {
  for (const place of [address(), `${address()}offline.html`]) {
    const context = await browser.newContext({ serviceWorkers: 'block' })
    const page = await context.newPage()
    const errors: string[] = []
    page.on('pageerror', (error) => errors.push(String(error)))
    const { frame, server } = await inFrame(
      page,
      `${place}#th0=150deg&L=1m&g=9.81&embed=1&lock=g,L&show=phase&t=0s&lang=en`,
    )
    await whole(frame)
    const asked: string[] = []
    context.on('request', (request) => asked.push(request.url()))
    expect(
      await frame.evaluate(() => {
        try {
          return String(localStorage.length)
        } catch {
          return 'blocked'
        }
      }),
    ).toBe('blocked')
    await expect(frame.locator('[data-plot=phase]')).toBeVisible()
    for (const hidden of ['.top', '.tabs', '#share', '.skip']) await expect(frame.locator(hidden)).toHaveCount(0)
    // What is locked says so, and stays.
    for (const name of ['length', 'gravity']) {
      await expect(frame.locator(`#field-${name}`)).toBeDisabled()
      await expect(frame.locator(`[data-value=${name}]`)).toHaveAttribute('title', 'Locked by the sender.')
    }
    await expect(frame.locator('#field-theta0')).toBeEnabled()
    await frame.locator('#field-theta0').fill('60')
    await expect(frame.locator('#page .sentence')).toContainText('60°')
    // No key leads out of it.
    await frame.locator('#field-theta0').press('Escape')
    await frame.locator('main').focus()
    for (const key of ['s', '?', '1', '3']) await page.keyboard.press(key)
    await expect(frame.locator('dialog')).toHaveCount(0)
    await expect(frame.locator('main.view-phase')).toBeVisible()
    expect(await frame.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(360)
    await frame.locator('[data-chart=phase] [data-tool=table]').click()
    await expect(frame.locator('[data-chart=phase] tbody tr')).not.toHaveCount(0)
    expect(asked).toEqual([])
    expect(errors).toEqual([])
    await context.close()
    server.close()
  }
})

test('story 11: a page of others loads the parts of what it shows and no others', async ({ browser }) => {
  const PARTS = ['later', 'derivation', 'springs', 'friction', 'data', 'handouts', 'libration-second'] as const
  for (const [view, wanted] of [
    ['motion', ['later', 'libration-second']],
    ['phase', ['later']],
    ['friction', ['friction']],
    ['data', ['data']],
  ] as const) {
    const context = await browser.newContext({ serviceWorkers: 'block' })
    const page = await context.newPage()
    const errors: string[] = []
    page.on('pageerror', (error) => errors.push(String(error)))
    await page.goto(`${address()}#embed=1&show=${view}&th0=150deg&t=0s&lang=en`)
    await whole(page)
    await expect(page.locator('.waiting-line')).toHaveCount(0)
    await expect(page.locator('main .plot-drawing, main .step, main .drop').first()).toBeVisible()
    const loaded = await page.evaluate(() => performance.getEntriesByType('resource').map(({ name }) => name))
    const parts = PARTS.filter((part) => loaded.some((name) => new RegExp(`/${part}-[^/]*[.](js|wasm)$`).test(name)))
    expect([view, ...parts]).toEqual([view, ...wanted])
    // A link that shows more has it.
    if (view === 'phase') {
      await show(page, 'view=derivation&th0=150deg&t=0s&lang=en')
      await expect(page.locator('main .step').first()).toBeVisible()
    }
    expect(errors).toEqual([])
    await context.close()
  }
})

test('story 11: parts of the Lab alone, and each thing that can be locked', async ({ lab }) => {
  await show(lab, 'embed=1&show=pendulum,motion,play&th0=150deg&t=0s&lang=en')
  for (const part of ['.drawing', '.first-chart', '.play']) await expect(lab.locator(part)).toBeVisible()
  for (const part of [
    '.top',
    '.first-values',
    '.more-values',
    '.facts',
    '.second-chart',
    '.third-chart',
    '.compare',
    '.portrait',
  ])
    await expect(lab.locator(part)).toBeHidden()
  for (const [width, height] of [
    [360, 640],
    [800, 600],
    [1280, 720],
  ] as const) {
    await lab.setViewportSize({ width, height })
    for (const shown of [
      'show=phase',
      'show=pendulum,motion,play',
      'show=values,facts,curves',
      'show=lab,period&hide=g',
      'show=portrait,error,energy',
    ]) {
      for (const language of LANGUAGES) {
        await show(lab, `embed=1&lock=g,L&${shown}&th0=150deg&t=0.4s&lang=${language}`)
        await drawn(lab)
        expect(await layoutFaults(lab), `${shown} ${language} ${width}`).toEqual([])
      }
    }
  }
  await lab.setViewportSize({ width: 1280, height: 720 })
  await show(lab, 'embed=1&lock=th0,w0,L,g,curves&show=lab&th0=150deg&t=0s&lang=en')
  for (const name of ['theta0', 'velocity0', 'length', 'gravity'])
    await expect(lab.locator(`#field-${name}`)).toBeDisabled()
  await expect(lab.locator('.compare fieldset')).toHaveAttribute('title', 'Locked by the sender.')
  for (const box of await lab.locator('.compare input').all()) await expect(box).toBeDisabled()
  const bob = lab.locator('.bob-handle')
  await expect(bob).toHaveAttribute('aria-disabled', 'true')
  const box = await bob.boundingBox()
  if (!box) throw new Error('no bob')
  await lab.mouse.move(box.x + box.width / 2, box.y + box.height / 2)
  await lab.mouse.down()
  await lab.mouse.move(box.x + 80, box.y + 40)
  await lab.mouse.up()
  await lab.locator('.portrait .plot').click({ position: { x: 40, y: 40 } })
  await expect(lab.locator('#field-theta0')).toHaveValue('150')
  // What would say g alone is no empty page.
  await show(lab, 'embed=1&hide=g&g=3.71&show=energy&th0=150deg&t=0s&lang=en')
  await expect(lab.locator('.message')).toContainText('show=energy')
  await expect(lab.locator('.first-chart')).toBeVisible()
  // Two views: their tabs, and no more of the bar.
  await show(lab, 'embed=1&show=lab,period&t=0s&lang=en')
  await expect(lab.locator('.tabs button')).toHaveCount(2)
  await expect(lab.locator('#share')).toHaveCount(0)
  await lab.keyboard.press('2')
  await expect(lab.locator('main.view-period')).toBeVisible()
  // The page is that of other tests too: no row is pointed at.
  await lab.mouse.move(0, 0)
  await show(lab, 'view=lab&t=0s')
})

/** Every number that is in the page: in its text, its titles, its fields; places of drawings apart. */
function numbersOf(page: Page): Promise<number[]> {
  return page.evaluate(() => {
    const DRAWN = /^(d|x|y|cx|cy|r|x1|x2|y1|y2|style|transform|points|viewBox|width|height|data-exact)$/
    const texts = [document.title, document.querySelector('#page')?.textContent ?? '']
    for (const element of document.querySelectorAll('#page *')) {
      for (const { name, value } of element.attributes) if (!DRAWN.test(name)) texts.push(value)
      if (element instanceof HTMLInputElement || element instanceof HTMLTextAreaElement) texts.push(element.value)
    }
    return texts.flatMap((text) =>
      (text.replaceAll('−', '-').match(/\d+(?:[.,]\d+)?(?:e-?\d+)?/g) ?? []).map((each) =>
        Number(each.replace(',', '.')),
      ),
    )
  })
}

test('story 11: on planet X nothing gives g: not the page, its titles and tables, nor the link and the CSV', async ({
  lab,
}) => {
  const g = 7.4329
  const length = 0.8371
  const omega0 = Math.sqrt(g / length)
  /** What is as good as g, where the length stands beside it. */
  const telling = [g, g / length, omega0, 2 * omega0, (2 * Math.PI) / omega0]
  const near = (found: readonly number[], some: readonly number[]) =>
    found.filter((each) => some.some((one) => Math.abs(each / one - 1) < 2e-3))
  // The ruler sees it where it is shown.
  await show(lab, `th0=117deg&L=${length}m&g=${g}&t=0s&lang=en`)
  expect(near(await numbersOf(lab), telling).length).toBeGreaterThan(2)
  for (const start of ['th0=117deg', 'th0=-23deg&w0=4.1', 'th0=0deg&w0=8.3']) {
    for (const language of LANGUAGES) {
      await show(lab, `${start}&L=${length}m&g=${g}&hide=g&t=0.31s&lang=${language}`)
      await expect.poll(() => lab.url()).toMatch(/&g=~[0-9a-z]+&/)
      expect(near(await numbersOf(lab), telling), `${start} ${language}`).toEqual([])
    }
    await expect(lab.locator('[data-value=hidden]')).toHaveCount(1)
    // The mark of the velocity that just reaches the top.
    await expect(lab.locator('[data-value=velocity0] .notch')).toHaveCount(1)
    await expect(lab.locator('#field-gravity, .facts, [data-chart=energy]')).toHaveCount(0)
    await expect(lab.locator('.tabs button')).toHaveCount(2)
  }
  await show(lab, `th0=117deg&L=${length}m&g=${g}&hide=g&t=0.31s&lang=en`)
  await lab.locator('[data-chart=angle] [data-tool=table]').click()
  expect(near(await numbersOf(lab), [g])).toEqual([])
  const { text, link, header } = await csvOf(lab, 'angle')
  expect([text.includes(String(g)), /gravity|\bg=[0-9]/.test(text)]).toEqual([false, false])
  expect(header.join()).not.toContain('g')
  // Who has the link has the same pendulum, and does not see it either.
  expect(readLink(new URL(link).hash).state).toMatchObject({ gravity: g, hide: true })
  // Its portrait is the same for every g, and has no number of rad/s; a click in it would set one.
  await show(lab, `th0=117deg&L=${length}m&g=${g}&hide=g&t=0.31s&lang=en`)
  const portrait = () =>
    lab
      .locator('.portrait .plot')
      .evaluate((plot) =>
        [
          ...[...plot.querySelectorAll('path')].map((path) => path.getAttribute('d')),
          ...[...plot.querySelectorAll('text')].map((text) => text.textContent?.trim()),
        ].join(' '),
      )
  const seen = await portrait()
  await show(lab, `th0=117deg&L=${length}m&g=1.62&hide=g&t=0.31s&lang=en`)
  expect(await portrait()).toBe(seen)
  await expect(lab.locator('.portrait .separatrix')).toHaveCount(0)
  await lab.locator('.portrait .plot').click({ position: { x: 60, y: 40 } })
  await expect(lab.locator('#field-theta0')).toHaveValue('117')
  await show(lab, `th0=117deg&L=${length}m&g=1.62&t=0.31s&lang=en`)
  expect(await portrait()).not.toBe(seen)
  await show(lab, `th0=117deg&L=${length}m&g=${g}&hide=g&t=0.31s&lang=en`)
  // An example would show another g.
  await lab.locator('#menu-examples').click()
  for (const item of await lab.locator('.menu [role=menuitem]').all()) await expect(item).toBeDisabled()
  await lab.keyboard.press('Escape')
  await lab.locator('#share').click()
  await expect(lab.locator('#share-link')).toHaveValue(/&g=~[0-9a-z]+&/)
  await lab.keyboard.press('Escape')
  // It still measures: the pendulum is that of g.
  expect(Math.abs(Number(await lab.locator('.bob-handle').getAttribute('data-exact')))).toBeGreaterThan(0)
  // The page is that of other tests too: no row is pointed at.
  await lab.mouse.move(0, 0)
  await show(lab, 'view=lab&t=0s')
})

test('story 11: a link that opens with a plain g is closed at once', async ({ browser }) => {
  const page = await opened(browser, 'th0=40deg&L=1m&g=3.71&hide=g&t=0s')
  await expect.poll(() => page.url()).not.toContain('3.71')
  expect(readLink(new URL(page.url()).hash).state).toMatchObject({ gravity: 3.71, hide: true })
  await page.context().close()
})

test('story 11: what was open, to be undone or wrong before a link does not say the g that it hides', async ({
  lab,
}) => {
  const follow = async (hash: string) => {
    await lab.evaluate((next) => {
      location.hash = next
    }, hash)
    await drawn(lab)
  }
  await show(lab, 'th0=30deg&L=1m&g=9.81&t=0s&lang=en')
  await lab.locator('#menu-examples').click()
  await lab.locator('.menu [role=menuitem]').first().click()
  await expect(lab.locator('.message')).toContainText('Undo')
  await lab.locator('#menu-save-pendulum').click()
  await lab.locator('.menu [role=menuitem]').first().click()
  await expect(lab.locator('dialog')).toBeVisible()
  await follow('th0=40deg&L=1m&g=9.81&hide=g&t=0s&lang=en&mine=7')
  await expect(lab.locator('dialog, .message:has-text("Undo")')).toHaveCount(0)
  await expect(lab.locator('[data-value=hidden]')).toHaveCount(1)
  // What is not ours stands in the link that is written next.
  await expect.poll(() => lab.url()).toMatch(/&g=~[0-9a-z]+&.*&mine=7$/)
  for (const [wrong, told] of [
    ['NaN', 'g=NaN is not a number. The usual value is shown instead.'],
    ['2000', 'g=2000 is outside 0.001 m/s² to 1000 m/s². The usual value is shown instead.'],
  ] as const) {
    await show(lab, `g=${wrong}&hide=g&t=0s&lang=en`)
    await expect(lab.locator('.message')).toContainText(told)
  }
  await show(lab, 'view=lab&t=0s')
})

test('story 11: a locked start stays the chosen one of the portrait, and no example of friction replaces it', async ({
  lab,
}) => {
  await show(lab, 'view=phase&lock=w0&th0=50deg&w0=1&t=0s&lang=en')
  for (const letter of ['A', 'B', 'C']) {
    const radio = lab.locator(`#orbit-${letter}`)
    await (letter === 'A' ? expect(radio).toBeEnabled() : expect(radio).toBeDisabled())
  }
  await expect(lab.locator('#orbit-B')).toHaveAttribute('title', 'Locked by the sender.')
  await expect(lab.locator('[data-orbit=A] .remove')).toHaveCount(0)
  await lab.locator('[data-orbit=C] .remove').click()
  await expect(lab.locator('.orbit-row')).toHaveCount(2)
  await lab.locator('#menu-orbit').click()
  for (const item of await lab.locator('.menu [role=menuitem]').all()) await expect(item).toBeDisabled()
  await lab.keyboard.press('Escape')
  await show(lab, 'view=friction&lock=th0&th0=50deg&t=0s&lang=en')
  await lab.locator('#menu-frictions').click()
  for (const item of await lab.locator('.menu [role=menuitem]').all()) await expect(item).toBeDisabled()
  await lab.keyboard.press('Escape')
  await lab.mouse.move(0, 0)
  await show(lab, 'view=lab&t=0s')
})

test('story 11: the form makes the code of a frame that shows what was chosen', async ({ browser }) => {
  const page = await opened(browser, 't=0s', { permissions: ['clipboard-read', 'clipboard-write'] })
  await show(page, 'view=handouts&handout=embed&th0=150deg&L=0.9m&g=3.71&t=1.5s&lang=en')
  const code = page.locator('#embed-code')
  const source = async () =>
    readLink((/src="[^"]*(#[^"]*)"/.exec(await code.inputValue())?.[1] ?? '').replaceAll('&amp;', '&'))
  expect((await source()).state).toMatchObject({ embed: true, lock: ['L', 'g'], show: ['phase'], view: 'phase' })
  await expect(code).not.toHaveValue(/[#&;]t=/)
  await page.locator('#show-phase').uncheck()
  for (const name of ['show-pendulum', 'show-motion', 'show-play', 'lock-curves', 'hide-g'])
    await page.locator(`#${name}`).check()
  await expect(page.locator('#show-phase')).toBeDisabled()
  for (const name of ['energy', 'facts']) await expect(page.locator(`#show-${name}`)).toBeDisabled()
  await expect(page.locator('#hidden-help')).toHaveText(
    'With g hidden only Lab and Data can be shown, and of the Lab neither period nor energy.',
  )
  await page.getByRole('button', { name: '640 × 480' }).click()
  const { state, faults } = await source()
  expect(faults).toEqual([])
  expect(state).toMatchObject({
    embed: true,
    lock: ['L', 'g', 'curves'],
    show: ['pendulum', 'motion', 'play'],
    hide: true,
    gravity: 3.71,
    view: 'lab',
  })
  await expect(code).toHaveValue(/width="640" height="480"/)
  await expect(code).not.toHaveValue(/3\.71/)
  await page.locator('#copy-embed').click()
  await expect.poll(() => page.evaluate(() => navigator.clipboard.readText())).toBe(await code.inputValue())
  await page.locator('#preview').click()
  const frame = page.frameLocator('.embed-preview')
  await expect(frame.locator('.first-chart .plot-drawing')).toBeVisible()
  await expect(frame.locator('.compare')).toBeHidden()
  await expect(frame.locator('#page .sentence')).toContainText('g is hidden here')
  await page.context().close()
})
