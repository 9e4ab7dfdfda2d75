// A chart of the page: title with unit, switches, data table and sound, the plot itself as a slider of time, a sentence.

import { html, nothing, type TemplateResult } from 'lit-html'
import { iconButton } from '../controls/parts'
import { measured, sizeOf } from '../controls/size'
import { afterKey, dragging, partAlong } from '../controls/slide'
import { plain, rich } from '../language/rich'
import type { Window } from '../study'
import type { Page } from './page'
import { type TableSpec, table } from './table'
import { type SoundSpec, toggleSound } from './trace'

export interface PlotSize {
  readonly width: number
  readonly height: number
  readonly rem: number
}

export interface ChartSpec {
  readonly key: string
  readonly className: string
  readonly title: string
  readonly unit?: string
  /** In words, for names of buttons. */
  readonly name: string
  /** In rem. */
  readonly height: number
  readonly xLabels: boolean
  readonly switches?: TemplateResult | typeof nothing
  /** The plot, once its size is known; the text of a plot that has none. */
  readonly draw: (size: PlotSize) => TemplateResult
  readonly waiting?: string
  /** One sentence from the state: the figure in words. */
  readonly caption: string
  /** What an arrow key on the plot says. */
  readonly spoken?: string
  readonly window?: Window
  readonly table?: () => TableSpec
  readonly sound?: () => SoundSpec
  /** Below the plot: reasons of hatching, what to do when it is empty. */
  readonly note?: TemplateResult | typeof nothing
  readonly over?: TemplateResult | typeof nothing
}

/** The tools at the right of a title. */
function tools(page: Page, spec: ChartSpec): TemplateResult {
  const { store, session, words } = page
  const { plots } = words.say
  const open = session.tables.includes(spec.key)
  const sounding = session.sounding === spec.key
  return html`<span class="tools">${spec.switches ?? nothing}
    ${spec.table ? iconButton(words.fill(plots.table, { plot: spec.name }), 'table', () => toggleTable(page, spec.key), open) : nothing}
    ${
      spec.sound
        ? iconButton(
            words.fill(sounding ? plots.stop : plots.listen, { plot: spec.name }),
            'sound',
            () => toggleSound(store, spec.key, spec.sound),
            sounding,
          )
        : nothing
    }</span>`
}

export function toggleTable({ store, session }: Page, key: string): void {
  const open = session.tables.includes(key)
  store.setSession({ tables: open ? session.tables.filter((each) => each !== key) : [...session.tables, key] })
}

function area(page: Page, spec: ChartSpec): TemplateResult {
  const { store, rem, t, words } = page
  const size = sizeOf(spec.key)
  const drawn = size && size.width > 0 ? spec.draw({ width: size.width, height: size.height, rem }) : nothing
  const { window } = spec
  const style = `--plot-height:${spec.height}rem`
  const className = `plot ${spec.xLabels ? 'with-x' : 'without-x'}`
  if (!window || spec.waiting) {
    return html`<div class=${className} style=${style} ${measured(spec.key)}>${drawn}${spec.waiting ? html`<p class="waiting">${spec.waiting}</p>` : nothing}${spec.over ?? nothing}</div>`
  }
  const seek = (time: number) => {
    store.clock.pause()
    store.seek(Math.min(Math.max(time, 0), window.to - 1e-6 * (window.to - window.from)))
  }
  return html`<div class=${className} style=${style} ${measured(spec.key)} role="slider" tabindex="0" data-plot=${spec.key}
    aria-label=${words.fill(words.say.plots.now, { plot: spec.name })} aria-valuemin=${window.from} aria-valuemax=${window.to}
    aria-valuenow=${store.clock.playing ? window.from : Number(t.toFixed(3))} aria-valuetext=${store.clock.playing ? nothing : (spec.spoken ?? nothing)}
    @keydown=${(event: KeyboardEvent) => {
      const next = afterKey(event, {
        value: store.clock.t,
        least: window.from,
        most: window.to,
        step: (window.to - window.from) / 100,
      })
      if (next === null) return
      event.preventDefault()
      event.stopPropagation()
      seek(next)
    }}
    @pointerdown=${dragging({ at: (x, _, element) => seek(window.from + (window.to - window.from) * partAlong(x, element)) })}>${drawn}${spec.over ?? nothing}</div>`
}

export function chart(page: Page, spec: ChartSpec): TemplateResult {
  const open = page.session.tables.includes(spec.key) && spec.table
  return html`<figure class="chart ${spec.className}" data-chart=${spec.key} aria-label=${plain(spec.title)}>
    <div class="head"><h2>${rich(spec.title)}${spec.unit ? html` <span class="unit">${rich(spec.unit)}</span>` : nothing}</h2>${tools(page, spec)}</div>
    ${area(page, spec)}
    ${spec.note ?? nothing}
    ${open && spec.table ? table(page, spec.key, spec.table()) : nothing}
    <figcaption class="unseen">${plain(spec.caption)}</figcaption>
  </figure>`
}
