// Stories 2 and 3: formulas beside the exact motion with Lima's errors, and numerical solutions that go wrong where they do.

import { approx, load, loadSecond, Pendulum } from 'libration'
import { column, csvOf, expect, largest, radians, type Sheet, show, test } from './lab'

test.beforeAll(async () => {
  await load()
  await loadSecond()
})

/** Largest errors of the drawn numbers, in % of the amplitude. */
const errors = (sheet: Sheet): Record<string, number> =>
  Object.fromEntries(sheet.header.slice(1).map((name) => [name, largest(column(sheet, name))]))

// Lima's figures, from a calculation with 30 digits: largest error over one period in % of the amplitude.
const LIMA = [
  { example: 'Lima, figure 2: 60°', harmonic: 0.9413, fourier: { 1: 1.9513, 2: 0.035 } },
  { example: 'Lima, figure 3: 90°', harmonic: 2.3289, fourier: { 2: 0.2269 } },
  { example: 'Lima, figure 4: 157.5°', harmonic: 12.3427, fourier: { 4: 0.3989 } },
]
const MORE = [
  { degrees: 144, harmonic: 8.5981, n: 3, fourier: 0.6069 },
  { degrees: 171, harmonic: 19.7916, n: 6, fourier: 0.2945 },
]

test("story 2: Lima's figures 2 to 4 have Lima's errors", async ({ lab }) => {
  await show(lab, 't=0s')
  for (const { example, harmonic, fourier } of LIMA) {
    await lab.locator('#menu-examples').click()
    await lab.getByRole('menuitem', { name: example }).click()
    await expect(lab.locator('.messages')).toContainText(example)
    const found = errors(await csvOf(lab, 'error'))
    expect(found.harmonic).toBeCloseTo(harmonic, 2)
    await expect(row(lab, 'harmonic')).toContainText(harmonic.toPrecision(3))
    for (const [n, percent] of Object.entries(fourier)) {
      expect(found[`Fourier ${n}`]).toBeCloseTo(percent, 2)
      await expect(row(lab, `fourier:${n}`)).toContainText(percent.toPrecision(3))
    }
  }
  for (const { degrees, harmonic, n, fourier } of MORE) {
    await show(lab, `th0=${degrees}deg&L=1m&g=9.8&curves=harmonic,fourier:${n}&span=T&t=0s`)
    const found = errors(await csvOf(lab, 'error'))
    expect(found.harmonic).toBeCloseTo(harmonic, 2)
    expect(found[`Fourier ${n}`]).toBeCloseTo(fourier, 2)
  }
})

const row = (page: import('@playwright/test').Page, key: string) =>
  page.locator('.row', { has: page.locator(`[id="curve-${key}"]`) }).locator('.result')

test('story 2: a Fourier series without a value is hatched, with the angle from which', async ({ lab }) => {
  await show(lab, 'th0=131.5deg&curves=fourier:1,fourier:2&span=T&t=0s')
  await expect(row(lab, 'fourier:1')).toContainText('%')
  await expect(lab.locator('[data-chart=angle] rect.hatched')).toHaveCount(0)
  await show(lab, 'th0=140deg&curves=fourier:1,fourier:2&span=T&t=0s')
  await expect(row(lab, 'fourier:1')).toHaveText('hatched')
  await expect(row(lab, 'fourier:2')).toContainText('%')
  await expect(lab.locator('[data-chart=angle] rect.hatched').first()).toBeVisible()
  await expect(lab.locator('[data-chart=angle] .plot-note')).toContainText('131.55°')
  const values = column(await csvOf(lab, 'angle'), 'Fourier 1')
  expect(values[0]).toBeNaN()
  expect(values.filter((each) => !Number.isNaN(each)).length).toBeGreaterThan(600)
})

test('story 2: every formula in the plot has the numbers of the core', async ({ lab }) => {
  const core = new Pendulum({ theta0: radians(100), length: 1, gravity: 9.81 })
  const sets = ['linear,harmonic,fourier:3,fourier-theta:2,trigonometric,small-m', 'small-m-bounded,taylor:8']
  const names: Readonly<Record<string, string>> = {
    linear: 'linear',
    harmonic: 'harmonic',
    'Fourier 3': 'fourier:3',
    'series of θ 2': 'fourier-theta:2',
    trigonometric: 'trigonometric',
    'small m': 'small-m',
    'small m, bounded': 'small-m-bounded',
    'Taylor 8': 'taylor:8',
  }
  let compared = 0
  for (const set of sets) {
    await show(lab, `th0=100deg&L=1m&g=9.81&curves=${set}&span=T&t=0s`)
    const angle = await csvOf(lab, 'angle')
    const error = await csvOf(lab, 'error')
    const times = column(angle, 't, s')
    expect(times.length).toBe(1201)
    expect(times.at(-1)).toBeCloseTo(core.period, 12)
    const exact = core.theta(times)
    expect(largest(column(angle, 'exact').map((each, i) => radians(each) - (exact[i] as number)))).toBeLessThan(1e-13)
    for (const name of error.header.slice(1)) {
      const formula = approx.angle(names[name] ?? name).of(core)
      const size = largest(formula.difference(times))
      const off = column(error, name).map(
        (each, i) => (each / 100) * radians(100) - formula.difference(times[i] as number),
      )
      expect(largest(off), name).toBeLessThan(1e-9 * size + 1e-14)
      compared++
    }
  }
  expect(compared).toBe(8)
  // The two forces of Salas 2019 (3), whose module follows the page's first one.
  await show(lab, 'th0=60deg&L=1m&g=9.81&curves=cubic,cubic-quintic&span=T&t=0s')
  await expect(row(lab, 'cubic')).toContainText('%')
  await expect(row(lab, 'cubic-quintic')).toContainText('%')
  const found = errors(await csvOf(lab, 'error'))
  expect(found['cubic-quintic']).toBeLessThan(found.cubic as number)
})

test("story 3: at 3 rad SciPy's RK45 goes over the top at 9.47 s; RK4 and the exact motion do not", async ({ lab }) => {
  await show(lab, 't=0s')
  await lab.locator('#menu-examples').click()
  await lab.getByRole('menuitem', { name: 'Horsley' }).click()
  await expect(lab.locator('[data-chart=angle] .label.alarm')).toHaveText('RK45 over the top at 9.47 s')
  await expect(lab.locator('#live')).toContainText('RK45 over the top at 9.47 s')
  await expect(lab.locator('.row', { has: lab.locator('[id="curve-rk45"]') }).locator('small')).toContainText(
    'over the top at 9.47 s',
  )
  const angle = await csvOf(lab, 'angle')
  const times = column(angle, 't, s')
  const first = (name: string) => times[column(angle, name).findIndex((each) => Math.abs(each) > 180)]
  expect(first('RK45')).toBeGreaterThan(9.4)
  expect(first('RK45')).toBeLessThan(9.6)
  expect(largest(column(angle, 'exact'))).toBeLessThanOrEqual((3 * 180) / Math.PI + 1e-10)
  expect(largest(column(angle, 'RK4 0.025 s'))).toBeLessThan(173)
  // Its energy is then above that of the top, and drawn so; that of RK4 is not.
  const energy = await csvOf(lab, 'energy')
  expect(largest(column(energy, 'RK45'))).toBeGreaterThan(100)
  expect(largest(column(energy, 'RK4 0.025 s'))).toBeLessThan(100)
  await expect(lab.locator('[data-chart=energy] .label', { hasText: 'the top' })).toBeVisible()
  await expect(lab.locator('[data-chart=energy] path.level')).toHaveCount(1)
})

test('story 3: errors of Euler, Euler–Cromer and RK4 fall with orders 1, 1 and 4', async ({ lab }) => {
  const steps = { euler: 0.0005, 'euler-cromer': 0.0005, rk4: 0.01 }
  const names = { euler: 'Euler', 'euler-cromer': 'Euler–Cromer', rk4: 'RK4' }
  const curves = Object.entries(steps).flatMap(([name, step]) => [`${name}:${2 * step}`, `${name}:${step}`])
  await show(lab, `th0=60deg&L=1m&g=9.81&curves=${curves.join(',')}&span=2s&unit=degrees&t=0s`)
  const sheet = await csvOf(lab, 'error')
  const slope = (name: keyof typeof steps) => {
    const [coarse, fine] = [2 * steps[name], steps[name]].map((step) =>
      largest(column(sheet, `${names[name]} ${step} s`)),
    )
    return Math.log2((coarse as number) / (fine as number))
  }
  expect(Math.abs(slope('euler') - 1)).toBeLessThan(0.1)
  expect(Math.abs(slope('euler-cromer') - 1)).toBeLessThan(0.1)
  expect(Math.abs(slope('rk4') - 4)).toBeLessThan(0.1)
})

test('story 3: the errors against the step are lines of slope 1, 1, 2 and 4', async ({ lab }) => {
  await show(lab, 'th0=150deg&L=1m&g=9.81&curves=linear&t=0s')
  // The way there stands beside the curves that go step by step.
  await expect(lab.locator('#convergence')).toHaveCount(0)
  await show(lab, 'th0=150deg&L=1m&g=9.81&curves=rk4:0.025&t=0s')
  await lab.locator('#convergence').click()
  const sheet = await csvOf(lab, 'convergence')
  expect(sheet.header).toEqual(['step, s', 'Euler', 'Euler–Cromer', 'Verlet', 'RK4'])
  const steps = column(sheet, 'step, s')
  const orders = { Euler: 1, 'Euler–Cromer': 1, Verlet: 2, RK4: 4 }
  for (const [name, order] of Object.entries(orders)) {
    const errors = column(sheet, name)
    // Of RK4 the last ones are rounding.
    const at = name === 'RK4' ? 5 : steps.length - 2
    const slope =
      Math.log((errors[at] as number) / (errors[at + 1] as number)) /
      Math.log((steps[at] as number) / (steps[at + 1] as number))
    expect(Math.abs(slope - order), name).toBeLessThan(0.1)
  }
  await expect(lab.locator('dialog')).toContainText('RK4 4.00 (4)')
  await expect(lab.locator('dialog path.c')).toHaveCount(4)
  await lab.keyboard.press('Escape')
  await expect(lab.locator('dialog')).toHaveCount(0)
})
