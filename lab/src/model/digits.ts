// Numbers in the sentences of a module, which leaves their bits and their form for the page to write (fit/src/digits.rs, core/src/domain.rs):
// in the digits that Rust gives them.

/** The double of 16 hexadecimal digits. */
export const doubleOf = (bits: string): number =>
  new Float64Array(BigUint64Array.of(BigInt(`0x${bits}`)).buffer)[0] as number

/** Exact digits of a double, as far as JavaScript gives them: none of its ties between two decimals is longer. */
const EXACT = 100

/** Digits after the point, of a tie the even ones. */
function fixed(value: number, digits: number): string {
  if (Math.abs(value) >= 1e21) return `${BigInt(value)}${digits > 0 ? `.${'0'.repeat(digits)}` : ''}`
  const text = value.toFixed(digits)
  const exact = Math.abs(value).toFixed(EXACT)
  const rest = exact.slice(exact.indexOf('.') + 1 + digits)
  if (!/^50*$/.test(rest)) return text
  const kept = exact.slice(0, exact.length - rest.length).replace(/\.$/, '')
  return /[02468]$/.test(kept) ? `${value < 0 ? '-' : ''}${kept}` : text
}

/** Digits after the first and an exponent without a plus, of a tie the even ones. */
function scientific(value: number, digits: number): string {
  const text = value.toExponential(digits).replace('e+', 'e')
  const [mantissa = '', exponent = ''] = value.toExponential(EXACT).split('e')
  const cut = mantissa.indexOf('.') + 1 + digits
  if (!/^50*$/.test(mantissa.slice(cut))) return text
  const kept = mantissa.slice(0, cut).replace(/\.$/, '')
  return /[02468]$/.test(kept) ? `${kept}e${Number(exponent)}` : text
}

/** A decimal with an exponent, written without it. */
function plain(text: string): string {
  const [, sign = '', whole = '', part = '', exponent = '0'] = /^(-?)(\d)(?:\.(\d+))?e\+?(-?\d+)$/.exec(text) ?? []
  const digits = `${whole}${part}`.replace(/0+$/, '') || '0'
  const before = digits === '0' ? 1 : Number(exponent) + 1
  if (before <= 0) return `${sign}0.${'0'.repeat(-before)}${digits}`
  const rest = digits.slice(before)
  return `${sign}${digits.slice(0, before).padEnd(before, '0')}${rest && `.${rest}`}`
}

const FORMS: Readonly<Record<string, (value: number, digits: number | null) => string>> = {
  f: (value, digits) => (digits === null ? plain(value.toExponential()) : fixed(value, digits)),
  e: (value, digits) => (digits === null ? value.toExponential().replace('e+', 'e') : scientific(value, digits)),
  p: (value, digits) => plain(scientific(value, digits ?? 0)),
  // As Rust's programmers see it: always with a point or an exponent.
  d: (value) => {
    const size = Math.abs(value)
    if (size !== 0 && (size < 1e-5 || size >= 1e16)) return value.toExponential().replace('e+', 'e')
    const text = plain(value.toExponential())
    return text.includes('.') ? text : `${text}.0`
  },
}

function written(form: string, digits: number | null, bits: string): string {
  const value = doubleOf(bits)
  if (Number.isNaN(value)) return 'NaN'
  if (!Number.isFinite(value)) return value < 0 ? '-inf' : 'inf'
  const text = FORMS[form]?.(value, digits) ?? String(value)
  return Object.is(value, -0) ? `-${text.replace('-', '')}` : text
}

/** Marks of a number of the core, and of one of the fit with its form. */
const OF_CORE = new RegExp(`${'\u0001'}([0-9a-f]{16})`, 'g')
const OF_FIT = new RegExp(`${'\u0002'}([fdep])(\\d\\d)([0-9a-f]{16})`, 'g')

/** A text with its numbers written. */
export const withDigits = (text: string): string =>
  text
    .replace(OF_CORE, (_, bits: string) => written('d', null, bits))
    .replace(OF_FIT, (_, form: string, digits: string, bits: string) =>
      written(form, digits === '99' ? null : Number(digits), bits),
    )
