// Stories 16 to 19: files of several tools are read without a question, and g comes out with its uncertainty; from a period that was
// timed; from periods that fall with the swing, and of several records; nothing leaves.

import { readFile } from 'node:fs/promises'
import AxeBuilder from '@axe-core/playwright'
import type { Page } from '@playwright/test'
import { load, Pendulum } from 'libration'
import { address, column, csvOf, drawn, expect, largest, opened, show, test } from './lab'
import { layoutFaults, SCREENS } from './layout'
import { DIST } from './server'

const RECORD = new URL('../record-70deg.csv', import.meta.url).pathname
const WANTED = JSON.parse(await readFile(RECORD.replace('.csv', '.json'), 'utf8'))
const TAGS = ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa', 'wcag22aa', 'best-practice']

test.beforeAll(() => load())

/** The view in a page of its own: what is measured stays with a visit. Keeps the addresses that it asks for. */
async function opening(browser: import('@playwright/test').Browser, options = {}) {
  const page = await opened(browser, 't=0s&lang=en', options)
  const asked: string[] = []
  page.on('request', (request) => asked.push(request.url()))
  await show(page, 'view=data&t=0s&lang=en')
  await expect(page.locator('#data-file')).toBeAttached()
  return { page, asked }
}

async function give(page: Page, name: string, text: string): Promise<void> {
  await page.locator('#data-file').setInputFiles({ name, mimeType: 'text/plain', buffer: Buffer.from(text) })
}

async function state(page: Page, length: string, u: string): Promise<void> {
  await page.locator('#data-length').fill(length)
  await page.locator('#data-lengthU').fill(u)
  await page.locator('#data-lengthU').blur()
}

/** `9.81 ± 0.01 m/s²` as its two numbers. */
const numbers = (text: string | null): number[] => [...(text ?? '').matchAll(/\d+(?:\.\d+)?/g)].map(Number)

/** A swing of 0.8 m from 1 rad, 30 times a second, with a scatter of some 0.002 rad. */
function swing(count: number, rate = 30) {
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

type Row = ReturnType<typeof swing>[number]
const rows = (head: string, each: (row: Row) => readonly number[], between: string, point = '.', count = 300) =>
  `${head}\n${swing(count)
    .map((row) =>
      each(row)
        .map((value) => value.toFixed(6).replace('.', point))
        .join(between),
    )
    .join('\n')}\n`
const angle = ({ t, theta }: Row) => [t, (theta * 180) / Math.PI]
const place = ({ t, theta }: Row) => [t, 0.8 * Math.sin(theta) + 0.1, -0.8 * Math.cos(theta) + 0.2]

/** Passages of a light gate: twice a period. */
function passages(): string {
  const { period } = new Pendulum({ theta0: 0.3, length: 0.8, gravity: 9.81 })
  const events = Array.from({ length: 40 }, (_, i) => 0.5 * i * period)
  const lines = events.flatMap((time, i) => {
    const late = time + 0.0002 * (((i * 7919) % 13) / 13 - 0.5)
    return [
      `${late.toFixed(6)},${late.toFixed(6)},1,0,`,
      `${(late + 0.02).toFixed(6)},${(late + 0.02).toFixed(6)},0,0,`,
    ]
  })
  return `Time,Event Time,State at A,State at B,Comment\ns,s,State,State,\n\n${lines.join('\n')}\n`
}

/** Name, text, and what is said of the measured column. */
const FILES: readonly (readonly [string, () => string, string])[] = [
  ['tracker-5.txt', () => rows('\tmass A\t\nt\tx\ty', place, '\t'), 'the angle'],
  ['tracker-5-comma.txt', () => rows('mass A\nt\tx\ty', place, '\t', ','), 'the angle'],
  ['tracker-6.txt', () => rows('#multi:\n#mass A\nt\tx\ty', place, '\t'), 'the angle'],
  [
    'phyphox.csv',
    () => rows('"Time (s)","Gyroscope x (rad/s)"', ({ t, velocity }) => [t, velocity], ','),
    'the angular velocity',
  ],
  [
    'phyphox-comma.csv',
    () => rows('"Time (s)";"Gyroscope x (rad/s)"', ({ t, velocity }) => [t, velocity], ';', ','),
    'the angular velocity',
  ],
  [
    'graphical-analysis.csv',
    () => rows('Latest: Time (s),Latest: Angle (rad)', ({ t, theta }) => [t, theta], ','),
    'the angle',
  ],
  ['kinovea.txt', () => rows('#Kinovea Trajectory data export\n#T X Y', place, ' '), 'the angle'],
  ['spreadsheet.txt', () => rows('Tempo (s)\tÂngulo (°)', angle, '\t', ','), 'the angle'],
  ['point.csv', () => rows('t / s;angle / deg', angle, ';'), 'the angle'],
  ['gate.csv', passages, 'the period, by a light gate'],
]

test('story 16: files of many tools are understood without a question, and nothing leaves the machine', async ({
  browser,
}) => {
  const { page, asked } = await opening(browser)
  await expect.poll(() => asked.filter((each) => each.endsWith('.wasm')).length).toBe(1)
  expect(asked[0]).toContain('libration-fit')
  await state(page, '0.8', '0.001')
  const before = asked.filter((each) => !each.startsWith('blob:')).length
  for (const [name, text, what] of FILES) {
    await give(page, name, text())
    await expect(page.locator('.file-name')).toHaveText(name)
    await expect(page.locator('#data-g, #data-refusal').first(), name).toBeVisible()
    await expect(page.locator('#data-refusal'), name).toHaveCount(0)
    await expect(page.locator('#data-rows'), name).toContainText(what)
    const [g = Number.NaN, u = Number.NaN] = numbers(await page.locator('#data-g').textContent())
    // Gates at one swing hardly tell it, and say so by their uncertainty.
    expect(Math.abs(g - 9.81), `${name}: ${g}`).toBeLessThan(name === 'gate.csv' ? 3 * u : 0.05)
    // Without that there were no numbers, and with another separator or sign of decimals not these.
    await expect(page.locator('#data-understood'), name).not.toBeEmpty()
  }
  // A table as it is pasted from a spreadsheet.
  await page.locator('summary', { hasText: 'Paste' }).click()
  await page.locator('#data-text').fill(rows('t\ttheta (deg)', angle, '\t', ','))
  await page.locator('#data-read').click()
  await expect(page.locator('.file-name')).toHaveText('pasted table')
  await expect(page.locator('#data-g')).toBeVisible()
  expect(asked.filter((each) => !each.startsWith('blob:')).length).toBe(before)
  await page.context().close()
})

test('story 16: one clear question, and the answer to it', async ({ browser }) => {
  const { page } = await opening(browser)
  await state(page, '0.8', '0.001')
  await give(
    page,
    'two.csv',
    rows('t,one,theta', (row) => [row.t, 0.5 * row.theta, row.theta], ','),
  )
  await expect(page.locator('#data-g, #data-refusal').first()).toBeVisible()
  await give(
    page,
    'asks.csv',
    rows('t,theta,phi', (row) => [row.t, (row.theta * 180) / Math.PI, row.velocity], ','),
  )
  await expect(page.locator('#data-refusal')).toContainText('asks.csv: ')
  await expect(page.locator('#data-refusal')).toContainText('write --column angle=')
  await page.locator('#data-correct summary').click()
  await page.locator('#data-column-angle').fill('theta')
  await page.locator('#data-unit-angle').fill('deg')
  await page.keyboard.press('Enter')
  await expect(page.locator('#data-g')).toBeVisible()
  await expect(page.locator('#data-understood')).toContainText('theta')
  // Malformed files: the lines of the command.
  for (const [text, line] of [
    ['', 'bad.csv: is empty'],
    ['PK\u0003\u0004', 'bad.csv: an archive or a workbook; give a table from it as text'],
  ] as const) {
    await give(page, 'bad.csv', text)
    await expect(page.locator('#data-refusal')).toHaveText(line)
  }
  await page.context().close()
})

test('story 17: g with its uncertainty, budget, friction and residuals', async ({ browser }) => {
  const { page } = await opening(browser)
  await state(page, '0,800', '0.001')
  await page.locator('#data-file').setInputFiles(RECORD)
  await expect(page.locator('#data-g')).toHaveText(/^9\.810 ± 0\.012\sm\/s²/)
  await expect(page.locator('#page .sentence')).toContainText('from 600 samples of swings up to 70°')
  const budget: string[][] = []
  for (const row of await page.locator('#data-budget tbody tr').all())
    budget.push(await row.locator('th, td').allTextContents())
  expect(budget.find(([name]) => name === 'length')?.[1]).toBe('0.012')
  expect(budget.find(([name]) => name?.startsWith('fit: noise'))?.[1]).toBe(WANTED.budget[0].u.toFixed(4))
  await expect(page.locator('#data-ladder tr.chosen')).toContainText('linear')
  // The linear equation leaves a pattern, the pendulum's noise.
  const sine = Number((await page.locator('#data-sine td').first().textContent())?.trim())
  expect(sine).toBeGreaterThan(5 * WANTED.rms_deg)
  await expect(page.locator('#data-verdicts')).toContainText('Nothing speaks against')
  // The curve and the residuals are those of the record.
  const sheet = await csvOf(page, 'data')
  const [measured, fitted, residual] = ['measured', 'fitted', 'residual'].map((name) => column(sheet, name)) as [
    Float64Array,
    Float64Array,
    Float64Array,
  ]
  expect(measured.length).toBe(600)
  expect(largest(measured.map((each, i) => each - (fitted[i] as number) - (residual[i] as number)))).toBeLessThan(1e-12)
  const rms = Math.sqrt(residual.reduce((sum, each) => sum + each * each, 0) / residual.length)
  expect(Math.abs(rms / WANTED.rms_deg - 1)).toBeLessThan(0.01)
  // L from g.
  await page.getByRole('button', { name: 'Gravity' }).click()
  await page.locator('#data-gravity').fill('9.81')
  await page.locator('#data-gravityU').fill('0.0001')
  await page.keyboard.press('Enter')
  await expect(page.locator('#page .sentence')).toContainText('L = ')
  const [length = Number.NaN] = numbers(await page.locator('#data-length-found').textContent())
  expect(Math.abs(length - 0.8)).toBeLessThan(5e-4)
  // Not a number: said, and the result stays away from it.
  await page.locator('#data-gravity').fill('strong')
  await page.locator('#data-gravity').blur()
  await expect(page.locator('#data-fault')).toContainText('strong')
  await page.context().close()
})

test('story 17: with keys only', async ({ browser }) => {
  const { page } = await opening(browser)
  await page.locator('#data-length').focus()
  await page.keyboard.type('0.8')
  await page.keyboard.press('Tab')
  await page.keyboard.type('0.001')
  await page.locator('summary', { hasText: 'Paste' }).focus()
  await page.keyboard.press('Enter')
  await page.keyboard.press('Tab')
  await expect(page.locator('#data-text')).toBeFocused()
  await page.keyboard.insertText(await readFile(RECORD, 'utf8'))
  await page.keyboard.press('Tab')
  await page.keyboard.press('Enter')
  await expect(page.locator('#data-g')).toHaveText(/^9\.810 ± 0\.012/)
  // What came out is spoken.
  await expect(page.locator('#live')).toContainText('9.810 ± 0.012')
  await page.context().close()
})

test('story 16: the columns of both coordinates with their units, where the program took others', async ({
  browser,
}) => {
  const { page } = await opening(browser)
  await state(page, '0.8', '0.001')
  // Two marks on the rod, of which the second was tracked in millimetres; their names say nothing.
  await give(
    page,
    'marks.csv',
    rows(
      't [s],a,b,c,d',
      (row) => [
        ...place(row).map((each, i) => (i === 0 ? each : 0.5 * each)),
        ...place(row)
          .slice(1)
          .map((each) => 1000 * each),
      ],
      ',',
    ),
  )
  await expect(page.locator('#data-refusal, #data-omega0').first()).toBeVisible()
  await page.locator('#data-correct summary').click()
  for (const [role, column] of [
    ['x', 'c'],
    ['y', '5'],
  ] as const) {
    await page.locator(`#data-column-${role}`).fill(column)
    await page.locator(`#data-unit-${role}`).fill('mm')
  }
  await page.locator('#data-unit-y').blur()
  await expect(page.locator('#data-understood')).toContainText('The pivot is')
  await expect(page.locator('#data-understood')).toContainText('"c"')
  await expect(page.locator('#data-g')).toHaveText(/^9\.8/)
  await page.context().close()
})

/** T, the length and the swing of the story, as they are typed. */
async function time(page: Page, all: Readonly<Record<string, string>>): Promise<void> {
  for (const [name, text] of Object.entries(all)) await page.locator(`#timing-${name}`).fill(text)
}

test('story 18: T, the length and the swing give g, beside the formula of small swings and the place', async ({
  browser,
}) => {
  const { page, asked } = await opening(browser)
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
  const [byPeriod = Number.NaN] = numbers(await page.locator('#timing-g').textContent())
  expect(Math.abs(byPeriod - 9.81)).toBeLessThan(1e-3)
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

const GATE = RECORD.replace('record-70deg', 'gate-100deg')

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

/** Tables of periods against release angles at three lengths, each 12 mm short. */
const LENGTHS = JSON.parse(await readFile(RECORD.replace('record-70deg.csv', 'fits.json'), 'utf8'))[0]

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

test('story 19: a rigid pendulum by its parts', async ({ browser }) => {
  const { page } = await opening(browser)
  await give(
    page,
    'swings.csv',
    JSON.parse(await readFile(RECORD.replace('record-70deg.csv', 'fits.json'), 'utf8'))[2].files[0].text,
  )
  await page.getByRole('button', { name: 'Parts' }).click()
  await page.locator('#data-part-0-size').fill('0.495±0.001')
  await page.locator('#data-part-0-mass').fill('19 g')
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
  // Once all parts of the page, and again once the module of the fit has come.
  await expect(page.locator('html')).toHaveAttribute('data-kept', /[2-9]/)
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

test('a file that is dropped is read', async ({ browser }) => {
  const { page } = await opening(browser)
  const dropped = await page.evaluateHandle(
    (text) => {
      const transfer = new DataTransfer()
      transfer.items.add(new File([text], 'dropped.csv'))
      return transfer
    },
    await readFile(RECORD, 'utf8'),
  )
  await page.locator('.drop').dispatchEvent('drop', { dataTransfer: dropped })
  await expect(page.locator('.file-name')).toHaveText('dropped.csv')
  await expect(page.locator('#data-omega0')).toBeVisible()
  await page.context().close()
})

test('the offline file says that it has no fit', async ({ browser }) => {
  const context = await browser.newContext({ offline: true })
  const page = await context.newPage()
  await page.goto(`file://${DIST}offline.html#view=data&t=0s&lang=es`)
  await expect(page.locator('#data-absent')).toContainText('libration lab')
  await expect(page.locator('#data-file')).toHaveCount(0)
  await context.close()
})

/** 20,000 samples. */
const long = () => rows('t / s,angle / rad', ({ t, theta }) => [t, theta], ',', '.', 20_000)

test('20,000 samples: the page answers while they are fitted', async ({ browser }) => {
  const { page } = await opening(browser)
  await state(page, '0.8', '0.001')
  await page.evaluate(() => {
    const counted = window as unknown as { answered: number }
    counted.answered = 0
    setInterval(() => {
      if (document.querySelector('#data-cancel')) counted.answered++
    }, 5)
  })
  await give(page, 'long.csv', long())
  await expect(page.locator('#data-g')).toBeVisible({ timeout: 120_000 })
  await expect(page.locator('#data-rows')).toContainText('20000 values')
  const answered = await page.evaluate(() => (window as unknown as { answered: number }).answered)
  expect(answered).toBeGreaterThan(2)
  await page.context().close()
})

test('a fit can be cancelled and begun again', async ({ browser }) => {
  const { page } = await opening(browser)
  await page.evaluate(() => {
    const watch = new MutationObserver(() => {
      const button = document.querySelector<HTMLElement>('#data-cancel')
      if (!button) return
      watch.disconnect()
      button.click()
    })
    watch.observe(document.body, { childList: true, subtree: true })
  })
  await give(page, 'long.csv', long())
  await expect(page.locator('#data-again')).toBeVisible()
  await expect(page.locator('#data-omega0')).toHaveCount(0)
  await page.locator('#data-again').click()
  await expect(page.locator('#data-omega0')).toBeVisible({ timeout: 120_000 })
  await page.context().close()
})

/** Faults of axe and of the layout in every language, theme and size. */
async function faultsOf(page: Page, link: string): Promise<string[]> {
  const faults: string[] = []
  for (const language of ['en', 'pt-BR', 'es'] as const) {
    for (const theme of ['light', 'dark'] as const) {
      await show(page, `${link}&lang=${language}&theme=${theme}`)
      await expect(page.locator('html')).toHaveAttribute('lang', language)
      const { violations } = await new AxeBuilder({ page }).withTags(TAGS).analyze()
      faults.push(...violations.map(({ id, nodes }) => `${language} ${theme} ${id}: ${nodes[0]?.html}`))
    }
    for (const [width, height] of SCREENS) {
      await page.setViewportSize({ width, height })
      await drawn(page)
      faults.push(...(await layoutFaults(page)).map((each) => `${language} ${width}: ${each}`))
    }
    await page.setViewportSize({ width: 1280, height: 720 })
  }
  return faults
}

test('axe and the layout find nothing with several records and a period, in any language', async ({ browser }) => {
  const { page } = await opening(browser)
  const files = (LENGTHS.files as { name: string; text: string }[]).map(({ name, text }) => ({
    name,
    mimeType: 'text/plain',
    buffer: Buffer.from(text),
  }))
  await page.locator('#data-file').setInputFiles(files)
  await expect(page.locator('#data-records')).toBeVisible()
  await page.locator('#data-bob summary').click()
  expect(await faultsOf(page, 'view=data&t=0s')).toEqual([])
  await page.locator('#data-file').setInputFiles(GATE)
  await page.getByRole('button', { name: 'Partes' }).click()
  await page.locator('#data-add-part').click()
  await expect(page.locator('#data-period0')).toBeVisible()
  expect(await faultsOf(page, 'view=data&t=0s')).toEqual([])
  await show(page, 'view=data&from=period&t=0s&lang=en')
  await page.locator('#timing-example').click()
  await time(page, { latitude: '-23.3', height: '585' })
  await expect(page.locator('#timing-difference')).toBeVisible()
  expect(await faultsOf(page, 'view=data&from=period&t=0s')).toEqual([])
  await page.context().close()
})

test('axe and the layout find nothing with a result, in any language', async ({ browser }) => {
  const { page } = await opening(browser)
  await state(page, '0.8', '0.001')
  await page.locator('#data-file').setInputFiles(RECORD)
  await expect(page.locator('#data-g')).toBeVisible()
  await page.locator('#data-correct summary').click()
  expect(await faultsOf(page, 'view=data&t=0s')).toEqual([])
  await page.locator('#data-correct summary').click()
  await drawn(page)
  expect(await layoutFaults(page, true)).toEqual([])
  await page.context().close()
})
