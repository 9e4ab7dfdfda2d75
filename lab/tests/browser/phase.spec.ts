// Story 4: the phase portrait. A click is the start, its orbit goes through it, the separatrix parts swings from turns.

import { load, Pendulum } from 'libration'
import { column, csvOf, expect, largest, linkOf, radians, show, test } from './lab'

const OMEGA = Math.sqrt(9.81)

test.beforeAll(async () => {
  await load()
})

test('story 4: a click is the start, and its orbit goes through the point', async ({ lab }) => {
  await show(lab, 'view=phase&th0=150deg&orbits=&t=0s')
  const plot = lab.locator('[data-plot=phase]')
  for (const [right, down, kind] of [
    [0.7, 0.4, 'libration'],
    [0.25, 0.06, 'rotation'],
    [0.4, 0.93, 'rotation'],
  ] as const) {
    const box = await plot.boundingBox()
    if (!box) throw new Error('no plot')
    const at = { x: Math.round(right * box.width), y: Math.round(down * box.height) }
    await plot.click({ position: at })
    const clicked = { x: at.x, y: at.y }
    await expect(lab.locator('.orbit-row.chosen small')).toContainText(kind)
    // The nearest piece of the drawn curve, in pixels.
    const near = () =>
      lab.locator('[data-chart=phase] path.c.c-exact').evaluateAll(
        (paths, { x, y }) =>
          Math.min(
            ...paths.map((path) => {
              const curve = path as unknown as SVGPathElement
              const length = curve.getTotalLength()
              let least = Number.POSITIVE_INFINITY
              for (let s = 0; s <= length; s += 1) {
                const point = curve.getPointAtLength(s)
                least = Math.min(least, Math.hypot(point.x / 10 - x, point.y / 10 - y))
              }
              return least
            }),
          ),
        clicked,
      )
    await expect.poll(near).toBeLessThan(1)
    // The state is the point: of the axes' ends, which the frame shows as its ticks.
    const link = await linkOf(lab)
    const angle = Number(/th0=([-\d.]+)deg/.exec(link)?.[1])
    expect(Math.abs(angle - (360 * at.x) / box.width + 180)).toBeLessThan(360 / box.width)
    // It plays from there.
    const play = lab.locator('#play')
    await expect(play).toHaveAttribute('aria-label', 'Pause')
    await play.click()
    await expect(play).toHaveAttribute('aria-label', 'Play')
  }
})

test('story 4: the separatrix is 2ω cos(θ/2), and the start on it has no period', async ({ lab }) => {
  await show(lab, `view=phase&th0=0deg&w0=${2 * OMEGA}&L=1m&g=9.81&orbits=60deg,0deg;7.5&t=0s`)
  await expect(lab.locator('#period-value')).toHaveText('infinite')
  await expect(lab.locator('[data-orbit=A] small')).toContainText('separatrix')
  await expect(lab.locator('[data-orbit=A] .result')).toHaveText('infinite')
  await expect(lab.locator('[data-orbit=B] small')).toContainText('libration')
  await expect(lab.locator('[data-orbit=C] small')).toContainText('rotation')
  await expect(lab.locator('#page .sentence')).toContainText('never arrives')
  const sheet = await csvOf(lab, 'phase')
  const angles = column(sheet, 'θ, °').map(radians)
  expect(angles.length).toBe(361)
  const separatrix = column(sheet, 'separatrix')
  expect(
    largest(separatrix.map((each, i) => each - 2 * OMEGA * Math.abs(Math.cos((angles[i] as number) / 2)))),
  ).toBeLessThan(1e-12)
  // Energy of C, from its start: half its velocity squared.
  const c = column(sheet, 'C')
  const truth = angles.map((angle) => Math.sqrt(7.5 ** 2 - 2 * 9.81 * (1 - Math.cos(angle))))
  expect(largest(c.map((each, i) => each - (truth[i] as number)))).toBeLessThan(1e-12)
  const b = column(sheet, 'B')
  expect(b.filter((each) => !Number.isNaN(each)).length).toBe(121)
})

test("story 4: a rotation is counted on: Salas' example is at 5.1116 rad at 2.1 s", async ({ lab }) => {
  await show(lab, 't=0s')
  await lab.locator('#menu-examples').click()
  await lab.getByRole('menuitem', { name: 'Salas' }).click()
  await lab.locator('[data-view=phase]').click()
  await expect(lab.locator('[data-chart=orbit-angle] .reading-line')).toContainText('5.1116')
  await expect(lab.locator('.bob-handle')).toHaveAttribute('data-exact', /^5\.1116/)
  await show(lab, 'view=phase&th0=0deg&w0=7.5&L=1m&g=9.81&orbits=&t=20s')
  const core = new Pendulum({ theta0: 0, velocity0: 7.5, length: 1, gravity: 9.81 })
  const drawn = Number(await lab.locator('.bob-handle').getAttribute('data-exact'))
  expect(Math.abs(drawn - core.theta(20))).toBeLessThan(1e-12)
  expect(drawn).toBeGreaterThan(30 * Math.PI)
  const sheet = await csvOf(lab, 'orbit-angle')
  const values = column(sheet, 'A')
  expect(values.every((each, i) => i === 0 || each > (values[i - 1] as number))).toBe(true)
})
