// The data table behind a chart: the same numbers as are drawn, and all of them as CSV.

import { html, type TemplateResult } from 'lit-html'
import type { Column, TableSpec } from '../columns'
import { plain, rich } from '../language/rich'
import { writeLink } from '../link'
import { csv, type DecimalSign } from '../save/csv'
import { saveFile } from '../save/file'
import type { Page } from './page'

const SOME = 8

/** Of the page as it is: all of the picture is in it. */
export function linkOf({ store }: Pick<Page, 'store'>): string {
  return location.href.replace(/#.*$/, '') + writeLink(store.moment, store.kept)
}

/** A byte order mark tells a spreadsheet that the text is UTF-8. */
export function saveCsv(page: Page, spec: TableSpec, sign?: DecimalSign): void {
  saveFile(['\ufeff', csv(page.words, spec, linkOf(page), sign)], 'text/csv;charset=utf-8', `${spec.file}.csv`)
}

export function table(page: Page, key: string, spec: TableSpec): TemplateResult {
  const { words, store, session } = page
  const { first, columns } = spec
  const count = first.values.length
  const whole = session.wholeTables.includes(key)
  const stride = whole ? 1 : Math.max(1, Math.floor((count - 1) / SOME))
  const even = Array.from({ length: Math.floor((count - 1) / stride) + 1 }, (_, i) => i * stride)
  const rows = whole ? even : (spec.some ?? even)
  const cell = ({ values, factor, decimals, digits }: Column, i: number) => {
    const value = (values[i] as number) * factor
    if (Number.isNaN(value)) return words.say.table.noValue
    return digits === undefined ? words.fixed(value, decimals) : words.significant(value, digits)
  }
  const toggle = () =>
    store.setSession({
      wholeTables: whole ? session.wholeTables.filter((each) => each !== key) : [...session.wholeTables, key],
    })
  return html`<div class="table-box" tabindex="0" role="region" aria-label=${plain(spec.caption)}><table class="data">
    <caption>${rich(spec.caption)} <button type="button" class="text-button" @click=${() => saveCsv(page, spec)}>${words.say.table.csv}</button> ·
      <button type="button" class="text-button" @click=${toggle}>${whole ? words.say.table.some : words.fill(words.say.table.all, { count })}</button></caption>
    <thead><tr><th scope="col">${rich(first.title)}</th>${columns.map(({ title }) => html`<th scope="col">${rich(title)}</th>`)}</tr></thead>
    <tbody>${rows.map((i) => html`<tr><th scope="row">${cell(first, i)}</th>${columns.map((column) => html`<td>${rich(cell(column, i))}</td>`)}</tr>`)}</tbody>
  </table></div>`
}
