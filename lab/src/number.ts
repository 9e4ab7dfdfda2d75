// Numbers as people type them: a decimal point or comma, a unit behind them. No rounding that the reader does not see.

/** The double that is written, or NaN. Both `9.81` and `9,81`, `−3` with a true minus, `1e-3`. */
export function parseNumber(text: string): number {
  const plain = text
    .trim()
    .replace(/[\u2212\u2013]/g, '-')
    .replace(/[\s\u00a0\u202f]/g, '')
    .replace(',', '.')
  return /^[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?$/i.test(plain) ? Number(plain) : Number.NaN
}

const FACTORS = {
  deg: { deg: Math.PI / 180, '°': Math.PI / 180, rad: 1 },
  'rad/s': { 'rad/s': 1, 'deg/s': Math.PI / 180, '°/s': Math.PI / 180 },
  m: { m: 1, cm: 0.01, mm: 0.001 },
  'm/s2': { 'm/s2': 1, 'm/s²': 1 },
  s: { s: 1, ms: 0.001 },
  kg: { kg: 1, g: 0.001 },
  '1/s': { '1/s': 1 },
  '1/rad': { '1/rad': 1 },
  'rad/s2': { 'rad/s2': 1, 'rad/s²': 1 },
  '': {},
} as const

export type Unit = keyof typeof FACTORS

/** A number with its unit, in SI and radians; without a unit it has the quantity's own. NaN if it is not one. */
export function parseQuantity(text: string, unit: Unit): number {
  // 1e3 is a number and not 1 with a unit e3; 1/s begins with a digit, and stands behind a space.
  const bare = parseNumber(
    unit.startsWith('1/') && text.trim().endsWith(` ${unit}`) ? text.trim().slice(0, -unit.length) : text,
  )
  const match = /^(.*?)\s*([a-z°][a-z°/²]*[0-9]?)?$/i.exec(text.trim())
  if (!match) return Number.NaN
  const factors: Readonly<Record<string, number>> = FACTORS[unit]
  const named = Number.isNaN(bare) ? (match[2] ?? unit) : unit
  const factor = named === '' ? 1 : factors[named]
  if (factor === undefined) return Number.NaN
  const value = Number.isNaN(bare) ? parseNumber(match[1] ?? '') : bare
  if (factor === FACTORS.deg.deg) return radians(value)
  // 70cm is 0.7 and not 0.7000000000000001: a division by a whole number rounds once.
  return factor === 0.01 ? value / 100 : factor === 0.001 ? value / 1000 : value * factor
}

// pi/180 in two doubles: 150 degrees are the double nearest to 150 pi/180, as on the command line.
const DEGREE_HIGH = 0.017453292519943295
const DEGREE_LOW = 2.9486522708701687e-19
const SPLIT = 134217729

/** Rounded once: the error of the product is added before. */
export function radians(value: number): number {
  const high = value * DEGREE_HIGH
  if (!Number.isFinite(high) || Math.abs(value) > 1e100) return high
  const a = SPLIT * value - (SPLIT * value - value)
  const b = SPLIT * DEGREE_HIGH - (SPLIT * DEGREE_HIGH - DEGREE_HIGH)
  const [c, d] = [value - a, DEGREE_HIGH - b]
  const lost = a * b - high + a * d + c * b + c * d
  return high + (lost + value * DEGREE_LOW)
}

/** The shortest decimal that says what was typed: 12 digits, without trailing zeros. */
export function shortest(value: number): string {
  return String(Number(value.toPrecision(12)))
}

/** Degrees in a radian. */
export const DEGREES = 180 / Math.PI

/** An angle in degrees, as it is shown in a field. */
export function degrees(angle: number): number {
  return Number(((angle * 180) / Math.PI).toPrecision(12))
}

/** Text that reads back to the same double: in degrees if a short number of them is it, in radians otherwise. */
export function angleText(angle: number): string {
  const text = `${degrees(angle)}deg`
  return parseQuantity(text, 'deg') === angle ? text : `${angle}rad`
}
