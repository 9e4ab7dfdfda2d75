// What is typed beside measurements: texts as they stand in their fields, the numbers that they are, and the statements of the module.

import type { Statements } from './model/fit-protocol'
import { parseNumber, parseQuantity, type Unit } from './number'

/** What a column can be stated to be, as the command line writes it. */
export const ROLES = ['time', 'angle', 'velocity', 'acceleration', 'x', 'y', 'period'] as const
type RoleName = (typeof ROLES)[number]
export const MODELS = ['auto', 'none', 'linear', 'quadratic', 'dry', 'presliding'] as const
/** What of the pendulum is known. */
export const KNOWN = ['length', 'gravity', 'parts'] as const
export const SHAPES = ['rod', 'ball', 'disc', 'point'] as const
type ShapeName = (typeof SHAPES)[number]

/** A part of a rigid pendulum: for a rod `size` is its length and `distance` that of its centre, or empty where it hangs from the pivot. */
export interface PartEntry {
  readonly shape: ShapeName
  readonly mass: string
  readonly distance: string
  readonly size: string
}
export type PartField = Exclude<keyof PartEntry, 'shape'>

const NUMBERS = {
  rate: '',
  run: '',
  length: 'm',
  lengthU: 'm',
  gravity: 'm/s2',
  gravityU: 'm/s2',
  bobRadius: 'm',
  bobMass: 'kg',
  wireMass: 'kg',
} as const satisfies Record<string, Unit>

export type NumberName = keyof typeof NUMBERS
type ColumnName = `column-${RoleName}` | `unit-${RoleName}`
export type FieldName = NumberName | ColumnName

export interface Entries extends Readonly<Record<FieldName, string>> {
  readonly known: (typeof KNOWN)[number]
  readonly model: (typeof MODELS)[number]
  readonly parts: readonly PartEntry[]
}

const NAMES = Object.keys(NUMBERS) as NumberName[]
const COLUMNS = ROLES.flatMap((role) => [`column-${role}`, `unit-${role}`] as const)
/** What is stated of a file and not of its pendulum, with nothing stated. */
export const NOTHING_OF_FILE = Object.fromEntries([...COLUMNS, 'rate', 'run'].map((name) => [name, ''])) as Record<
  ColumnName | 'rate' | 'run',
  string
>

export const NEW_PART: PartEntry = { shape: 'rod', mass: '', distance: '', size: '' }
export const NOTHING: Entries = {
  ...(Object.fromEntries([...COLUMNS, ...NAMES].map((name) => [name, ''])) as Record<FieldName, string>),
  known: 'length',
  model: 'auto',
  parts: [NEW_PART],
}

const isNumber = (name: FieldName): name is NumberName => Object.hasOwn(NUMBERS, name)

/** The number that an entry is, in SI units; NaN if it is none. */
export function entryNumber(name: NumberName, text: string): number {
  const unit = NUMBERS[name]
  return unit === '' ? parseNumber(text) : parseQuantity(text, unit)
}

/** Whether what is typed is no number where one belongs. */
export function isBad(name: FieldName, text: string): boolean {
  return isNumber(name) && text.trim() !== '' && Number.isNaN(entryNumber(name, text))
}

/** `0.495±0.001`, with a unit behind it or none, as value and uncertainty in SI units; null if it is not one. */
export function measuredValue(text: string, unit: Unit): readonly [value: number, u: number] | null {
  const [value = '', u, ...more] = text.trim().split(/\s*(?:±|\+-|\+\/-)\s*/)
  const named = /[a-z°/²]+2?$/i.exec(u ?? '')?.[0] ?? ''
  // The unit behind the uncertainty is that of both.
  const both = u === undefined || Number.isNaN(parseNumber(value)) ? value : `${value}${named}`
  const pair = [parseQuantity(both, unit), u === undefined ? 0 : parseQuantity(u, unit)] as const
  return more.length === 0 && pair.every(Number.isFinite) ? pair : null
}

const PART_UNITS = { mass: 'kg', distance: 'm', size: 'm' } as const
/** The fields that a shape has. */
export const FIELDS: Readonly<Record<ShapeName, readonly PartField[]>> = {
  rod: ['size', 'mass', 'distance'],
  ball: ['distance', 'mass', 'size'],
  disc: ['distance', 'mass', 'size'],
  point: ['distance', 'mass'],
}

/** Whether a field of a part cannot be read; the centre of a rod may be left out. */
export function isBadPart({ shape, ...part }: PartEntry, field: PartField): boolean {
  return (
    part[field].trim() !== '' && FIELDS[shape].includes(field) && measuredValue(part[field], PART_UNITS[field]) === null
  )
}

/** The statement of a part; null while a field is empty or cannot be read. */
function statedPart({ shape, ...part }: PartEntry): string | null {
  const of = (field: PartField) => measuredValue(part[field], PART_UNITS[field])
  const mass = of('mass')
  const size = shape === 'point' ? ([0, 0] as const) : of('size')
  const empty = part.distance.trim() === ''
  const hangs = shape === 'rod' && empty && size
  // A rod that hangs from the pivot has its centre at half its length.
  const distance = hangs ? ([size[0] / 2, size[1] / 2] as const) : of('distance')
  return mass && size && distance ? [shape, ...mass, ...distance, ...size].join(' ') : null
}

/** The first text that cannot be read; null if all can. */
export function badText(entries: Entries): string | null {
  const name = NAMES.find((each) => isBad(each, entries[each]))
  if (name) return entries[name]
  if (entries.known !== 'parts') return null
  for (const part of entries.parts)
    for (const field of FIELDS[part.shape]) if (isBadPart(part, field)) return part[field]
  return null
}

type Pair = readonly [name: string, value: string]

/** How a file is read. */
export function readingOf(entries: Entries): Pair[] {
  const out: Pair[] = []
  for (const role of ROLES) {
    const [column, unit] = [entries[`column-${role}`], entries[`unit-${role}`]].map((each) => each.trim())
    if (column) out.push(['column', `${role}=${column}`])
    if (unit) out.push(['unit', `${role}=${unit}`])
  }
  for (const name of ['rate', 'run'] as const)
    if (entries[name].trim() !== '') out.push([name, String(entryNumber(name, entries[name]))])
  return out
}

/** A value with its uncertainty, which may be left out. */
function measured(name: 'length' | 'gravity', text: string, u: string): Pair[] {
  if (text.trim() === '') return []
  return [[name, `${entryNumber(name, text)} ${u.trim() === '' ? 0 : entryNumber(`${name}U`, u)}`]]
}

export const lengthOf = (length: string, u: string): Pair[] => measured('length', length, u)

/** What is known of the pendulum, a length apart. */
export function knownOf(entries: Entries): Pair[] {
  const { known, model, bobRadius, bobMass, wireMass } = entries
  const out: Pair[] = []
  if (known === 'gravity') out.push(...measured('gravity', entries.gravity, entries.gravityU))
  if (known === 'parts')
    for (const part of entries.parts) {
      const stated = statedPart(part)
      if (stated) out.push(['part', stated])
    }
  // Parts have their size and mass themselves.
  if (known !== 'parts') {
    if (bobRadius.trim() !== '' && bobMass.trim() !== '')
      out.push(['bob', `${entryNumber('bobRadius', bobRadius)} ${entryNumber('bobMass', bobMass)}`])
    if (wireMass.trim() !== '') out.push(['wire', String(entryNumber('wireMass', wireMass))])
  }
  if (model !== 'auto') out.push(['model', model])
  return out
}

/** The statements of one file and its pendulum. */
export function statementsOf(file: string, entries: Entries): Statements {
  const length = entries.known === 'length' ? lengthOf(entries.length, entries.lengthU) : []
  return [['file', file], ...readingOf(entries), ...length, ...knownOf(entries)]
}
