// The colours keep their contrast in both themes: text 4.5, curves, borders and handles 3, on paper and on panels (WCAG 2.2).

import { readFileSync } from 'node:fs'
import { describe, expect, it } from 'vitest'

const css = readFileSync(new URL('../src/style/tokens.css', import.meta.url), 'utf8')

/** Custom properties of the block after a selector. */
function tokens(selector: string): Record<string, string> {
  const block = css.slice(css.indexOf(`${selector} {`)).split('}')[0] ?? ''
  return Object.fromEntries([...block.matchAll(/--([\w-]+): (#[0-9a-f]{6});/g)].map((match) => [match[1], match[2]]))
}

function luminance(colour: string): number {
  const [r = 0, g = 0, b = 0] = [1, 3, 5].map((at) => {
    const part = Number.parseInt(colour.slice(at, at + 2), 16) / 255
    return part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4
  })
  return 0.2126 * r + 0.7152 * g + 0.0722 * b
}

function contrast(a: string, b: string): number {
  const [low = 0, high = 0] = [luminance(a), luminance(b)].sort((x, y) => x - y)
  return (high + 0.05) / (low + 0.05)
}

it('the ruler measures: black on white is 21', () => expect(contrast('#000000', '#ffffff')).toBeCloseTo(21, 9))

describe.each([
  ['light', ':root'],
  ['dark', ':root[data-theme="dark"]'],
])('%s', (_, selector) => {
  const theme = tokens(selector)
  const least = (name: string) =>
    Math.min(...['paper', 'panel'].map((ground) => contrast(theme[name] ?? '', theme[ground] ?? '')))

  it('has every colour', () => expect(Object.keys(theme)).toHaveLength(16))
  it.each(['ink', 'soft', 'alarm'])('%s is read', (name) => expect(least(name)).toBeGreaterThanOrEqual(4.5))
  it.each(['edge', 'brass', ...Object.keys(theme).filter((name) => name.startsWith('c-'))])('%s is seen', (name) =>
    expect(least(name)).toBeGreaterThanOrEqual(3),
  )
})

it('the dark theme of the system is that of the switch', () => {
  expect(tokens(':root:not([data-theme="light"])')).toEqual(tokens(':root[data-theme="dark"]'))
})
