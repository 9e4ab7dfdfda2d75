// The dialog with the error of each scheme against its step, on axes of logarithms: lines whose slopes are the orders.

import { html, type TemplateResult } from 'lit-html'
import type { TableSpec } from '../columns'
import { type Convergence, convergence, ORDERS, SCHEMES } from '../convergence'
import { clothesOf } from '../draw/clothes'
import { placedLabels } from '../draw/labels'
import { plot } from '../draw/plot'
import { logScale, type Tick } from '../draw/scale'
import { plain, rich } from '../language/rich'
import { DEGREES } from '../number'
import { chart } from './chart'
import type { PlotSize } from './chart-spec'
import { dialog } from './dialogs'
import { powerText } from './error'
import type { Live } from './page'

const CLOTHES = clothesOf(SCHEMES.map((name) => ({ name, on: true })))

/** Powers of ten from one to the other, at most so many. */
function powers({ words }: Live, low: number, high: number, most: number): Tick[] {
  const [first, last] = [Math.ceil(Math.log10(low) - 1e-9), Math.floor(Math.log10(high) + 1e-9)]
  const stride = Math.max(1, Math.ceil((last - first + 1) / most))
  const out: Tick[] = []
  for (let power = last; power >= first; power -= stride)
    out.push({ value: 10 ** power, text: powerText(words, 10 ** power) })
  return out.reverse()
}

function draw(page: Live, { steps, schemes }: Convergence, size: PlotSize): TemplateResult {
  const { words } = page
  const { width, height, rem } = size
  const all = schemes.flatMap(({ errors }) => [...errors]).filter((each) => each > 0 && Number.isFinite(each))
  const [low, high] = [Math.min(...all) * DEGREES, Math.max(...all) * DEGREES]
  const sx = logScale([0.8 * (steps.at(-1) as number), 1.25 * (steps[0] as number)], [0, width])
  const sy = logScale([0.3 * low, 4 * high], [height, 0])
  const xs = powers(page, sx.low, sx.high, 6)
  const lines = schemes.map(({ errors }, i) => ({
    x: steps,
    y: errors,
    clothes: CLOTHES[i] as string,
    factor: DEGREES,
  }))
  const labels = () => {
    const named = schemes.map(({ name, errors }) => ({
      // Labels look for their places from left to right.
      x: steps.toReversed(),
      y: errors.toReversed(),
      factor: DEGREES,
      text: plain(words.say.curves[name].name),
    }))
    const room = { sx, sy, width, height, letter: 0.45 * rem, line: 0.95 * rem }
    return placedLabels(named, room).map((each) => ({ ...each, y: each.y + 0.3 * rem }))
  }
  return plot(
    {
      ...size,
      sx,
      sy,
      xs: xs.map((tick, i) =>
        i === xs.length - 1 ? { ...tick, text: words.with(tick.text, words.say.units.s) } : tick,
      ),
      ys: powers(page, sy.low, sy.high, 7),
      xLabels: true,
      lines,
      labels,
    },
    [steps, words],
  )
}

function tableOf({ words }: Live, { steps, schemes }: Convergence): TableSpec {
  const { convergence: say } = words.say
  return {
    caption: words.fill(words.say.table.caption, { plot: say.title, unit: '°' }),
    file: 'convergence',
    first: { title: say.step, values: steps, factor: 1, decimals: 6 },
    columns: schemes.map(({ name, errors }) => ({
      title: plain(words.say.curves[name].name),
      about: words.say.curves[name].what,
      values: errors,
      factor: DEGREES,
      decimals: 0,
      digits: 3,
    })),
    some: Array.from(steps, (_, i) => i),
  }
}

/** `Euler 1.00 (1)`: what is seen and what theory gives. */
function slopes({ words }: Live, { schemes }: Convergence): string {
  return schemes
    .map(({ name, slope }) => `${plain(words.say.curves[name].name)} ${words.fixed(slope, 2)} (${ORDERS[name]})`)
    .join(', ')
}

export function convergenceDialog(page: Live): TemplateResult {
  const { words, motion } = page
  const { convergence: say } = words.say
  const found = convergence(motion)
  const moving = found.schemes.some(({ errors }) => errors.some((each) => each > 0))
  const sentence = words.fill(say.caption, { slopes: slopes(page, found) })
  const body = moving
    ? html`<p class="soft convergence-sentence">${rich(sentence)}</p>
      ${chart(page, {
        key: 'convergence',
        className: 'convergence-chart',
        title: say.error,
        unit: say.unit,
        name: say.title,
        height: 15,
        xLabels: true,
        draw: (size) => draw(page, found, size),
        caption: sentence,
        table: () => tableOf(page, found),
      })}`
    : html`<p>${say.rest}</p>`
  return dialog(page, 'convergence', say.title, body)
}
