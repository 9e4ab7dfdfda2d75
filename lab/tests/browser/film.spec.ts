// Story 15, the films: a frame is the core at its instant, one period has no seam, and what cannot be made is said.

import { load, Pendulum } from 'libration'
import { boxAt, boxes, decodedGif, decodedVideo, expectBobs, type Place, place } from './decoded'
import { address, drawn, expect, radians, ready, show, test } from './lab'
import { film, LINK, menuOf, openFilm, SWING } from './saved'

test.beforeAll(async () => {
  await load()
})

test('story 15: frame i of a GIF is the core at t = i/fps, and one period has no seam', async ({ lab }) => {
  const swing = SWING()
  await show(lab, LINK)
  const { bytes, name, facts } = await film(lab, { format: 'GIF', width: 480 })
  expect(name).toBe('pendulum.gif')
  const count = Math.floor(25 * swing.period)
  expect(facts).toContain(`${count} frames of 480 × 402 pixels`)
  expect(facts).toContain('repeats without a seam')
  expect(facts.replaceAll('\u00a0', ' ')).toContain('takes 3.54 s and not 3.5351 s')
  expect(bytes.toString('latin1', 0, 6)).toBe('GIF89a')
  expect(bytes.includes('NETSCAPE2.0')).toBe(true)
  const perSecond = count / swing.period
  const wanted = [0, 1, 7, 22, 30, 44, 61, count - 1]
  const found = await decodedGif(lab, bytes, wanted)
  expect([found.frames, found.width, found.height]).toEqual([count, 480, 402])
  expect(found.delays.reduce((sum, each) => sum + each, 0)).toBe(Math.round(100 * swing.period))
  const places = (shift: number) => wanted.map((i) => place(swing.theta((i + shift) / perSecond), 480, 402))
  expectBobs(found.bobs, places(0))
  // A film that is a frame late is seen to be.
  expect(() => expectBobs(found.bobs, places(1))).toThrow()
})

test('story 15: the frame after a period is the first, to the pixel', async ({ lab }) => {
  const { period } = SWING()
  const { period: turn } = new Pendulum({ theta0: radians(20), velocity0: 7, length: 1, gravity: 9.81 })
  for (const [start, time] of [
    ['th0=150deg', period],
    ['th0=20deg&w0=7', turn],
  ] as const) {
    await show(lab, `${start}&L=1m&g=9.81&span=${2 * time}s&t=0s`)
    // An even number of frames in two periods: the middle one is the first again.
    const rate = [10, 20, 25, 30, 50].find((each) => Math.floor(2 * time * each * (1 + 1e-12)) % 2 === 0) ?? 0
    const count = Math.floor(2 * time * rate * (1 + 1e-12))
    const { bytes } = await film(lab, { format: 'GIF', rate, shows: /0 s to/ })
    const { frames, pixels } = await decodedGif(lab, bytes, [0, count / 2, 1, 1 + count / 2])
    expect(frames).toBe(count)
    expect(pixels[1]).toBe(pixels[0])
    expect(pixels[3]).toBe(pixels[2])
    expect(pixels[2]).not.toBe(pixels[0])
  }
})

test('story 15: an MP4 is avc1 in ftyp isom, and its frames are the core at t = i/fps', async ({ lab }) => {
  const turning = { theta0: radians(20), velocity0: 7, length: 1, gravity: 9.81 }
  for (const [link, pendulum] of [
    ['th0=150deg', SWING()],
    ['th0=20deg&w0=7', new Pendulum(turning)],
  ] as const) {
    await show(lab, `${link}&L=1m&g=9.81&t=0s`)
    const { bytes, name } = await film(lab, { format: 'MP4', width: 480 })
    expect(name).toBe('pendulum.mp4')
    expect(boxes(bytes).map(({ type }) => type)).toEqual(['ftyp', 'moov', 'mdat'])
    const brands = boxAt(bytes, 'ftyp')
    expect(brands.toString('latin1', 0, 4)).toBe('isom')
    expect(brands.toString('latin1', 8)).toContain('avc1')
    const track = boxAt(bytes, 'moov', 'trak', 'mdia', 'minf', 'stbl')
    const kind = boxAt(track, 'stsd')
    expect(kind.toString('latin1', 12, 16)).toBe('avc1')
    const count = Math.floor(25 * pendulum.period)
    expect(boxAt(track, 'stsz').readUInt32BE(8)).toBe(count)
    const perSecond = count / pendulum.period
    const wanted = [0, 3, Math.floor(count / 3), Math.floor(count / 2), count - 1]
    const found = await decodedVideo(
      lab,
      bytes,
      'video/mp4',
      wanted.map((i) => (i + 0.5) / perSecond),
    )
    expect([found.width, found.height]).toEqual([480, 402])
    expect(Math.abs(found.duration - pendulum.period)).toBeLessThan(2e-3)
    expectBobs(
      found.bobs,
      wanted.map((i) => place(pendulum.theta(i / perSecond), 480, 402)),
    )
    // A whole period further it is drawn at the same place.
    const [first, again] = [0, pendulum.period].map((t) => place(pendulum.theta(t), 480, 402)) as [Place, Place]
    expect(Math.hypot(again.x - first.x, again.y - first.y)).toBeLessThan(1e-6)
  }
})

test('story 15: without H.264 the film is WebM, without video a GIF, and the page says so', async ({ browser }) => {
  for (const [refused, format, said] of [
    ['avc1', 'WebM', 'writes no MP4 (H.264): the film is WebM (VP9)'],
    ['', 'GIF', 'No video can be written here: the film is a GIF'],
  ] as const) {
    const context = await browser.newContext({ serviceWorkers: 'block' })
    const page = await context.newPage()
    await page.addInitScript((prefix) => {
      const ask = VideoEncoder.isConfigSupported.bind(VideoEncoder)
      VideoEncoder.isConfigSupported = async (config) =>
        config.codec.startsWith(prefix) ? { config, supported: false } : ask(config)
    }, refused)
    await page.goto(`${address()}#${LINK}`)
    await ready(page)
    const dialog = await openFilm(page)
    await expect(dialog).toContainText(said)
    await expect(dialog.getByRole('button', { name: 'MP4', exact: true })).toHaveCount(0)
    await page.keyboard.press('Escape')
    const { bytes, name } = await film(page, { format, rate: 10 })
    expect(name).toBe(`pendulum.${format.toLowerCase()}`)
    if (format === 'WebM') {
      expect(bytes.readUInt32BE(0)).toBe(0x1a45dfa3)
      const { bobs, width, height } = await decodedVideo(page, bytes, 'video/webm', [0.02])
      expectBobs(bobs, [place(radians(150), width, height)])
    }
    await context.close()
  }
})

test('story 15: a film shows its progress, leaves the page at work, and can be cancelled', async ({ lab }) => {
  await show(lab, `${LINK}&span=30s`)
  const dialog = await openFilm(lab)
  await dialog.getByRole('button', { name: /0 s to 30 s/ }).click()
  await dialog.getByRole('button', { name: 'GIF', exact: true }).click()
  await dialog.getByRole('button', { name: '1080', exact: true }).click()
  await dialog.getByRole('button', { name: '50', exact: true }).click()
  let downloads = 0
  lab.on('download', () => downloads++)
  await dialog.locator('#film-make').click()
  await expect(dialog.locator('#film-state')).toContainText(/Frame [1-9]\d* of 1500/)
  await expect(dialog.locator('progress')).toHaveAttribute('aria-label', 'Progress of the film')
  // The page draws and answers between two frames.
  await drawn(lab)
  await expect(dialog.locator('#film-cancel')).toBeFocused()
  await lab.keyboard.press('Enter')
  await expect(dialog.locator('#film-state')).toContainText('Cancelled. Nothing was saved.')
  await expect(dialog.locator('#film-make')).toBeEnabled()
  expect(downloads).toBe(0)
  await lab.keyboard.press('Escape')
  await expect(lab.locator('.picture')).toHaveCount(0)
})

test('story 15: where there is no film the dialog says why', async ({ lab }) => {
  const separatrix = new Pendulum({ theta0: 0, length: 1, gravity: 9.81 }).separatrixVelocity(0)
  for (const [link, said] of [
    [`th0=0deg&w0=${separatrix}`, 'the period is infinite'],
    ['th0=180deg', 'At rest nothing moves'],
    ['th0=10deg&L=1000m&g=0.001', 'frames, more than 2000'],
    ['th0=10deg&L=0.001m&g=1000', 'too few to be seen moving'],
  ] as const) {
    await show(lab, link.includes('L=') ? `${link}&t=0s` : `${link}&L=1m&g=9.81&t=0s`)
    const dialog = await openFilm(lab)
    await dialog.getByRole('button', { name: /one/ }).click()
    await expect(dialog.getByRole('status').first()).toContainText(said)
    await expect(dialog.locator('#film-make')).toBeDisabled()
    await lab.keyboard.press('Escape')
    await expect(lab.locator('dialog')).toHaveCount(0)
  }
  // What no doubles start is no motion of the command line.
  await show(lab, 'th0=180deg&L=1m&g=9.81&t=0s')
  await menuOf(lab, 'pendulum').click()
  await expect(lab.getByRole('menuitem', { name: /^SVG/ })).toBeVisible()
  await expect(lab.getByRole('menuitem', { name: /CSV/ })).toHaveCount(0)
  await lab.keyboard.press('Escape')
})
