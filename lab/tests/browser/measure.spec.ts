// Measures the page on this machine and prints it: what is loaded first, until when, and the script of a frame of a drag; how long the
// fit of a long record takes, and for how long the page does not answer meanwhile.
// `npm run measure`; not part of the tests, and asserts no time.

import { readFileSync } from 'node:fs'
import { cpus } from 'node:os'
import { basename, join } from 'node:path'
import { gzipSync } from 'node:zlib'
import { load, loadMotions } from 'libration'
import { longRecord } from '../long-record'
import { give, watched } from './data'
import { address, expect, ready, test } from './lab'
import { DIST } from './server'

const LOADS = 9
const FRAMES = 200
/** Six curves beside the exact motion; a window has 1,201 samples, while a control is held too. */
const LINK = 'th0=150deg&L=1m&g=9.81&curves=linear,harmonic,fourier:4,trigonometric,taylor:8,rk4:0.01&t=0s'

const part = (values: readonly number[], at: number): number =>
  [...values].sort((a, b) => a - b)[Math.min(values.length - 1, Math.floor(at * values.length))] ?? Number.NaN

test('measure', async ({ browser }) => {
  const times: number[] = []
  let bytes = 0
  for (let i = 0; i < LOADS; i++) {
    const context = await browser.newContext({ serviceWorkers: 'block' })
    const page = await context.newPage()
    await page.addInitScript(() => {
      new MutationObserver((_, observer) => {
        if (!document.querySelector('main .plot-drawing')) return
        observer.disconnect()
        performance.mark('works')
      }).observe(document, { childList: true, subtree: true })
    })
    await page.goto(`${address()}#${LINK}`)
    await ready(page)
    const { works, names } = await page.evaluate(() => {
      const works = performance.getEntriesByName('works')[0]?.startTime ?? Number.NaN
      const before = performance.getEntriesByType('resource').filter(({ startTime }) => startTime < works)
      return { works, names: before.map(({ name }) => name.replace(/[?#].*/, '')) }
    })
    times.push(works)
    const files = [
      'index.html',
      ...names.filter((name) => !/later-|libration-second/.test(name)).map((name) => `assets/${basename(name)}`),
    ]
    bytes = files.reduce((sum, name) => {
      const file = readFileSync(join(DIST, name))
      return sum + (name.endsWith('.woff2') ? file.length : gzipSync(file, { level: 9 }).length)
    }, 0)
    await context.close()
  }

  const page = await browser.newPage()
  await page.addInitScript(() => {
    const frames: number[] = []
    Object.assign(window, { frames })
    const ask = window.requestAnimationFrame.bind(window)
    window.requestAnimationFrame = (work) =>
      ask((now) => {
        const before = performance.now()
        work(now)
        frames.push(performance.now() - before)
      })
  })
  await page.goto(`${address()}#${LINK}`)
  await ready(page)
  const box = await page.locator('.bob-drawing').boundingBox()
  const bob = await page.locator('.bob-handle').boundingBox()
  if (!box || !bob) throw new Error('no drawing')
  await page.mouse.move(bob.x + bob.width / 2, bob.y + bob.height / 2)
  await page.mouse.down()
  await page.evaluate(() => (window as unknown as { frames: number[] }).frames.splice(0))
  // The time of the processor as well, of all script between two frames: a busy machine leaves it nearly as it is.
  const session = await page.context().newCDPSession(page)
  await session.send('Performance.enable', { timeDomain: 'threadTicks' })
  const script = async () => {
    const { metrics } = await session.send('Performance.getMetrics')
    return 1000 * (metrics.find(({ name }) => name === 'ScriptDuration')?.value ?? Number.NaN)
  }
  const processor: number[] = []
  let before = await script()
  for (let i = 0; i < FRAMES; i++) {
    const angle = 1.6 + 0.9 * Math.sin(i / 9)
    await page.mouse.move(
      box.x + (box.width * (128 + 92 * Math.sin(angle))) / 280,
      box.y + (box.width * (127 + 92 * Math.cos(angle))) / 280,
    )
    await page.evaluate(() => new Promise((done) => requestAnimationFrame(done)))
    const after = await script()
    processor.push(after - before)
    before = after
  }
  // Frames that only waited are not frames of the drag.
  const frames = await page.evaluate(() =>
    (window as unknown as { frames: number[] }).frames.filter((each) => each > 0.3),
  )
  await page.mouse.up()
  expect(frames.length).toBeGreaterThan(FRAMES / 2)
  const ms = (value: number) => `${value.toFixed(1)} ms`
  console.log(`first load ${bytes} bytes gzipped`)
  console.log(
    `works after ${ms(part(times, 0.5))} (median of ${LOADS}, ${ms(Math.min(...times))} to ${ms(Math.max(...times))})`,
  )
  console.log(
    `script of a frame of a drag, six curves: median ${ms(part(frames, 0.5))}, 95 % ${ms(part(frames, 0.95))}, ${frames.length} frames`,
  )
  console.log(`of the processor for it: median ${ms(part(processor, 0.5))}, 95 % ${ms(part(processor, 0.95))}`)
  await page.close()
})

const FITS = 3

test('measure: the fit of 20,000 samples', async ({ browser }) => {
  await load()
  await loadMotions()
  const text = longRecord()
  for (let i = 0; i < FITS; i++) {
    const { page, asked } = await watched(browser)
    const session = await page.context().newCDPSession(page)
    await session.send('Performance.enable', { timeDomain: 'threadTicks' })
    await page.evaluate(() => {
      const seen = { begun: 0, ended: 0, gap: 0 }
      Object.assign(window, { seen })
      let before = 0
      const look = (now: number) => {
        const working = document.querySelector('#data-cancel') !== null
        if (working && seen.begun === 0) seen.begun = now
        if (!working && seen.begun > 0 && seen.ended === 0) seen.ended = now
        if (seen.begun > 0 && seen.ended === 0 && before > 0) seen.gap = Math.max(seen.gap, now - before)
        before = now
        requestAnimationFrame(look)
      }
      requestAnimationFrame(look)
    })
    await give(page, 'long.csv', text)
    await expect(page.locator('#data-omega0')).toBeVisible({ timeout: 200_000 })
    const { begun, ended, gap } = await page.evaluate(
      () => (window as unknown as { seen: { begun: number; ended: number; gap: number } }).seen,
    )
    const modules = asked.filter((each) => each.endsWith('.wasm')).map((each) => basename(each).replace(/-[^-]*$/, ''))
    console.log(
      `fit of 20,000 samples: ${((ended - begun) / 1000).toFixed(2)} s, longest frame of the page ${gap.toFixed(0)} ms, ${modules.join(' and ')} loaded; ${cpus()[0]?.model}`,
    )
    await page.context().close()
  }
})
