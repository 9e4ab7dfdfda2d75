// Stories 18 and 19: g from a period that was timed; periods that fall with the swing, several records, parts. And Data in other
// languages, without a network, and under a hand while it fits.

import { readFile } from 'node:fs/promises'
import type { Page } from '@playwright/test'
import { load, Pendulum } from 'libration'
import { GATE, give, LENGTHS, numbers, opening, RECORD, rows, state, time, watched } from './data'
import { address, column, csvOf, drawn, expect, opened, show, test } from './lab'

test.beforeAll(() => load())

test('story 18: T, the length and the swing give g, beside the formula of small swings and the place', async ({
  browser,
}) => {
  const { page, asked } = await watched(browser)
  await page.getByRole('button', { name: 'From a period' }).click()
  await expect(page.locator('#page .sentence')).toContainText('From a timed period')
  await expect(page.locator('main')).toContainText('Time some swings')
  const before = asked.length
  await time(page, { time: '20.409902', timeU: '0.02', swings: '10', length: '1', lengthU: '0.001', swing: '30' })
  await expect(page.locator('#timing-g')).toHaveText(/^9\.810 ± 0\.0/)
  const narrow = numbers(await page.locator('#timing-g').textContent())[1] as number
  // The swing's uncertainty is one of g.
  await time(page, { swingU: '1' })
  await expect(page.locator('#timing-g')).toHaveText(/^9\.810 ± 0\.031/)
  expect(narrow).toBeLessThan(0.031)
  await expect(page.locator('#timing-small')).toHaveText(/^9\.477/)
  const budget = page.locator('#data-budget tbody tr')
  await expect(budget.filter({ hasText: 'swing' })).toContainText('0.023')
  // The place: not 9.81.
  await time(page, { latitude: '-23.3', height: '585' })
  await expect(page.locator('#timing-normal')).toHaveText(/^9\.7866/)
  await expect(page.locator('#timing-difference')).toHaveText(/^0\.023 ± 0\.031/)
  await expect(page.locator('#page .sentence')).toContainText('gives 9.477, the place has 9.787')
  // The curve of g against the swing goes from the formula of small swings on.
  const g = column(await csvOf(page, 'timing'), 'g')
  expect(g[0]?.toFixed(3)).toBe('9.477')
  expect(g.length).toBe(81)
  // A swing that decays while it is counted.
  await time(page, { end: '20', endU: '1' })
  await expect(page.locator('#timing-g')).toHaveText(/^9\.703 ± 0\.025/)
  // What is wrong is said, and nothing is shown for it.
  await time(page, { swing: '200' })
  await expect(page.locator('#timing-refusal')).toContainText('must be greater than 0 and less than 3.14159')
  await expect(page.locator('#timing-g')).toHaveCount(0)
  await time(page, { swing: 'wide' })
  await expect(page.locator('#data-fault')).toContainText('wide')
  expect(asked.length).toBe(before)
  await page.context().close()
})

test('story 18: what phyphox records of the same swings gives the same g', async ({ browser }) => {
  const { page } = await opening(browser)
  await state(page, '0.8', '0.001')
  await give(
    page,
    'phyphox.csv',
    rows('"Time (s)","Gyroscope x (rad/s)"', ({ t, velocity }) => [t, velocity], ','),
  )
  await expect(page.locator('#data-g')).toBeVisible()
  const [byFile = Number.NaN, u = Number.NaN] = numbers(await page.locator('#data-g').textContent())
  const { period } = new Pendulum({ theta0: 1, length: 0.8, gravity: 9.81 })
  await page.getByRole('button', { name: 'From a period' }).click()
  await time(page, { time: String(period), length: '0.8', lengthU: '0.001', swing: '1 rad' })
  const shown = async () => numbers(await page.locator('#timing-g').textContent())[0] ?? Number.NaN
  await expect.poll(async () => Math.abs((await shown()) - 9.81)).toBeLessThan(1e-3)
  const byPeriod = await shown()
  expect(Math.abs(byFile - byPeriod)).toBeLessThan(2 * u)
  // Back again, the fit still stands.
  await page.getByRole('button', { name: 'From a file' }).click()
  await expect(page.locator('.file-name')).toHaveText('phyphox.csv')
  await expect(page.locator('#data-g')).toBeVisible()
  await page.context().close()
})

test('story 18: with keys only, and in Portuguese with a decimal comma', async ({ browser }) => {
  const page = await opened(browser, 't=0s')
  await show(page, 'view=data&from=period&t=0s&lang=pt-BR')
  await page.locator('#timing-time').focus()
  for (const text of ['20,41', '0,02', '10', '1', '0,001', '30', '1', '', '', '-23,3', '585']) {
    await page.keyboard.insertText(text)
    await page.keyboard.press('Tab')
  }
  await expect(page.locator('#timing-example')).toBeFocused()
  await expect(page.locator('#timing-g')).toHaveText(/^9,810 ± 0,031/)
  await expect(page.locator('#live')).toContainText('9,810 ± 0,031')
  await page.context().close()
})

test('story 19: periods that fall with the swing, on the exact law', async ({ browser }) => {
  const { page } = await opening(browser)
  await state(page, '0.8', '0.001')
  await page.locator('#data-file').setInputFiles(GATE)
  const T0 = 2 * Math.PI * Math.sqrt(0.8 / 9.81)
  await expect(page.locator('#data-period0')).toBeVisible()
  const [found = Number.NaN, u = Number.NaN] = numbers(await page.locator('#data-period0').textContent())
  expect(Math.abs(found - T0)).toBeLessThan(2 * u)
  await expect(page.locator('#data-g')).toHaveText(/^9\.8/)
  // The swing of each period by the fit: some 100° at first, and always more where the period is longer.
  const sheet = await csvOf(page, 'data')
  const [swing, fitted] = [sheet.columns['θ0, °'], column(sheet, 'fitted')] as [Float64Array, Float64Array]
  expect(swing.length).toBe((await readFile(GATE, 'utf8')).trim().split('\n').length - 1)
  expect(Math.abs((swing.at(-1) as number) - 100)).toBeLessThan(6)
  expect(fitted.every((each, i) => i === 0 || each > (fitted[i - 1] as number))).toBe(true)
  await expect(page.locator('[data-chart=data] .c-exact')).toHaveCount(1)
  await expect(page.locator('[data-chart=residual]')).toBeVisible()
  // Against the time as well.
  await page.locator('[data-chart=data] button', { hasText: 'time' }).click()
  const times = (await csvOf(page, 'data')).columns['t, s'] as Float64Array
  expect(times[0]).toBeLessThan(2)
  await page.context().close()
})

test('story 19: the record of the angle, linear friction chosen by the ladder', async ({ browser }) => {
  const { page } = await opening(browser)
  await state(page, '0.8', '0.001')
  await page.locator('#data-file').setInputFiles(RECORD.replace('70deg', '100deg'))
  await expect(page.locator('#data-ladder tr.chosen')).toContainText('linear')
  const [found = Number.NaN, u = Number.NaN] = numbers(await page.locator('#data-period0').textContent())
  expect(Math.abs(found - 2 * Math.PI * Math.sqrt(0.8 / 9.81))).toBeLessThan(2 * u)
  // Quadratic friction was tried and is not needed.
  await expect(page.locator('#data-ladder tbody')).toContainText('+ quadratic')
  await page.context().close()
})

test('story 19: several lengths give g and what every length misses', async ({ browser }) => {
  const { page } = await opening(browser)
  const files = (LENGTHS.files as { name: string; text: string }[]).map(({ name, text }) => ({
    name,
    mimeType: 'text/plain',
    buffer: Buffer.from(text),
  }))
  await page.locator('#data-file').setInputFiles(files.slice(0, 1))
  await expect(page.locator('#data-omega0')).toBeVisible()
  await page.locator('#data-more').setInputFiles(files.slice(1))
  await expect(page.locator('#data-records tbody tr')).toHaveCount(3)
  // By keys: the focus stays where it is while a fit begins.
  await page.locator('#data-length-0').focus()
  for (const [i, each] of ['0.4', '0.7', '1'].entries()) {
    await page.keyboard.insertText(each)
    await page.keyboard.press('Tab')
    await page.keyboard.insertText('0.0005')
    await page.keyboard.press('Tab')
    if (i < 2) await page.locator(`#data-length-${i + 1}`).focus()
  }
  await expect(page.locator('#data-offset')).toBeVisible()
  const { g, length_offset: offset } = LENGTHS.answer
  const [value = Number.NaN] = numbers(await page.locator('#data-g').textContent())
  expect(Math.abs(value - g.value)).toBeLessThan(0.002)
  expect(Math.abs(value - 9.81)).toBeLessThan(2 * g.u)
  const [missing = Number.NaN] = numbers(await page.locator('#data-offset').textContent())
  expect(Math.abs(missing - offset.value)).toBeLessThan(1e-4)
  await expect(page.locator('#page .sentence')).toContainText('from 3 records together')
  await expect(page.locator('#data-verdicts')).toContainText('every stated length is short by 0.0121 m')
  // Each record is drawn when its name is chosen.
  await page.getByRole('button', { name: '1000mm.csv', exact: true }).click()
  const periods = column(await csvOf(page, 'data'), 'measured')
  expect(periods[0]).toBeGreaterThan(2)
  // Without one of them.
  await page.getByRole('button', { name: 'Remove: 400mm.csv' }).click()
  await expect(page.locator('#data-records tbody tr')).toHaveCount(2)
  await expect(page.locator('#data-offset')).toHaveCount(0)
  await page.context().close()
})

/** A table of swings and the rod of its pendulum, with the last field not yet left. */
async function rodOf(page: Page): Promise<void> {
  await give(
    page,
    'swings.csv',
    JSON.parse(await readFile(RECORD.replace('record-70deg.csv', 'fits.json'), 'utf8'))[2].files[0].text,
  )
  await page.getByRole('button', { name: 'Parts' }).click()
  await page.locator('#data-part-0-size').fill('0.495±0.001')
  await page.locator('#data-part-0-mass').fill('19 g')
}

test('story 19: a rigid pendulum by its parts', async ({ browser }) => {
  const { page } = await opening(browser)
  await rodOf(page)
  await page.locator('#data-add-part').click()
  await page.locator('#data-part-1-distance').fill('495±1 mm')
  await page.locator('#data-part-1-mass').fill('31 g')
  await page.locator('#data-part-1-mass').blur()
  await expect(page.locator('#data-g')).toHaveText(/^9\.813 ± 0\.018/)
  await page.locator('#data-part-1-mass').fill('heavy')
  await page.locator('#data-part-1-mass').blur()
  await expect(page.locator('#data-fault')).toContainText('heavy')
  await page.context().close()
})

/** Workers wait with their work until they are let go, and that is done when they have told all. */
async function heldWorkers(page: Page): Promise<() => Promise<void>> {
  await page.evaluate(() => {
    const { postMessage } = Worker.prototype
    const waiting: (() => Promise<void>)[] = []
    Worker.prototype.postMessage = function wait(this: Worker, message: unknown) {
      const told = new Promise<void>((done) => {
        this.addEventListener('message', ({ data }) => /fitted|refused|failed/.test(data.kind) && done())
      })
      waiting.push(() => {
        postMessage.call(this, message)
        return told
      })
    }
    Object.assign(window, {
      letWorkersGo: () => {
        Worker.prototype.postMessage = postMessage
        return waiting.at(-1)?.()
      },
    })
  })
  return () => page.evaluate(() => (window as unknown as { letWorkersGo: () => Promise<void> }).letWorkersGo())
}

/** Puts the mouse on the button of a new part, and presses. */
async function pressAddPart(page: Page): Promise<void> {
  const button = page.locator('#data-add-part')
  await button.scrollIntoViewIfNeeded()
  const box = await button.boundingBox()
  if (!box) throw new Error('no button')
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2)
  await page.mouse.down()
}

for (const [width, height] of [
  [1280, 720],
  [360, 640],
] as const) {
  test(`a click counts that leaves a field, and so has the file fitted again, ${width} wide`, async ({ browser }) => {
    const { page } = await opening(browser)
    await page.setViewportSize({ width, height })
    await rodOf(page)
    await page.locator('#data-part-0-mass').blur()
    await expect(page.locator('#data-g')).toBeVisible()
    const letGo = await heldWorkers(page)
    await page.locator('#data-part-0-mass').fill('20 g')
    await pressAddPart(page)
    await drawn(page)
    await page.mouse.up()
    await expect(page.locator('#data-part-1-mass')).toBeVisible()
    await letGo()
    await page.locator('#data-part-1-distance').fill('0.495')
    await page.locator('#data-part-1-mass').fill('31 g')
    await page.locator('#data-part-1-mass').blur()
    await expect(page.locator('#data-g')).toBeVisible()
    await page.context().close()
  })

  test(`a click counts in which a fit ends, ${width} wide`, async ({ browser }) => {
    const { page } = await opening(browser)
    await page.setViewportSize({ width, height })
    await rodOf(page)
    await page.locator('#data-part-0-mass').blur()
    await expect(page.locator('#data-g')).toBeVisible()
    const letGo = await heldWorkers(page)
    await page.locator('#data-part-0-mass').fill('20 g')
    await page.keyboard.press('Enter')
    await expect(page.locator('#data-cancel')).toBeAttached()
    // What was understood before stands until the file is read again.
    await expect(page.locator('#data-understood')).toBeVisible()
    await pressAddPart(page)
    await letGo()
    await drawn(page)
    await page.mouse.up()
    await expect(page.locator('#data-part-1-mass')).toBeVisible()
    await page.context().close()
  })
}

test('story 14: what was understood, refusals and verdicts in Portuguese and Spanish', async ({ browser }) => {
  const { page } = await opening(browser)
  await state(page, '0.8', '0.001')
  await give(
    page,
    'question.csv',
    rows('t [s],theta,phi', ({ t, theta }) => [t, (theta * 180) / Math.PI, 0.2 * theta], ','),
  )
  await expect(page.locator('#data-refusal')).toContainText('which column is the angle?')
  await show(page, 'view=data&t=0s&lang=pt-BR')
  await expect(page.locator('#data-refusal')).toContainText('question.csv: qual coluna é o ângulo?')
  await show(page, 'view=data&t=0s&lang=es')
  await expect(page.locator('#data-refusal')).toContainText('¿qué columna es el ángulo?')
  await expect(page.locator('#data-refusal')).not.toHaveAttribute('lang')
  // A length that is 5 % off is a warning.
  await page.locator('#data-length').fill('0.84')
  await page.locator('#data-file').setInputFiles(RECORD)
  await expect(page.locator('#data-verdicts')).toContainText('la longitud indicada está errada en un 5')
  await expect(page.locator('#data-understood')).toContainText('Columnas leídas')
  await expect(page.locator('#data-understood')).not.toContainText('Columns read')
  await page.context().close()
})

test('story 13: a fit works at a second visit without a network', async ({ browser }) => {
  const context = await browser.newContext()
  const page = await context.newPage()
  await page.goto(`${address()}#view=data&t=0s&lang=en`)
  await page.locator('#data-file').setInputFiles(RECORD)
  await expect(page.locator('#data-omega0')).toBeVisible()
  await page.getByRole('button', { name: 'From a period' }).click()
  // Once all parts of the page, and again with the modules of the reader, of the fit and of a period.
  await expect(page.locator('html')).toHaveAttribute('data-kept', /[4-9]/)
  await context.setOffline(true)
  await page.goto('about:blank')
  await page.goto(`${address()}#view=data&t=0s&lang=en`)
  await state(page, '0.8', '0.001')
  await page.locator('#data-file').setInputFiles(RECORD)
  await expect(page.locator('#data-g')).toHaveText(/^9\.810 ± 0\.012/)
  await page.getByRole('button', { name: 'From a period' }).click()
  await page.locator('#timing-example').click()
  await expect(page.locator('#timing-g')).toHaveText(/^9\.810 ± 0\.031/)
  await context.close()
})
