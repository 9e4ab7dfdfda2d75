// Stories 1 and 5: the drawn pendulum is the core's motion at the true time, whatever the frame rate, and its energy stays.

import { load, Pendulum } from 'libration'
import { column, csvOf, drawn, expect, largest, linkOf, opened, radians, show, test } from './lab'

const START = 'th0=150deg&L=1m&g=9.81'
const BOX = { x: 128, y: 127, length: 92, width: 280 }

test.beforeAll(async () => {
  await load()
})

test('story 1: pointer, keys and typing set 150 degrees', async ({ lab }) => {
  const field = lab.locator('#field-theta0')
  const bob = lab.locator('.bob-handle')
  await show(lab, 'th0=20deg&t=0s')
  // By pointer: to where the drawing shows 150 degrees, in steps, and let go there.
  const box = await lab.locator('.bob-drawing').boundingBox()
  const from = await bob.boundingBox()
  if (!box || !from) throw new Error('no drawing')
  const scale = box.width / BOX.width
  await lab.mouse.move(from.x + from.width / 2, from.y + from.height / 2)
  await lab.mouse.down()
  for (const degrees of [60, 100, 149, 150]) {
    const x = BOX.x + BOX.length * Math.sin(radians(degrees))
    const y = BOX.y + BOX.length * Math.cos(radians(degrees))
    await lab.mouse.move(box.x + scale * x, box.y + scale * y)
    await expect(field).toHaveValue(String(degrees))
  }
  await lab.mouse.up()
  await expect(field).toHaveValue('150')
  await expect(lab.locator('#play')).toHaveAttribute('aria-label', 'Pause')
  await lab.locator('#play').click()
  // By keys, with tenths and tens.
  await show(lab, 'th0=139deg&t=0s')
  await bob.focus()
  for (const key of ['PageUp', 'ArrowRight', 'Shift+ArrowRight', 'Shift+ArrowLeft']) await lab.keyboard.press(key)
  await expect(field).toHaveValue('150')
  await expect(bob).toHaveAttribute('aria-valuetext', '150 degrees, release angle')
  // Typed.
  await show(lab, 'th0=20deg&t=0s')
  await field.fill('150.0')
  await expect(lab.locator('#page .sentence')).toContainText('Released at 150°')
  expect(await linkOf(lab)).toContain('th0=150deg')
})

test('story 1: touch sets 150 degrees, on a phone', async ({ browser }) => {
  const phone = await opened(browser, 'th0=20deg&t=0s', {
    viewport: { width: 360, height: 740 },
    hasTouch: true,
    isMobile: true,
  })
  const session = await phone.context().newCDPSession(phone)
  const box = await phone.locator('.bob-drawing').boundingBox()
  if (!box) throw new Error('no drawing')
  const scale = box.width / BOX.width
  const at = (degrees: number) => ({
    x: box.x + scale * (BOX.x + BOX.length * Math.sin(radians(degrees))),
    y: box.y + scale * (BOX.y + BOX.length * Math.cos(radians(degrees))),
  })
  const touch = (type: 'touchStart' | 'touchMove' | 'touchEnd', degrees?: number) =>
    session.send('Input.dispatchTouchEvent', { type, touchPoints: degrees === undefined ? [] : [at(degrees)] })
  await touch('touchStart', 20)
  for (const degrees of [50, 90, 130, 150]) await touch('touchMove', degrees)
  await touch('touchEnd')
  await expect(phone.locator('#field-theta0')).toHaveValue('150')
  await phone.context().close()
})

/** In the page: a clock and frames that only a test moves, between `stopTime` and the end of a drive. */
function frames(): void {
  const real = { now: performance.now.bind(performance), frame: window.requestAnimationFrame.bind(window) }
  let wall: number | null = null
  let waiting: FrameRequestCallback[] = []
  performance.now = () => wall ?? real.now()
  // Every frame waits here, from before `stopTime` too: the page asks for none while one is on its way.
  window.requestAnimationFrame = (act) => {
    waiting.push(act)
    if (waiting.length === 1) real.frame(() => release())
    return 0
  }
  /** Outside of a drive, what waits is drawn by the browser's own frames. */
  function release() {
    const left = waiting
    waiting = []
    wall = null
    for (const act of left) act(real.now())
  }
  Object.assign(window, {
    stopTime: () => {
      wall = 0
    },
    /** Each frame's time in ms, angle as drawn, and where its bob is. */
    drive: (from: number, to: number, rate: number) => {
      const handle = document.querySelector('.bob-handle')
      const out: number[][] = []
      for (let n = Math.max(1, from * rate); n <= to * rate; n++) {
        wall = (1000 * n) / rate
        const now = waiting
        waiting = []
        for (const act of now) act(wall)
        const place = /translate\(([-\d.]+) ([-\d.]+)\)/.exec(handle?.getAttribute('transform') ?? '') ?? []
        out.push([wall, Number(handle?.getAttribute('data-exact') ?? Number.NaN), Number(place[1]), Number(place[2])])
      }
      return out
    },
  })
}

test("story 1: after 600 s at 30, 60 and 144 frames a second the drawn angle is the core's", async ({ browser }) => {
  const context = await browser.newContext({ serviceWorkers: 'block', viewport: { width: 360, height: 740 } })
  const page = await context.newPage()
  await page.addInitScript(frames)
  await page.goto(`${process.env.LAB_ADDRESS}#${START}&curves=&t=0s`)
  await expect(page.locator('.bob-handle')).toBeVisible()
  await drawn(page)
  const core = new Pendulum({ theta0: radians(150), length: 1, gravity: 9.81 })
  for (const rate of [30, 60, 144]) {
    // Every frame of the first second and of the last two; between them the tab sleeps, which must not matter either.
    const all = await page.evaluate((hertz) => {
      const { stopTime, drive } = window as unknown as {
        stopTime: () => void
        drive: (from: number, to: number, rate: number) => number[][]
      }
      stopTime()
      document.querySelector<HTMLElement>('#play')?.click()
      const seen = [...drive(0, 1, hertz), ...drive(299, 300, hertz), ...drive(598, 600, hertz)]
      // Stop, and back to the start for the next rate.
      document.querySelector<HTMLElement>('#play')?.click()
      location.hash = ''
      return seen
    }, rate)
    await show(page, `${START}&curves=&t=0s&speed=1`)
    expect(all.length).toBe(4 * rate + 2)
    expect(all.at(-1)?.[0]).toBe(600_000)
    const theta = core.theta(Float64Array.from(all, ([wall = Number.NaN]) => wall / 1000))
    const off = (place: number, truth: (angle: number) => number) =>
      largest(all.map((each, i) => (each[place] ?? Number.NaN) - truth(theta[i] as number)))
    expect(off(1, (angle) => angle)).toBeLessThan(1e-12)
    // And the bob stands there, to the hundredth of a unit in which it is written.
    expect(off(2, (angle) => BOX.x + BOX.length * Math.sin(angle))).toBeLessThan(0.00501)
    expect(off(3, (angle) => BOX.y + BOX.length * Math.cos(angle))).toBeLessThan(0.00501)
  }
  await context.close()
})

test('story 1: released at 180 degrees it stays, and the page says why', async ({ lab }) => {
  await show(lab, 'th0=90deg&t=0s')
  await lab.locator('#field-theta0').fill('180')
  await expect(lab.locator('#page .sentence')).toHaveText('At rest at 180°: unstable balance. It stays.')
  for (const t of [1, 100, 600, 100_000]) {
    await show(lab, `th0=180deg&t=${t}s`)
    await expect(lab.locator('.bob-handle')).toHaveAttribute('data-exact', String(Math.PI))
  }
  // A millionth of a degree beside it, it falls.
  await show(lab, 'th0=179.999999deg&t=6s')
  await expect(lab.locator('#page .sentence')).not.toContainText('balance')
  expect(Math.abs(Number(await lab.locator('.bob-handle').getAttribute('data-exact')))).toBeLessThan(3)
})

test('story 5: the energy of the exact motion stays, over ten thousand periods and near the top', async ({ lab }) => {
  for (const [degrees, allowed] of [
    [150, 1e-12],
    [179.999, 1e-10],
  ] as const) {
    const { period } = new Pendulum({ theta0: radians(degrees), length: 1, gravity: 9.81 })
    const truth = 100 * Math.sin(radians(degrees) / 2) ** 2
    for (const periods of [0, 1, 100, 9_999]) {
      const t = (periods * period).toFixed(3)
      await show(lab, `th0=${degrees}deg&L=1m&g=9.81&curves=linear,rk4:0.01&energy=parts&t=${t}s`)
      const sum = column(await csvOf(lab, 'energy'), 'sum')
      expect(sum.length).toBe(1201)
      expect(largest(sum.map((value) => value / truth - 1))).toBeLessThan(allowed)
    }
  }
})

test('story 5: the drift of numerical solutions is on the same axis', async ({ lab }) => {
  await show(lab, `${START}&curves=euler:0.01,euler-cromer:0.01,rk4:0.025,linear&span=8s&t=0s`)
  const energy = await csvOf(lab, 'energy')
  expect(energy.header).toEqual(['t, s', 'exact', 'Euler 0.01 s', 'Euler–Cromer 0.01 s', 'RK4 0.025 s'])
  const drift = (name: string) => {
    const values = column(energy, name)
    return largest(values.map((value) => value - (values[0] as number)))
  }
  expect(drift('exact')).toBeLessThan(1e-10)
  expect(drift('Euler 0.01 s')).toBeGreaterThan(10 * drift('Euler–Cromer 0.01 s'))
  expect(drift('Euler–Cromer 0.01 s')).toBeGreaterThan(10 * drift('RK4 0.025 s'))
  expect(drift('RK4 0.025 s')).toBeGreaterThan(1e-9)
  for (const clothes of ['c-exact', 'c-euler', 'c-integrator'])
    await expect(lab.locator(`[data-chart=energy] path.c.${clothes}`).first()).toHaveAttribute('d', /M.*l/)
})
