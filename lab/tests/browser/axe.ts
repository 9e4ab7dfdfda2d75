// What axe finds in a page, by its rules for WCAG 2.2 AA and its best practice. Its script is put into a page once.

import { readFileSync } from 'node:fs'
import { createRequire } from 'node:module'
import type { Page } from '@playwright/test'
import type { AxeResults, RunOptions } from 'axe-core'

const SCRIPT = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8')
const COLOURS = 'color-contrast'
const TAGS = ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa', 'wcag22aa', 'best-practice']

/** Rules that look at colours, which no language changes, those that look at the rest, which no theme does, or all. */
type Rules = 'all' | 'colours' | 'words'

/** Each violation as one line: its rule, and the elements. */
export async function violations(page: Page, rules: Rules = 'all'): Promise<string[]> {
  if (await page.evaluate(() => !('axe' in window))) await page.evaluate(SCRIPT)
  const found = await page.evaluate(
    async (options) => {
      const { axe } = window as unknown as { axe: { run: (options: RunOptions) => Promise<AxeResults> } }
      const { violations: all } = await axe.run(options)
      return all.map(({ id, nodes }) => ({ id, places: nodes.map(({ target }) => target.join(' ')) }))
    },
    {
      runOnly: rules === 'colours' ? { type: 'rule', values: [COLOURS] } : { type: 'tag', values: TAGS },
      rules: rules === 'words' ? { [COLOURS]: { enabled: false } } : {},
      resultTypes: ['violations'],
    } satisfies RunOptions,
  )
  return found.map(({ id, places }) => `${id}: ${places.join(', ')}`)
}
