// Story 20: keyboard alone does stories 1, 2, 6 and 10, 17 in data.spec.ts, 18 in data-period.spec.ts; focus is seen and goes on; what changes is said; a trace is heard.

import type { Page } from '@playwright/test'
import { VIEWS } from '../../src/state'
import { column, csvOf, drawn, expect, heldTimers, opened, show, test } from './lab'

/** Goes on by Tab until an element of a selector has the focus. */
async function tabTo(page: Page, selector: string, most = 90): Promise<void> {
  for (let i = 0; i < most; i++) {
    if (await page.evaluate((wanted) => document.activeElement?.matches(wanted) ?? false, selector)) return
    await page.keyboard.press('Tab')
  }
  throw new Error(`Tab does not come to ${selector}`)
}

test('story 20: stories 1, 2, 6 and 10 by keys alone', async ({ browser }) => {
  const page = await opened(browser, 'th0=149deg&L=1m&g=9.8&t=0s')
  // 1: the first Tab is the skip link, which leads to the bob.
  await page.keyboard.press('Tab')
  await expect(page.locator('.skip')).toBeFocused()
  await page.keyboard.press('Enter')
  await expect(page.locator('.bob-handle')).toBeFocused()
  await page.keyboard.press('ArrowRight')
  await expect(page.locator('#page .sentence')).toContainText('Released at 150°')
  await page.keyboard.press('Space')
  await expect(page.locator('#play')).toHaveAttribute('aria-label', 'Pause')
  await page.keyboard.press('Space')
  await expect(page.locator('#play')).toHaveAttribute('aria-label', 'Play')
  // 2: an example from its menu.
  await tabTo(page, '#menu-examples')
  await page.keyboard.press('ArrowDown')
  await expect(page.getByRole('menu')).toBeVisible()
  await page.keyboard.press('ArrowDown')
  await page.keyboard.press('ArrowDown')
  await page.keyboard.press('Enter')
  await expect(page.locator('.messages')).toContainText('Lima, figure 3')
  await expect(page.locator('.row .result').nth(1)).toContainText('2.33')
  // 6: the third view, its table.
  await page.keyboard.press('3')
  await tabTo(page, '[data-plot=period]')
  await page.keyboard.press('t')
  await expect(page.locator('[data-chart=period] table')).toContainText('1.180341')
  await page.keyboard.press('PageUp')
  await expect(page.locator('#page .sentence')).toContainText('100°')
  // 10: the link, and back to where the focus was.
  await page.keyboard.press('s')
  await expect(page.locator('dialog[open]')).toBeVisible()
  await tabTo(page, '#share-link', 8)
  expect(await page.locator('#share-link').inputValue()).toContain('view=period&th0=100deg')
  await page.keyboard.press('Escape')
  await expect(page.locator('dialog')).toHaveCount(0)
  await expect(page.locator('[data-plot=period]')).toBeFocused()
  await page.keyboard.press('?')
  await expect(page.locator('dialog')).toContainText('play, pause')
  await page.keyboard.press('Escape')
  await page.context().close()
})

/** In the page: what has the focus whenever Tab leaves it, and whether that is seen; null where nothing has it. */
function watchFocus(): void {
  const seen: ({ name: string; good: boolean } | null)[] = []
  const shown = (each: Element): boolean => {
    const { outlineStyle, outlineWidth } = getComputedStyle(each)
    return outlineStyle !== 'none' && Number.parseFloat(outlineWidth) >= 1
  }
  const note = () => {
    const element = document.activeElement
    if (!element || element === document.body) return seen.push(null)
    const ring =
      // The handle of a drawing draws its ring itself.
      element.matches('.bob-handle:focus-visible') ||
      shown(element) ||
      [...element.querySelectorAll('*')].some(shown) ||
      (element.parentElement !== null && shown(element.parentElement))
    const { width, height, bottom, right, left, top } = element.getBoundingClientRect()
    const there = width > 0 && height > 0 && bottom > 0 && right > 0 && left < innerWidth && top < innerHeight
    return seen.push({ name: `${element.tagName} ${element.className} ${element.id}`, good: ring && there })
  }
  const heard = (event: KeyboardEvent) => event.key === 'Tab' && note()
  addEventListener('keydown', heard, { capture: true })
  Object.assign(window, { seen, watched: () => removeEventListener('keydown', heard, { capture: true }) })
}

test('story 20: the focus is always seen, and Tab comes round in every view', async ({ lab }) => {
  for (const view of [...VIEWS, 'data&from=period', 'handouts&handout=code', 'handouts&handout=embed']) {
    await show(lab, `view=${view}&th0=150deg&t=0s`)
    // The bar is the same in all of them: Tab begins with it in the first, and behind it in the others.
    await lab.locator(view === 'lab' ? '.skip' : 'main').focus()
    await lab.evaluate(watchFocus)
    type Watched = { seen: ({ name: string; good: boolean } | null)[]; watched: () => void }
    let seen: Watched['seen'] = []
    // Nothing has the focus once it has come round.
    const round = () => seen.indexOf(null)
    for (let steps = 0; steps < 140 && round() < 0; steps += 20) {
      for (let i = 0; i < 20; i++) await lab.keyboard.down('Tab')
      seen = await lab.evaluate(() => (window as unknown as Watched).seen)
    }
    await lab.keyboard.up('Tab')
    await lab.evaluate(() => (window as unknown as Watched).watched())
    expect(round(), `${view}: Tab does not leave the page`).toBeGreaterThan(4)
    // Where it begins is where the test has put it.
    const unseen = seen.slice(1, round()).filter((each) => each !== null && !each.good)
    expect(unseen, view).toEqual([])
  }
})

test('story 20: what changes is said once it rests: amplitude, period, kind', async ({ lab }) => {
  await show(lab, 'th0=20deg&L=1m&g=9.81&t=0s')
  const live = lab.locator('#live')
  await expect(live).toContainText('Released at 20°')
  // The second for which nothing must change is over when the test says so.
  const timers = await heldTimers(lab, 1000)
  // Every text that it has, from here on.
  await lab.evaluate(() => {
    const said: string[] = []
    Object.assign(window, { said })
    new MutationObserver(() => said.push(document.querySelector('#live')?.textContent ?? '')).observe(
      document.querySelector('#live') as Element,
      { childList: true, characterData: true, subtree: true },
    )
  })
  const said = () => lab.evaluate(() => [...new Set((window as unknown as { said: string[] }).said)])
  await lab.locator('.bob-handle').focus()
  for (let i = 0; i < 10; i++) await lab.keyboard.press('ArrowRight')
  await expect(lab.locator('#field-theta0')).toHaveValue('30')
  expect([await said(), await timers.count()]).toEqual([[], 1])
  await timers.fire()
  await expect(live).toContainText('Released at 30°')
  await expect(live).toContainText('2.041')
  await lab.locator('#field-velocity0').fill('9')
  await expect(lab.locator('#page .sentence')).toContainText('turns over')
  expect([(await said()).length, await timers.count()]).toEqual([1, 1])
  await timers.fire()
  await expect(live).toContainText('turns over')
  expect((await said()).length).toBe(2)
  await timers.end()
})

test('story 20: the audio trace of the angle is highest where the angle is', async ({ browser }) => {
  const page = await opened(browser, 'th0=20deg&L=1m&g=9.81&curves=&span=T&t=0s')
  await page.evaluate(() => {
    class Recorded extends OfflineAudioContext {
      constructor() {
        super(2, 8000 * 4.3, 8000)
        Object.assign(window, { recorded: this })
      }
      close() {}
    }
    Object.assign(window, { AudioContext: Recorded })
  })
  await page.locator('[data-chart=angle] [data-tool=sound]').click()
  const pitches = await page.evaluate(async () => {
    const sound = await (window as unknown as { recorded: OfflineAudioContext }).recorded.startRendering()
    const left = sound.getChannelData(0)
    const right = sound.getChannelData(1)
    const both = left.map((each, i) => each + (right[i] ?? 0))
    // Crossings upwards in 80 parts of 50 ms, from 0.05 s on.
    return Array.from({ length: 80 }, (_, part) => {
      let count = 0
      for (let i = 1; i < 400; i++) {
        const at = 400 + part * 400 + i
        if ((both[at - 1] ?? 0) < 0 && (both[at] ?? 0) >= 0) count++
      }
      return count * 20
    })
  })
  const angles = column(await csvOf(page, 'angle'), 'exact')
  const at = (part: number) => angles[Math.round(((part + 0.5) / 80) * (angles.length - 1))] as number
  const high = pitches.filter((_, i) => at(i) > 15)
  const low = pitches.filter((_, i) => at(i) < -15)
  expect(Math.min(...high)).toBeGreaterThan(3 * Math.max(...low))
  expect(pitches.indexOf(Math.min(...pitches))).toBeGreaterThan(30)
  expect(pitches.indexOf(Math.min(...pitches))).toBeLessThan(50)
  await drawn(page)
  await page.context().close()
})

test('with reduced motion it starts paused and says why', async ({ browser }) => {
  const page = await opened(browser, 'th0=150deg', { reducedMotion: 'reduce' })
  await expect(page.locator('.play')).toContainText('paused, as your system asks')
  await expect(page.locator('#play')).toHaveAttribute('aria-label', 'Play')
  await page.context().close()
})
