// What is wrong with a layout, found in the page: text on text, text off the screen, small targets, a page that is too wide.

import type { Page } from '@playwright/test'

/** Widths and heights of a phone, a tablet, a laptop and a projector. */
export const SCREENS = [
  [360, 740],
  [768, 1024],
  [1280, 720],
  [1920, 1080],
] as const

/** Every fault as one line; none for a good layout. */
export function layoutFaults(page: Page, oneScreen = false): Promise<string[]> {
  return page.evaluate((must) => {
    const faults: string[] = []
    const shown = (element: Element): boolean => {
      if (element.closest('.unseen, .skip, [hidden], .definitions')) return false
      const box = element.getBoundingClientRect()
      const style = getComputedStyle(element)
      return box.width > 0 && box.height > 0 && style.visibility !== 'hidden' && style.display !== 'none'
    }
    const name = (element: Element) => {
      const of = (element.getAttribute('class') ?? element.tagName.toLowerCase()).trim()
      return `${of} "${(element.textContent ?? '').trim().slice(0, 20)}"`
    }
    // Every element that has text of its own.
    const all = [...document.querySelectorAll('#page *')].filter(
      (element) =>
        [...element.childNodes].some((node) => node.nodeType === 3 && (node.textContent ?? '').trim() !== '') &&
        shown(element),
    )
    const scrolls = (element: Element) => element.closest('.tabs, .table-box, .code, [role=menu]') !== null
    // The lines of an element's own words, each as high as its letters: lines may stand close.
    const lines = all.flatMap((element) => {
      const of = {
        element,
        scrolls: scrolls(element),
        sticky: element.closest('.play') !== null,
        formula: element.closest('math'),
      }
      return [...element.childNodes].flatMap((node) => {
        if (node.nodeType !== 3 || (node.textContent ?? '').trim() === '') return []
        const range = document.createRange()
        range.selectNodeContents(node)
        return [...range.getClientRects()].map(({ left, right, top, bottom, height }) => ({
          of,
          left,
          right,
          top: top + 0.25 * height,
          bottom: bottom - 0.25 * height,
        }))
      })
    })
    const out = lines.filter(({ of, left, right }) => !of.scrolls && (left < -0.5 || right > innerWidth + 0.5))
    for (const element of new Set(out.map(({ of }) => of.element))) faults.push(`off the screen: ${name(element)}`)
    // From the top down: a line is compared with those that begin above its end.
    const fixed = lines.filter(({ of }) => !of.scrolls).sort((a, b) => a.top - b.top)
    const over = new Set<string>()
    fixed.forEach((a, i) => {
      for (let k = i + 1; k < fixed.length; k++) {
        const b = fixed[k] as (typeof fixed)[number]
        if (b.top >= a.bottom - 1) break
        if (a.of.element === b.of.element || a.of.sticky !== b.of.sticky) continue
        // A formula puts its letters over one another itself.
        if (a.of.formula !== null && a.of.formula === b.of.formula) continue
        const x = Math.min(a.right, b.right) - Math.max(a.left, b.left)
        const y = Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top)
        if (x > 1.5 && y > 1) over.add(`text on text: ${name(a.of.element)}, ${name(b.of.element)}`)
      }
    })
    faults.push(...over)
    for (const element of document.querySelectorAll(
      '#page button, #page summary, #page .field, #page input[type=checkbox], #page input[type=radio]',
    )) {
      if (!shown(element)) continue
      // A box in a row is as large as its label or row lets it be; a word in a sentence is exempt (WCAG 2.5.8).
      if (element.matches('.hint-word, .text-button')) continue
      const { width, height } = element.getBoundingClientRect()
      if (width < 23.9 || height < 23.9)
        faults.push(`small target: ${name(element)} ${width.toFixed(1)} × ${height.toFixed(1)}`)
    }
    const root = document.documentElement
    if (root.scrollWidth > innerWidth) faults.push(`wider than the screen: ${root.scrollWidth} of ${innerWidth}`)
    if (must && root.scrollHeight > innerHeight)
      faults.push(`taller than the screen: ${root.scrollHeight} of ${innerHeight}`)
    return faults
  }, oneScreen)
}

/** Makes every word of the page 40 % longer, as another language might. */
export function lengthen(page: Page): Promise<void> {
  return page.evaluate(() => {
    const walker = document.createTreeWalker(document.querySelector('#page') as Element, NodeFilter.SHOW_TEXT)
    const nodes: Text[] = []
    while (walker.nextNode()) nodes.push(walker.currentNode as Text)
    const before = new Map(nodes.map((node) => [node, node.data]))
    Object.assign(window, { before })
    for (const node of nodes) {
      if (node.parentElement?.closest('.tick, .symbol, i, var, kbd, math, .stepper, .letter-mark')) continue
      node.data = node.data.replace(/\p{L}{3,}/gu, (word) => word + 'ë'.repeat(Math.ceil(0.4 * word.length)))
    }
  })
}

/** Gives the words of a page that were made longer their own length again. */
export function shorten(page: Page): Promise<void> {
  return page.evaluate(() => {
    const { before } = window as unknown as { before: Map<Text, string> }
    for (const [node, text] of before) node.data = text
  })
}
