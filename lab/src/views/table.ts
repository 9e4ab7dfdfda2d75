// The data table behind a chart: the same numbers as are drawn, and all of them as CSV.

import { html, type TemplateResult } from 'lit-html'
import type { Words } from '../language'
import { plain, rich } from '../language/rich'
import { writeLink } from '../link'
import type { Page } from './page'

export interface Column {
  readonly title: string
  readonly values: Float64Array
  /** From the unit of the data to that of the table. */
  readonly factor: number
  readonly decimals: number
  /** Significant ones instead, where sizes differ much. */
  readonly digits?: number
}

export interface TableSpec {
  readonly caption: string
  /** Name of the file, without its ending. */
  readonly file: string
  readonly first: Column
  readonly columns: readonly Column[]
  /** Rows of the short table; else some at even distances. */
  readonly some?: readonly number[]
}

const SOME = 8

/** Text with every row; a comma between columns, or a semicolon where the comma is decimal. All digits of each number. */
export function csv(words: Words, { caption, first, columns }: TableSpec, link: string): string {
  const between = words.decimal === ',' ? ';' : ','
  const number = (value: number) => (Number.isFinite(value) ? String(value).replace('.', words.decimal) : '')
  const all = [first, ...columns]
  // A title with a comma of its own stands in quotes (RFC 4180).
  const quoted = (title: string) => (/[",;]/.test(title) ? `"${title.replaceAll('"', '""')}"` : title)
  const head = all.map(({ title }) => quoted(plain(title))).join(between)
  const rows = Array.from(first.values, (_, i) =>
    all.map(({ values, factor }) => number((values[i] as number) * factor)).join(between),
  )
  return [`# ${plain(caption)}`, `# ${link}`, head, ...rows, ''].join('\r\n')
}

function save(text: string, name: string): void {
  const url = URL.createObjectURL(new Blob(['\ufeff', text], { type: 'text/csv;charset=utf-8' }))
  const link = document.createElement('a')
  link.href = url
  link.download = name
  link.click()
  setTimeout(() => URL.revokeObjectURL(url), 1000)
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
  const link = () => location.href.replace(/#.*$/, '') + writeLink(store.moment, store.kept)
  return html`<div class="table-box" tabindex="0" role="region" aria-label=${plain(spec.caption)}><table class="data">
    <caption>${rich(spec.caption)} <button type="button" class="text-button" @click=${() => save(csv(words, spec, link()), `${spec.file}.csv`)}>${words.say.table.csv}</button> ·
      <button type="button" class="text-button" @click=${toggle}>${whole ? words.say.table.some : words.fill(words.say.table.all, { count })}</button></caption>
    <thead><tr><th scope="col">${rich(first.title)}</th>${columns.map(({ title }) => html`<th scope="col">${rich(title)}</th>`)}</tr></thead>
    <tbody>${rows.map((i) => html`<tr><th scope="row">${cell(first, i)}</th>${columns.map((column) => html`<td>${rich(cell(column, i))}</td>`)}</tr>`)}</tbody>
  </table></div>`
}
