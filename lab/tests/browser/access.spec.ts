// Accessibility and layout: axe on every view, language and theme; the tree a screen reader has; sizes from phone to projector.

import type { Page } from '@playwright/test'
import { LANGUAGES, VIEWS } from '../../src/state'
import { violations } from './axe'
import { csvOf, drawn, expect, opened, show, test } from './lab'
import { layoutFaults, lengthen, SCREENS, shorten } from './layout'

/** As the link says them: a view, and which part of it. */
const PLACES = [...VIEWS, 'handouts&handout=code', 'handouts&handout=embed'] as const
const LINK = 'th0=150deg&L=1m&g=9.81&t=1.3s'

/** Parts of a page of others. */
const PARTS = [
  'show=phase&lock=th0,L,g',
  'show=lab&lock=th0,w0,L,g,curves',
  'show=pendulum,motion,play',
  'hide=g',
  'hide=g&show=portrait,values',
] as const

test('axe finds nothing in the words of any view and language', async ({ lab }) => {
  for (const view of PLACES) {
    for (const language of LANGUAGES) {
      await show(lab, `view=${view}&${LINK}&lang=${language}&theme=light`)
      await expect(lab.locator('html')).toHaveAttribute('lang', language)
      expect(await violations(lab, 'words'), `${view} ${language}`).toEqual([])
    }
  }
  for (const part of PARTS) {
    await show(lab, `embed=1&${part}&${LINK}&theme=light`)
    expect(await violations(lab, 'words'), part).toEqual([])
  }
  await show(lab, LINK)
})

// With the words of another language for each view.
for (const theme of ['light', 'dark'] as const) {
  test(`axe finds nothing in the colours of any view, ${theme}`, async ({ lab }) => {
    for (const [i, view] of PLACES.entries()) {
      const language = LANGUAGES[(i + (theme === 'dark' ? 1 : 0)) % LANGUAGES.length]
      await show(lab, `view=${view}&${LINK}&lang=${language}&theme=${theme}`)
      expect(await violations(lab, 'colours'), `${view} ${language} ${theme}`).toEqual([])
    }
    for (const part of PARTS) {
      await show(lab, `embed=1&${part}&${LINK}&theme=${theme}`)
      expect(await violations(lab, 'colours'), `${part} ${theme}`).toEqual([])
    }
    await show(lab, LINK)
  })
}

test('axe sees what is wrong, with all rules and with that of the colours', async ({ lab }) => {
  await show(lab, LINK)
  await lab.evaluate(() => {
    const spoiled = document.createElement('p')
    spoiled.id = 'spoiled'
    spoiled.innerHTML = '<span style="color:#ddd;background:#fff">pale</span><button></button>'
    document.querySelector('main')?.append(spoiled)
  })
  const colours = ['color-contrast: #spoiled > span']
  expect((await violations(lab)).sort()).toEqual(['button-name: #spoiled > button', ...colours])
  expect(await violations(lab, 'colours')).toEqual(colours)
  expect(await violations(lab, 'words')).toEqual(['button-name: #spoiled > button'])
  await lab.evaluate(() => document.getElementById('spoiled')?.remove())
})

test('axe finds nothing with tables, messages, menus and dialogs open', async ({ lab }) => {
  await show(lab, `${LINK}&shape=round`)
  await lab.locator('[data-chart=angle] [data-tool=table]').click()
  await lab.locator('#field-theta0').fill('200')
  await lab.locator('#menu-add').click()
  await expect(lab.getByRole('menu')).toBeVisible()
  expect(await violations(lab)).toEqual([])
  await lab.keyboard.press('Escape')
  await lab.locator('#menu-save-angle').click()
  await expect(lab.getByRole('menu')).toBeVisible()
  expect(await violations(lab)).toEqual([])
  await lab.locator('#menu-save-pendulum').click()
  await lab.getByRole('menuitem', { name: /^Film/ }).click()
  await expect(lab.locator('#film-make')).toBeVisible()
  expect(await violations(lab)).toEqual([])
  await lab.keyboard.press('Escape')
  await lab.locator('[data-chart=angle] [data-tool=table]').click()
  for (const key of ['s', '?']) {
    await lab.locator('.bob-handle').focus()
    await lab.keyboard.press(key)
    await expect(lab.locator('dialog[open]')).toBeVisible()
    expect(await violations(lab)).toEqual([])
    await lab.keyboard.press('Escape')
    await expect(lab.locator('dialog')).toHaveCount(0)
  }
  await show(lab, LINK)
})

// Written anew by --update-snapshots=all, which waits the whole time limit of expect for each view: two minutes.
test('what a screen reader has of every view', async ({ lab }) => {
  for (const view of PLACES) {
    await show(lab, `view=${view}&${LINK}&lang=en`)
    await expect(lab.locator('#page')).toMatchAriaSnapshot({ name: `${view.replace('&handout=', '-')}.aria.yml` })
  }
  await show(lab, `view=data&from=period&${LINK}&lang=en`)
  await expect(lab.locator('#page')).toMatchAriaSnapshot({ name: 'data-period.aria.yml' })
})

/** Marks of the catalogues that a page shows as they are: _T_{0}, *bold*, {name}. */
const marksSeen = (page: Page): Promise<string[]> =>
  page.evaluate(() => {
    const walker = document.createTreeWalker(document.querySelector('#page') as Element, NodeFilter.SHOW_TEXT)
    const texts: string[] = []
    while (walker.nextNode())
      if (!walker.currentNode.parentElement?.closest('.code, textarea, input'))
        texts.push((walker.currentNode as Text).data)
    return texts.filter((text) => /_[^_\s]+_|\*[^*\s][^*]*\*|\{\w+\}/.test(text))
  })

for (const [width, height] of SCREENS) {
  test(`at ${width} × ${height} no text is on text or off the screen, and targets are large enough`, async ({
    lab,
  }) => {
    await lab.setViewportSize({ width, height })
    const faults: string[] = []
    for (const view of PLACES) {
      for (const language of LANGUAGES) {
        await show(lab, `view=${view}&${LINK}&key=1&lang=${language}`)
        await drawn(lab)
        faults.push(...(await marksSeen(lab)).map((each) => `${view} ${language}: ${each}`))
        // A text to read is as long as it is.
        const oneScreen = width >= 1280 && view !== 'derivation'
        faults.push(...(await layoutFaults(lab, oneScreen)).map((each) => `${view} ${language}: ${each}`))
      }
    }
    await lab.setViewportSize({ width: 1280, height: 720 })
    expect(faults).toEqual([])
  })
}

test('story 14: words 40 % longer break no layout at 360 pixels', async ({ browser }) => {
  const page = await opened(browser, LINK, { viewport: { width: 360, height: 740 } })
  const faults: string[] = []
  for (const view of PLACES) {
    await show(page, `view=${view}&${LINK}`)
    await drawn(page)
    await lengthen(page)
    expect(await page.locator('#page .sentence').textContent()).toContain('ë')
    await drawn(page)
    faults.push(...(await layoutFaults(page)).map((each) => `${view}: ${each}`))
    await shorten(page)
  }
  await page.context().close()
  expect(faults).toEqual([])
})

test('story 14: decimal comma and point are both read, and functions have their names', async ({ lab }) => {
  for (const [language, sine] of [
    ['pt-BR', 'sen'],
    ['es', 'sen'],
    ['en', 'sin'],
  ] as const) {
    for (const typed of ['9,81', '9.81']) {
      await show(lab, `th0=150deg&L=1m&g=9.8&lang=${language}&t=0s`)
      await lab.locator('#field-gravity').fill(typed)
      await lab.keyboard.press('Enter')
      await lab.locator('#field-gravity').blur()
      await expect(lab.locator('#field-gravity')).toHaveValue(language === 'en' ? '9.81' : '9,81')
      await expect(lab.locator('#field-gravity')).toHaveAttribute('aria-invalid', 'false')
      await expect(lab.locator('#period-value')).toHaveText(language === 'en' ? /^3\.5351/ : /^3,5351/)
    }
    await expect(lab.locator('.facts')).toContainText(sine)
    await expect(lab.locator('.compare')).toContainText(sine)
  }
  // A number of another language's CSV has its comma.
  await show(lab, 'th0=150deg&lang=pt-BR&t=0s')
  expect((await csvOf(lab, 'angle')).text).toMatch(/\r\n0;150;/)
  await show(lab, LINK)
})
