// Friction: what becomes of a motion is said in the core's numbers; a driven pendulum has its section, computed while the page works.

import { DampedPendulum, load, loadMotions } from 'libration'
import { column, csvOf, drawn, expect, heldTimers, linkOf, radians, show, test } from './lab'

test.beforeAll(async () => {
  await load()
  await loadMotions()
})

const WEAK = 'view=friction&th0=60deg&L=1m&g=9.81&linear=0.03&until=60s&t=0s'

test('friction takes half of the energy at the time it says, and the charts are the core’s motion', async ({ lab }) => {
  await show(lab, WEAK)
  await expect(lab.locator('#page .sentence')).toHaveText('It loses half its energy in 12.0 s.')
  const half = Number.parseFloat((await lab.locator('#friction-half').textContent()) ?? '')
  const damped = new DampedPendulum({ theta0: radians(60), length: 1, gravity: 9.81, friction: { linear: 0.03 } })
  expect(Math.abs(damped.energy(half) / damped.energy(0) - 0.5)).toBeLessThan(1e-3)
  const sheet = await csvOf(lab, 'friction-angle')
  const [t, theta, energy] = [column(sheet, 't, s'), column(sheet, 'θ, with friction'), column(sheet, 'Energy, %')]
  for (let i = 0; i < t.length; i += 97) {
    const at = damped.motion(t[i] as number)
    expect(Math.abs(radians(theta[i] as number) - at.theta)).toBeLessThan(1e-14)
    expect(Math.abs((energy[i] as number) / 100 - damped.energy(t[i] as number) / (2 * 9.81))).toBeLessThan(1e-14)
  }
  // Two lines join the turning points, and a dashed one is without friction.
  await expect(lab.locator('[data-chart=friction-angle] .c-envelope')).toHaveCount(2)
  await expect(lab.locator('[data-chart=friction-angle] .c-free')).toHaveCount(1)
  // The averaged law follows, 24 points above and below.
  const dots = lab.locator('[data-chart=friction-angle] .averaged-dots').first()
  await expect.poll(async () => (await dots.getAttribute('d'))?.split('M').length).toBe(25)
})

test('friction: dry friction holds the pendulum, and the rest is hatched', async ({ lab }) => {
  await show(lab, 'view=friction&th0=40deg&linear=0&dry=0.3&until=30s&t=0s')
  const dry = new DampedPendulum({ theta0: radians(40), length: 1, gravity: 9.81, friction: { dry: 0.3 } })
  const [rest] = dry.rests(0, 30)
  const angle = ((dry.motion(30).theta * 180) / Math.PI).toFixed(1).replace('-', '−')
  await expect(lab.locator('#page .sentence')).toHaveText(
    `It comes to rest at ${angle}° after ${rest?.[0].toPrecision(3)} s: dry friction holds it.`,
  )
  await expect(lab.locator('#friction-rest')).toHaveText(`${rest?.[0].toFixed(2)} s`)
  await expect(lab.locator('[data-chart=friction-angle] .hatched')).toHaveCount(1)
  await expect(lab.locator('[data-chart=friction-angle] .plot-note')).toContainText('holds it')
})

test('friction by its examples: over the top, steady rotation, undone by one line', async ({ lab }) => {
  await show(lab, WEAK)
  const choose = async (name: string) => {
    await lab.locator('#menu-frictions').click()
    await lab.getByRole('menuitem', { name }).click()
    await drawn(lab)
  }
  await choose('Thrown over the top')
  await expect(lab.locator('#page .sentence')).toContainText('turns over 3 times, then swings')
  await expect(lab.locator('#friction-turns')).toHaveText('3')
  await choose('Josephson')
  await expect(lab.locator('#page .sentence')).toContainText('round and round')
  await lab.locator('.message').getByRole('button', { name: 'Undo' }).click()
  await expect(lab.locator('#page .sentence')).toContainText('turns over 3 times')
  await show(lab, 'view=friction&linear=0&t=0s')
  await expect(lab.locator('#page .sentence')).toContainText('exact pendulum')
})

const DRIVEN = 'view=friction&th0=0deg&L=9.81m&g=9.81&linear=0.25&until=60s&t=0s'

test('friction: a driven pendulum repeats, or fills its section with 2000 points', async ({ lab }) => {
  await show(lab, `${DRIVEN}&drive=0.9&omega=0.6666666666666666`)
  const sentence = lab.locator('#page .sentence')
  await expect(sentence).toContainText('repeat every period of the drive, 9.425 s')
  await expect(lab.locator('#friction-repeats')).toHaveText('one period of the drive')
  await show(lab, `${DRIVEN}&drive=1.07&omega=0.6666666666666666`)
  await expect(sentence).toContainText('repeat every 2 periods')
  await show(lab, `${DRIVEN}&drive=1.5&omega=0.6666666666666666`)
  await expect(sentence).toContainText('does not repeat')
  await expect(lab.locator('[data-chart=friction-section] .section-progress')).toHaveText('2000 of 2000 points')
  const sheet = await csvOf(lab, 'friction-section')
  expect(column(sheet, 'n').length).toBe(2000)
  const angles = column(sheet, 'θ, °')
  expect(new Set(Array.from(angles, (angle) => angle.toFixed(0))).size).toBeGreaterThan(150)
  expect(angles.every((angle) => Math.abs(angle) <= 180)).toBe(true)
})

test('friction: the next change ends a section that is being computed', async ({ lab }) => {
  await show(lab, `${DRIVEN}&drive=1.5&omega=0.6666666666666666`)
  await lab.locator('#field-drive').fill('0.9')
  await expect(lab.locator('#page .sentence')).toContainText('repeat every period')
  await lab.locator('#field-drive').fill('0')
  await expect(lab.locator('[data-chart=friction-section]')).toHaveCount(0)
  await expect(lab.locator('#page .sentence')).not.toContainText('Driven')
})

test('friction: while a fast motion is computed the page answers, says how far it is, and lets it be ended', async ({
  lab,
}) => {
  const fast = 'view=friction&th0=150deg&L=0.001m&g=1000&linear=0.001&until=600s&t=0s&lang=en'
  // A slice of the work is a timer of 0 ms: here they are begun by the test.
  const slices = await heldTimers(lab, 0)
  await show(lab, fast)
  const progress = lab.locator('.section-progress progress')
  const part = () => progress.evaluate((element: HTMLProgressElement) => element.position)
  await expect(lab.locator('#page .sentence')).toContainText('being computed')
  expect(await part()).toBe(0)
  await slices.fire()
  await expect.poll(part).toBeGreaterThan(0)
  const before = await part()
  expect(before).toBeLessThan(1)
  // Between two slices the page answers, and the next one waits.
  await lab.locator('#field-until').focus()
  await lab.keyboard.press('Home')
  expect(await slices.count()).toBe(1)
  await slices.fire()
  await expect.poll(part).toBeGreaterThan(before)
  // What is there is shown, and how far it goes.
  await lab.locator('#friction-end').click()
  await expect(lab.locator('[data-chart=friction-angle] .plot-drawing')).toBeVisible()
  await expect(lab.locator('[data-chart=friction-angle] .plot-note')).toContainText('Computed up to')
  // A change of a value ends it too.
  await show(lab, fast.replace('0.001&until', '0.002&until'))
  await expect(progress).toBeVisible()
  await lab.locator('#field-length').fill('1000')
  await expect(progress).toHaveCount(0)
  await expect(lab.locator('#page .sentence')).toContainText('energy')
  await slices.end()
  await show(lab, 'view=lab&t=0s')
})

test('friction stands in the link, and bad values are named', async ({ lab }) => {
  await show(lab, 'view=friction&linear=0.125&quadratic=0.25&dry=0.5&torque=-0.75&drive=1.5&omega=3&until=45s&t=0s')
  const link = await linkOf(lab)
  expect(link).toContain('linear=0.125&quadratic=0.25&dry=0.5&torque=-0.75&drive=1.5&omega=3&until=45s')
  await show(lab, 'view=friction&linear=-1&dry=sand&until=1e9s&t=0s')
  for (const said of ['linear=-1', '0 1/s to 100 1/s', 'dry=sand', 'not a number', 'until=1e9s', '1 s to 600 s'])
    await expect(lab.locator('.message')).toContainText(said)
  await lab.locator('#field-dry').fill('-3')
  await expect(lab.locator('#field-dry-fault')).toContainText('outside 0 rad/s² to 1000 rad/s²')
  await lab.locator('#field-linear').fill('0.07 1/s')
  await lab.locator('#field-linear').blur()
  await expect(lab.locator('#field-linear')).toHaveValue('0.07')
  await show(lab, 'view=friction&t=0s')
})
