// Tables as text: comma-separated, or by semicolons where the comma is decimal (RFC 4180). Every number has as many digits as read
// back to the same double, at most 17.

import { version } from '../../package.json'
import type { Column, TableSpec } from '../columns'
import type { Words } from '../language'
import { plain } from '../language/rich'

/** The decimal sign of a file; the language's where the reader does not choose. */
export type DecimalSign = '.' | ','

/** What stands between the columns. */
export const separatorOf = (sign: DecimalSign): string => (sign === ',' ? ';' : ',')

/** A title with a separator or a quotation mark of its own stands in quotes. */
const quoted = (title: string) => (/[",;]/.test(title) ? `"${title.replaceAll('"', '""')}"` : title)

/** What the header says of a curve: its formula, or what it is. */
const aboutOf = ({ title, about }: Column): string[] =>
  about === undefined ? [] : [`# ${plain(title)}: ${plain(about)}`]

/** All rows of a table. An empty cell is a value that does not exist. */
export function csv(
  words: Words,
  { caption, first, columns }: TableSpec,
  link: string,
  sign: DecimalSign = words.decimal,
): string {
  const between = separatorOf(sign)
  const number = (value: number) => (Number.isFinite(value) ? String(value).replace('.', sign) : '')
  const all = [first, ...columns]
  const rows = Array.from(first.values, (_, i) =>
    all.map(({ values, factor }) => number((values[i] as number) * factor)).join(between),
  )
  return [
    `# ${plain(caption)}`,
    `# ${link}`,
    `# libration ${version}; ${words.say.table[sign === ',' ? 'decimalComma' : 'decimalPoint']}`,
    ...all.flatMap(aboutOf),
    all.map(({ title }) => quoted(plain(title))).join(between),
    ...rows,
    '',
  ].join('\r\n')
}
