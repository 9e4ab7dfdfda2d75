// A chart of the page: title with unit, switches, data table and sound, the plot itself as a slider of time, a sentence.

import { html, noChange, nothing, type TemplateResult } from 'lit-html'
import { iconButton } from '../controls/parts'
import { measured, sizeOf } from '../controls/size'
import { afterKey, dragging, partAlong } from '../controls/slide'
import { plain, rich } from '../language/rich'
import type { Window } from '../study'
import type { ChartSpec, Cursor, Text } from './chart-spec'
import type { Page } from './page'
import { saveMenu } from './saving'
import { table } from './table'
import { toggleSound } from './trace'

/** A text, which stays as it was while a hand is on a control: nobody reads it then. */
function settled(page: Page, text: Text): string | typeof noChange {
  if (typeof text === 'string') return plain(text)
  return page.session.held === null ? plain(text()) : noChange
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
    }${spec.table ? saveMenu(page, { key: spec.key, name: spec.name, items: (menus) => menus.chartItems(page, spec) }) : nothing}</span>`
}

export function toggleTable({ store, session }: Page, key: string): void {
  const open = session.tables.includes(key)
  store.setSession({ tables: open ? session.tables.filter((each) => each !== key) : [...session.tables, key] })
}

/** The time of a window as what is moved. */
function timeCursor(page: Page, { name, spoken }: ChartSpec, { from, to }: Window): Cursor {
  const { store, t, words } = page
  const seek = (time: number) => {
    store.clock.pause()
    store.seek(Math.min(Math.max(time, 0), to - 1e-6 * (to - from)))
  }
  const { playing } = store.clock
  return {
    label: words.fill(words.say.plots.now, { plot: name }),
    least: from,
    most: to,
    now: playing ? from : Number(t.toFixed(3)),
    text: playing || spoken === undefined ? null : settled(page, spoken),
    key: (event) => {
      const next = afterKey(event, { value: store.clock.t, least: from, most: to, step: (to - from) / 100 })
      if (next !== null) seek(next)
      return next !== null
    },
    drag: { at: (x, _, element) => seek(from + (to - from) * partAlong(x, element)) },
  }
}

function area(page: Page, spec: ChartSpec): TemplateResult {
  const { rem } = page
  const size = sizeOf(spec.key)
  const drawn = size && size.width > 0 ? spec.draw({ width: size.width, height: size.height, rem }) : nothing
  const style = `--plot-height:${spec.height}rem`
  const className = `plot ${spec.xLabels ? 'with-x' : 'without-x'}`
  const cursor = spec.cursor ?? (spec.window && timeCursor(page, spec, spec.window))
  if (!cursor || spec.waiting) {
    return html`<div class=${className} style=${style} ${measured(spec.key)}>${drawn}${spec.waiting ? html`<p class="waiting">${spec.waiting}</p>` : nothing}${spec.over ?? nothing}</div>`
  }
  return html`<div class=${className} style=${style} ${measured(spec.key)} role="slider" tabindex="0" data-plot=${spec.key}
    aria-label=${cursor.label} aria-valuemin=${cursor.least} aria-valuemax=${cursor.most}
    aria-valuenow=${cursor.now} aria-valuetext=${cursor.text ?? nothing}
    @keydown=${(event: KeyboardEvent) => {
      if (!cursor.key(event)) return
      event.preventDefault()
      event.stopPropagation()
    }}
    @pointerdown=${dragging(cursor.drag)}>${drawn}${spec.over ?? nothing}</div>`
}

export function chart(page: Page, spec: ChartSpec): TemplateResult {
  const open = page.session.tables.includes(spec.key) && spec.table
  return html`<figure class="chart ${spec.className}" data-chart=${spec.key} aria-label=${plain(spec.title)}>
    <div class="head"><h2>${rich(spec.title)}${spec.unit ? html` <span class="unit">${rich(spec.unit)}</span>` : nothing}</h2>${tools(page, spec)}</div>
    ${area(page, spec)}
    ${spec.note ?? nothing}
    ${open && spec.table ? table(page, spec.key, spec.table()) : nothing}
    <figcaption class="unseen">${settled(page, spec.caption)}</figcaption>
  </figure>`
}
