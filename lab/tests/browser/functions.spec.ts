// Story 7: sn, cn and dn as lengths in an ellipse that moves with the pendulum and the graph.

import { elliptic, load, loadSecond, Pendulum } from 'libration'
import { column, csvOf, drawn, expect, largest, radians, show, test } from './lab'

test.beforeAll(async () => {
  await load()
  await loadSecond()
})

const number = async (page: import('@playwright/test').Page, name: string): Promise<number> =>
  Number(await page.locator(`[data-number=${name}]`).getAttribute('data-exact'))

test('story 7: the lengths of the ellipse are sn, cn, dn, and the chord is its x', async ({ lab }) => {
  for (const [degrees, t] of [
    [150, 0.4],
    [150, 1.7],
    [90, 2.2],
    [20, 13.1],
    [-120, 0.9],
    [179, 3.3],
  ] as const) {
    await show(lab, `view=functions&th0=${degrees}deg&L=0.7m&g=9.81&t=${t}s`)
    const core = new Pendulum({ theta0: radians(degrees), length: 0.7, gravity: 9.81 })
    const turned = degrees < 0 ? -core.period / 2 : 0
    const { sn, cn, dn } = elliptic.jacobi(core.omega0 * (t - turned), { mc: core.energyRatioC })
    expect(Math.abs((await number(lab, 'sn')) - sn)).toBeLessThan(1e-12)
    expect(Math.abs((await number(lab, 'cn')) - cn)).toBeLessThan(1e-12)
    expect(Math.abs((await number(lab, 'dn')) - dn)).toBeLessThan(1e-12)
    expect(Math.abs(await number(lab, 'rest'))).toBeLessThan(1e-12 * 0.7)
    // The chord over its longest, from the angle itself.
    expect(Math.abs((await number(lab, 'chord')) - Math.sin(core.theta(t) / 2))).toBeLessThan(1e-12)
    expect(Math.abs((await number(lab, 'kx')) - Math.sqrt(core.energyRatio) * (cn / dn))).toBeLessThan(1e-12)
    // In words: the three numbers as the picture has them.
    const words = await lab.locator('.ellipse-figure figcaption').textContent()
    for (const value of [sn, cn, dn]) expect(words).toContain(value.toFixed(4).replace('-', '−'))
  }
})

test('story 7: with m = 0 the ellipse is a circle and cn the cosine', async ({ lab }) => {
  await show(lab, 'view=functions&th0=90deg&L=1m&g=9.81&t=0.3s')
  const slider = lab.getByRole('slider', { name: 'Parameter' })
  await slider.focus()
  await lab.keyboard.press('Home')
  await drawn(lab)
  await expect(lab.locator('#page .sentence')).toContainText('circle')
  const sheet = await csvOf(lab, 'functions')
  const u = column(sheet, 'u')
  expect(u.length).toBeGreaterThan(400)
  expect(largest(column(sheet, 'cn').map((each, i) => each - Math.cos(u[i] as number)))).toBeLessThan(1e-12)
  expect(largest(column(sheet, 'sn').map((each, i) => each - Math.sin(u[i] as number)))).toBeLessThan(1e-12)
  expect(largest(column(sheet, 'dn').map((each) => each - 1))).toBeLessThan(1e-15)
})

test('story 7: pendulum, ellipse and graph move together', async ({ lab }) => {
  await show(lab, 'view=functions&th0=150deg&L=1m&g=9.81&t=0s')
  const places = async () =>
    lab.evaluate(() =>
      ['.ellipse-handle', '.chord-handle']
        .map((name) => document.querySelector(name)?.getAttribute('transform'))
        .concat(document.querySelector('[data-chart=functions] .now-line')?.getAttribute('d')),
    )
  const before = await places()
  await lab.locator('[data-plot=functions]').focus()
  await lab.keyboard.press('PageUp')
  await drawn(lab)
  const after = await places()
  expect(before.every((each, i) => each && after[i] && each !== after[i])).toBe(true)
  // The other way: the point of the ellipse moves the time.
  await lab.locator('.ellipse-handle').focus()
  await lab.keyboard.press('PageUp')
  await drawn(lab)
  const last = await places()
  expect(last.every((each, i) => each !== after[i])).toBe(true)
  const graph = await csvOf(lab, 'functions')
  const core = elliptic.jacobi(column(graph, 'u'), { m: Math.sin(radians(75)) ** 2 })
  for (const name of ['sn', 'cn', 'dn'] as const)
    expect(largest(column(graph, name).map((each, i) => each - (core[name][i] as number)))).toBeLessThan(1e-12)
})
