// Story 6: the period against the amplitude, with every formula; the table of errors was calculated with 30 digits.

import { column, csvOf, expect, sheet, show, test } from './lab'

const ANGLES = [10, 30, 60, 90, 120, 150, 170, 179]
const EXACT = [1.001907, 1.017409, 1.073182, 1.180341, 1.372881, 1.762204, 2.439363, 3.901065]

/** Errors in %, by mpmath with 40 digits, rounded. */
const ERRORS: Readonly<Record<string, readonly string[]>> = {
  linear: ['-0.190', '-1.711', '-6.819', '-15.279', '-27.160', '-43.253', '-59.006', '-74.366'],
  bernoulli: ['-0.0003', '-0.027', '-0.433', '-2.214', '-7.191', '-18.944', '-36.450', '-58.729'],
  'series:4': ['-0.0000', '-0.0005', '-0.031', '-0.367', '-2.173', '-9.399', '-25.074', '-49.985'],
  'kidd-fogg': ['0.0001', '0.0075', '0.129', '0.751', '3.011', '11.544', '38.860', '174.407'],
  molina: ['0.0000', '0.0035', '0.061', '0.355', '1.436', '5.577', '18.842', '79.327'],
  'ganley-parwani': ['-0.0000', '-0.0005', '-0.011', '-0.078', '-0.428', '-2.442', '-10.687', '-35.118'],
  'lima-arun': ['0.0000', '0.0025', '0.043', '0.249', '0.977', '3.485', '9.579', '22.611'],
  'agm:1': ['-0.0001', '-0.0075', '-0.129', '-0.743', '-2.881', '-9.841', '-24.584', '-49.175'],
  belendez: ['-0.0000', '-0.0000', '-0.0000', '-0.0014', '-0.022', '-0.282', '-2.255', '-14.236'],
  cromer: ['-11.67', '-11.09', '-9.23', '-6.537', '-3.574', '-1.089', '-0.141', '-0.0016'],
  'salas-26': ['0', '-0.0006', '-0.042', '-0.545', '-3.537', '-15.397', '-35.983', '-59.721'],
  'salas-27': ['0', '0', '-0.0002', '-0.017', '-0.423', '-5.720', '-24.503', '-52.051'],
  'salas-28': ['0', '0', '0', '-0.0005', '-0.049', '-2.091', '-17.294', '-46.847'],
}

test('story 6: every formula has the errors of the table, to its last digit', async ({ lab }) => {
  const keys = Object.keys(ERRORS)
  await show(lab, `view=period&th0=150deg&periods=${keys.join(',')}&t=0s`)
  const ratios = await csvOf(lab, 'period')
  const errors = await csvOf(lab, 'period-error')
  const angles = column(ratios, 'θmax, °')
  const rows = ANGLES.map((angle) => angles.indexOf(angle))
  expect(Math.min(...rows)).toBeGreaterThanOrEqual(0)
  EXACT.forEach((truth, i) => {
    expect(column(ratios, 'exact')[rows[i] as number]?.toFixed(6)).toBe(truth.toFixed(6))
  })
  // Columns stand in the order of the registry, which is that of the list.
  const drawn = await lab
    .locator('.formulas input[type=checkbox]:checked')
    .evaluateAll((all) => all.map(({ id }) => id.replace('period-', '')))
  expect(drawn.length).toBe(keys.length)
  expect(errors.header.length).toBe(keys.length + 1)
  let compared = 0
  drawn.forEach((name, place) => {
    const key = keys.find((each) => each.split(':')[0] === name) ?? name
    const values = column(errors, errors.header[place + 1] as string)
    ;(ERRORS[key] as readonly string[]).forEach((printed, i) => {
      const decimals = printed.split('.')[1]?.length ?? 4
      expect(
        Math.abs((values[rows[i] as number] as number) - Number(printed)),
        `${key} at ${ANGLES[i]}`,
      ).toBeLessThanOrEqual(0.5000001 * 10 ** -decimals)
      compared++
    })
  })
  expect(compared).toBe(13 * 8)
})

test('story 6: the table on the page and its CSV are the same numbers, and each formula can be switched', async ({
  lab,
}) => {
  await show(lab, 'view=period&th0=150deg&periods=linear,lima-arun&t=0s')
  const figure = lab.locator('[data-chart=period-error]')
  await figure.locator('[data-tool=table]').click()
  await figure.getByRole('button', { name: /^all/ }).click()
  await expect(figure.getByRole('button', { name: 'fewer rows' })).toBeVisible()
  const cells = await figure
    .locator('tbody tr')
    .evaluateAll((rows) => rows.map((row) => [...row.children].map((cell) => cell.textContent ?? '')))
  await figure.locator('[data-tool=table]').click()
  const csv = await csvOf(lab, 'period-error')
  expect(cells.length).toBe(column(csv, csv.header[0] as string).length)
  cells.forEach((row, i) => {
    row.forEach((text, k) => {
      const value = column(csv, csv.header[k] as string)[i] as number
      const shown = text.replace('−', '-').replace('∞', 'Infinity')
      if (Number.isFinite(value)) expect(Math.abs(Number(shown) - value)).toBeLessThanOrEqual(k === 0 ? 0.51 : 0.000051)
    })
  })
  const curves = lab.locator('[data-chart=period-error] path.c:not(.halo)')
  const before = await curves.count()
  await lab.locator('#period-cromer').check()
  await expect(curves).toHaveCount(before + 1)
  await lab.locator('#period-linear').uncheck()
  await expect(curves).toHaveCount(before)
})

test('story 6: each formula says its source and its stated range, on an error axis of powers of ten', async ({
  lab,
}) => {
  await show(lab, 'view=period&th0=60deg&t=0s')
  await lab.locator('#more-formulas').click()
  const boxes = lab.locator('.formulas input[type=checkbox]')
  // The list is of the module that is loaded after the first drawing.
  await expect(boxes).toHaveCount(15)
  for (let i = 0; i < 15; i++) {
    await boxes.nth(i).focus()
    // A source: a name with a year, a chapter of DLMF, or what everybody knows.
    await expect(lab.locator('.formula-details')).toContainText(/\d{4}|DLMF|Small swings|Bernoulli/)
  }
  await lab.locator('#more-formulas').click()
  await show(lab, 'view=period&th0=60deg&periods=lima-arun,salas-28&t=0s')
  await expect(lab.locator('[data-chart=period-error] path.halo')).not.toHaveCount(0)
  const ticks = await lab.locator('[data-chart=period-error] text.tick[text-anchor=end]').allTextContents()
  expect(ticks.slice(0, 3)).toEqual(['0.00001', '0.0001', '0.001'])
  await lab.locator('[data-chart=period-error] .switches button', { hasText: 'linear' }).click()
  await expect(lab.locator('[data-chart=period-error] text.tick', { hasText: '−60' })).toHaveCount(1)
})

test('story 6: the CSV of a language with a decimal comma reads back to the same numbers', async ({ lab }) => {
  await show(lab, 'view=period&th0=150deg&periods=lima-arun&t=0s')
  const english = await csvOf(lab, 'period-error')
  await show(lab, 'view=period&th0=150deg&periods=lima-arun&lang=es&t=0s')
  const spanish = sheet((await csvOf(lab, 'period-error')).text, ';', ',')
  expect(column(spanish, spanish.header[1] as string)).toEqual(column(english, english.header[1] as string))
  await show(lab, 't=0s')
})
