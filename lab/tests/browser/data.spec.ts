// Stories 16 and 17: files of several tools are read without a question, and g comes out with its uncertainty; nothing leaves.

import { readFile } from 'node:fs/promises'
import type { Page } from '@playwright/test'
import { load, Pendulum } from 'libration'
import { violations } from './axe'
import { angle, GATE, give, LENGTHS, numbers, opening, place, RECORD, rows, state, time, WANTED, watched } from './data'
import { column, csvOf, drawn, expect, largest, show, test } from './lab'
import { layoutFaults, SCREENS } from './layout'
import { DIST } from './server'

test.beforeAll(() => load())

/** Passages of a light gate by a bob of 20 mm: twice a period, of swings that decay. */
function passages(): string {
  let event = 0
  const lines = Array.from({ length: 60 }, (_, i) => {
    const theta0 = 0.9 * 0.98 ** i
    const dark = 0.02 / (2 * Math.sqrt(9.81 * 0.8) * Math.sin(theta0 / 2))
    const late = event + 0.0002 * (((i * 7919) % 13) / 13 - 0.5)
    event += 0.5 * new Pendulum({ theta0, length: 0.8, gravity: 9.81 }).period
    return [
      `${late.toFixed(6)},${late.toFixed(6)},1,0,`,
      `${(late + dark).toFixed(6)},${(late + dark).toFixed(6)},0,0,`,
    ]
  }).flat()
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
  const { page, asked } = await watched(browser)
  await expect.poll(() => asked.filter((each) => each.endsWith('.wasm')).length).toBe(1)
  expect(asked[0]).toContain('libration-reader')
  await state(page, '0.8', '0.001')
  const before = asked.filter((each) => !each.startsWith('blob:')).length
  for (const [name, text, what] of FILES) {
    await give(page, name, text())
    await expect(page.locator('.file-name')).toHaveText(name)
    await expect(page.locator('#data-g, #data-refusal').first(), name).toBeVisible()
    await expect(page.locator('#data-refusal'), name).toHaveCount(0)
    await expect(page.locator('#data-rows'), name).toContainText(what)
    const [g = Number.NaN] = numbers(await page.locator('#data-g').textContent())
    expect(Math.abs(g - 9.81), `${name}: ${g}`).toBeLessThan(0.05)
    // Without that there were no numbers, and with another separator or sign of decimals not these.
    await expect(page.locator('#data-understood'), name).not.toBeEmpty()
    await expect(page.locator('#page .sentence'), name).toContainText(name === 'gate.csv' ? / periods/ : / samples/)
  }
  // A table as it is pasted from a spreadsheet.
  await page.locator('summary', { hasText: 'Paste' }).click()
  await page.locator('#data-text').fill(rows('t\ttheta (deg)', angle, '\t', ','))
  await page.locator('#data-read').click()
  await expect(page.locator('.file-name')).toHaveText('pasted table')
  await expect(page.locator('#data-g')).toBeVisible()
  // The fit itself came with the first file.
  const later = asked.filter((each) => !each.startsWith('blob:')).slice(before)
  expect(later.map((each) => each.replace(/.*(libration-\w+).*/, '$1'))).toEqual(['libration-fit'])
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
  // The question opens its fields.
  await expect(page.locator('#data-correct')).toHaveAttribute('open', '')
  await page.locator('#data-column-angle').fill('theta')
  await page.locator('#data-unit-angle').fill('deg')
  await page.keyboard.press('Enter')
  await expect(page.locator('#data-g')).toBeVisible()
  await expect(page.locator('#data-understood')).toContainText('theta')
  // Malformed files: the lines of the command.
  for (const [text, line] of [
    ['', 'bad.csv: is empty'],
    ['PK\u0003\u0004', 'bad.csv: a ZIP archive that cannot be unpacked: Missing end of central directory'],
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
  await expect(page.locator('#data-verdicts')).toContainText('No warnings.')
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
  // A question has opened the fields by itself.
  if ((await page.locator('#data-correct[open]').count()) === 0) await page.locator('#data-correct summary').click()
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

test('a folder that is dropped is named, and the next file is read', async ({ browser }) => {
  const { page } = await opening(browser)
  const errors: string[] = []
  page.on('pageerror', (error) => errors.push(String(error)))
  const drop = (name: string, text: string | null) =>
    page.evaluate(
      ([called, content]) => {
        const file = new File([content ?? ''], called as string)
        // What a browser says of a folder.
        if (content === null) file.arrayBuffer = () => Promise.reject(new DOMException('not found', 'NotFoundError'))
        const event = new Event('drop', { bubbles: true, cancelable: true })
        Object.defineProperty(event, 'dataTransfer', { value: { files: [file] } })
        document.querySelector('.drop')?.dispatchEvent(event)
      },
      [name, text] as const,
    )
  await drop('records', null)
  await expect(page.locator('.refusal')).toContainText('records: not found.')
  await drop('record.csv', await readFile(RECORD, 'utf8'))
  await expect(page.locator('.file-name')).toHaveText('record.csv')
  await expect(page.locator('#data-omega0')).toBeVisible()
  expect(errors).toEqual([])
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

/** 20,000 samples of 100 s. */
const long = () => rows('t / s,angle / rad', ({ t, theta }) => [t, theta], ',', '.', 20_000, 200)

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
  await expect(page.locator('#data-g')).toBeVisible()
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
  await page.locator('#data-file').setInputFiles(RECORD)
  await expect(page.locator('#data-again')).toBeVisible()
  await expect(page.locator('#data-omega0')).toHaveCount(0)
  await page.locator('#data-again').click()
  await expect(page.locator('#data-omega0')).toBeVisible()
  await page.context().close()
})

/** Faults of axe and of the layout in every language, theme and size; what is read is left in Spanish. */
async function faultsOf(page: Page, link: string): Promise<string[]> {
  const faults: string[] = []
  for (const language of ['en', 'pt-BR', 'es'] as const) {
    // Colours in the light of the one language, in the dark of another.
    for (const [theme, rules] of [
      ...(language === 'es' ? [['dark', 'colours'] as const] : []),
      ...(language === 'pt-BR' ? [['light', 'colours'] as const] : []),
      ['light', 'words'] as const,
    ]) {
      await show(page, `${link}&lang=${language}&theme=${theme}`)
      await expect(page.locator('html')).toHaveAttribute('lang', language)
      faults.push(...(await violations(page, rules)).map((each) => `${language} ${theme} ${each}`))
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
