// Story 20: keyboard alone does stories 1, 2, 6 and 10, 17 in data.spec.ts, 18 in data-period.spec.ts; focus is seen and goes on; what changes is said; a trace is heard.

import type { Page } from '@playwright/test'
import { VIEWS } from '../../src/state'
import { column, csvOf, drawn, expect, opened, show, test } from './lab'

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

test('story 20: the focus is always seen, and Tab comes round in every view', async ({ lab }) => {
  for (const view of [...VIEWS, 'data&from=period', 'handouts&handout=code', 'handouts&handout=embed']) {
    await show(lab, `view=${view}&th0=150deg&t=0s`)
    await lab.evaluate(() => (document.activeElement as HTMLElement | null)?.blur())
    let round = false
    let steps = 0
    const unseen: string[] = []
    for (; steps < 140 && !round; steps++) {
      await lab.keyboard.press('Tab')
      const seen = await lab.evaluate(() => {
        const element = document.activeElement
        if (!element || element === document.body) return null
        const shown = (each: Element): boolean => {
          const { outlineStyle, outlineWidth } = getComputedStyle(each)
          return outlineStyle !== 'none' && Number.parseFloat(outlineWidth) >= 1
        }
        // The handle of a drawing draws its ring itself.
        const own = element.matches('.bob-handle:focus-visible')
        const ring =
          own ||
          shown(element) ||
          [...element.querySelectorAll('*')].some(shown) ||
          (element.parentElement !== null && shown(element.parentElement))
        const box = element.getBoundingClientRect()
        const there =
          box.width > 0 &&
          box.height > 0 &&
          box.bottom > 0 &&
          box.right > 0 &&
          box.left < innerWidth &&
          box.top < innerHeight
        return { name: `${element.tagName} ${element.className} ${element.id}`, good: ring && there }
      })
      if (seen === null) round = steps > 3
      else if (!seen.good) unseen.push(seen.name)
    }
    expect(unseen, view).toEqual([])
    expect(round, `${view}: Tab does not leave the page`).toBe(true)
  }
})

test('story 20: what changes is said once it rests: amplitude, period, kind', async ({ lab }) => {
  await show(lab, 'th0=20deg&L=1m&g=9.81&t=0s')
  const live = lab.locator('#live')
  await expect(live).toContainText('Released at 20°')
  // Every text that it has, from here on.
  await lab.evaluate(() => {
    const said: { text: string; at: number }[] = []
    Object.assign(window, { said })
    new MutationObserver(() =>
      said.push({ text: document.querySelector('#live')?.textContent ?? '', at: performance.now() }),
    ).observe(document.querySelector('#live') as Element, { childList: true, characterData: true, subtree: true })
  })
  await lab.locator('.bob-handle').focus()
  for (let i = 0; i < 10; i++) await lab.keyboard.press('ArrowRight')
  await expect(live).toContainText('Released at 30°')
  await expect(live).toContainText('2.041')
  await lab.locator('#field-velocity0').fill('9')
  await expect(live).toContainText('turns over')
  const said = await lab.evaluate(() => (window as unknown as { said: { text: string; at: number }[] }).said)
  const times = said.filter(({ text }, i) => text !== said[i - 1]?.text).map(({ at }) => at)
  expect(times.length).toBeGreaterThanOrEqual(2)
  // By the page's own clock: never more often than once a second.
  expect(Math.min(...times.slice(1).map((at, i) => at - (times[i] as number)))).toBeGreaterThan(900)
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
