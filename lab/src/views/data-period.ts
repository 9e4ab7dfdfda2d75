// Data from a period that was timed: T, the length and the swing to g by the exact law, beside what the formula of small swings gives
// and what the place has.

import { html, nothing, type TemplateResult } from 'lit-html'
import { extent } from '../draw/curve'
import { icon } from '../draw/icons'
import { plot } from '../draw/plot'
import { linearScale, roundTicks } from '../draw/scale'
import { rich } from '../language/rich'
import { inLanguage } from '../language/sentences'
import { DEGREES, degrees } from '../number'
import { EXAMPLE, type GravityCurve, isBadTiming, type Timing, type TimingName, timingNumber } from '../timing'
import { roundTicksOf } from './axis-ticks'
import { chart } from './chart'
import type { PlotSize } from './chart-spec'
import { entryField, entryLine, entryPair, notANumber } from './data-fields'
import { budget, withUncertainty } from './data-result'
import type { Live } from './page'

function entries(page: Live, timing: Timing): TemplateResult {
  const { data, units } = page.words.say
  const say = data.timing
  const field = (name: TimingName, label: string, unit = '') =>
    entryField({
      id: `timing-${name}`,
      label,
      text: timing.entries[name],
      bad: isBadTiming(name, timing.entries[name]),
      unit,
      type: (text) => timing.enter({ [name]: text }),
    })
  const pair = (name: 'time' | 'length' | 'swing' | 'end', unit: string) =>
    entryLine(
      say[name],
      entryPair(field(name, say[name]), field(`${name}U`, page.words.fill(say.u, { of: say[name] }), unit)),
    )
  return html`<h2>${say.title}</h2>
    ${pair('time', units.s)}${entryLine(say.swings, field('swings', say.swings))}
    ${pair('length', units.m)}${pair('swing', '°')}${pair('end', '°')}
    <p class="soft small">${say.help}</p>
    <h2>${say.place}</h2>
    ${entryLine(say.latitude, field('latitude', say.latitude, '°'))}${entryLine(say.height, field('height', say.height, units.m))}
    <p class="soft small">${rich(say.placeHelp)}</p>
    ${notANumber(page, timing.bad)}
    <button type="button" class="button quiet" id="timing-example" @click=${() => timing.enter(typed(page, EXAMPLE))}>${say.example}</button>`
}

/** Numbers with the language's sign of decimals. */
function typed({ words }: Live, texts: typeof EXAMPLE): typeof EXAMPLE {
  return Object.fromEntries(Object.entries(texts).map(([name, text]) => [name, text.replace('.', words.decimal)]))
}

function draw(page: Live, timing: Timing, curve: GravityCurve, size: PlotSize): TemplateResult {
  const { words } = page
  const { width, height, rem } = size
  const { found, normal } = timing.answer ?? {}
  const g = found?.g.value ?? Number.NaN
  const x = curve.swing.map((each) => each * DEGREES)
  const [least, most] = extent(Float64Array.of(...curve.g, ...(normal ? [normal] : [])))
  const room = 0.06 * (most - least)
  const sx = linearScale([0, x.at(-1) as number], [0, width])
  const sy = linearScale([least - room, most + room], [height, 0])
  const xs = roundTicks(0, sx.high, width < 26 * rem ? 5 : 9)
  const swings = (['swing', 'end'] as const)
    .map((name) => degrees(timingNumber(name, timing.entries[name])))
    .filter((each) => each > 0)
  const [low, high] = [Math.min(...swings), Math.max(...swings)]
  // Where the swing decays, its mean stands where the curve has g.
  const at = curve.g.findIndex((each) => each > g)
  const mean = swings.length < 2 || at < 1 ? high : (x[at] as number)
  return plot(
    {
      ...size,
      sx,
      sy,
      xs: xs.map((value) => ({ value, text: `${words.fixed(value, 0)}°` })),
      ys: roundTicksOf(words, sy.low, sy.high, 6),
      xLabels: true,
      lines: [{ x, y: curve.g, clothes: 'c-exact' }],
      levels: normal ? [normal] : [],
      verticals: swings.map((value) => ({ x: value, text: '' })),
      labels: normal
        ? [
            {
              x: width - 0.25 * rem,
              y: sy(normal) + (sy(normal) > 1.5 * rem ? -0.35 : 1) * rem,
              text: words.fill(page.words.say.data.timing.atPlace, { g: words.fixed(normal, 3) }),
              anchor: 'end',
              ink: true,
            },
          ]
        : [],
      rings: Number.isFinite(low) ? [{ x: mean, y: g }] : [],
    },
    [curve, timing.answer, words],
  )
}

function picture(page: Live, timing: Timing, curve: GravityCurve): TemplateResult {
  const { words } = page
  const say = words.say.data.timing
  const { units, table } = words.say
  return chart(page, {
    key: 'timing',
    className: 'first-chart',
    title: say.chart,
    unit: words.fill(say.chartUnit, { unit: units['m/s2'] }),
    name: say.chart,
    height: 18,
    xLabels: true,
    draw: (size) => draw(page, timing, curve, size),
    caption: () => sentenceOfTiming(page, timing),
    table: () => ({
      caption: words.fill(table.caption, { plot: say.chart, unit: units['m/s2'] }),
      file: 'gravity',
      first: { title: say.swingColumn, values: curve.swing, factor: DEGREES, decimals: 1 },
      columns: [{ title: '_g_', values: curve.g, factor: 1, decimals: 4 }],
    }),
  })
}

function values(page: Live, timing: Timing): TemplateResult | typeof nothing {
  const { words } = page
  const { data, units } = words.say
  const say = data.timing
  const { found, normal } = timing.answer ?? { found: null, normal: null }
  const row = (name: string, text: string, id: string, note: string | null = null, big = false) =>
    html`<dt class=${big ? 'big' : ''}>${rich(name)}</dt><dd class=${big ? 'big' : ''} id=${id}>${rich(words.with(text, units['m/s2']))}${note === null ? nothing : html` <span class="soft small">${rich(note)}</span>`}</dd>`
  const apart = found && normal !== null ? found.g.value - normal : null
  const times = found && apart !== null && found.g.u > 0 ? words.fixed(Math.abs(apart) / found.g.u, 1) : null
  return html`<dl class="facts">
    ${found ? row('_g_', withUncertainty(words, found.g), 'timing-g', null, true) : nothing}
    ${found ? row(say.small, words.fixed(found.small_swings, 3), 'timing-small') : nothing}
    ${normal === null ? nothing : row(say.normal, words.fixed(normal, 4), 'timing-normal')}
    ${found && apart !== null ? row(say.difference, withUncertainty(words, { value: apart, u: found.g.u }), 'timing-difference', times && `(${times} _u_)`) : nothing}</dl>
    ${found ? budget(page, found.budget, { of: found.g, unit: units['m/s2'] }) : nothing}`
}

export function timingBody(page: Live, timing: Timing): TemplateResult {
  const { words } = page
  const say = words.say.data.timing
  const { answer, curve, message } = timing
  const told = inLanguage(message, words.language)
  return html`<div class="column left timing">${entries(page, timing)}</div>
    <div class="column middle"><div role="status">${message === '' ? nothing : html`<p class="refusal">${icon('warn')}<span id="timing-refusal" lang=${told === message ? 'en' : nothing}>${told}</span></p>`}</div>
    ${curve ? picture(page, timing, curve) : html`<p class="soft">${timing.waits ? words.say.plots.loadingView : rich(say.waiting)}</p>`}</div>
    ${
      answer?.found || answer?.normal
        ? html`<div class="column right" tabindex="0" role="region" aria-label=${words.say.data.result}><h2>${words.say.data.result}</h2>${values(page, timing)}</div>`
        : nothing
    }`
}

export function sentenceOfTiming({ words }: Live, { answer }: Timing): string {
  const say = words.say.data.timing
  const unit = words.say.units['m/s2']
  const { found, normal } = answer ?? { found: null, normal: null }
  const place = normal === null ? '' : words.with(words.fixed(normal, 3), unit)
  if (!found) return place === '' ? say.sentenceEmpty : words.fill(say.sentencePlace, { g: place })
  const values = {
    g: words.with(withUncertainty(words, found.g), unit),
    small: words.fixed(found.small_swings, 3),
    place,
  }
  return words.fill(place === '' ? say.sentence : say.sentenceBoth, values)
}
