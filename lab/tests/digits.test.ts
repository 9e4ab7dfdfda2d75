// Numbers in sentences have the digits that Rust gives them: the texts are those of Rust's `format!`.

import { describe, expect, it } from 'vitest'
import { withDigits } from '../src/model/digits'

const bits = (value: number): string =>
  new BigUint64Array(Float64Array.of(value).buffer)[0]?.toString(16).padStart(16, '0') ?? ''
const shown = (form: string, digits: number, value: number): string =>
  withDigits(`a \u0002${form}${String(digits).padStart(2, '0')}${bits(value)} b`).slice(2, -2)

describe('numbers in sentences', () => {
  it.each<readonly [string, number, number, string]>([
    ['f', 1, 0.25, '0.2'],
    ['f', 1, 0.75, '0.8'],
    ['f', 1, 0.35, '0.3'],
    ['f', 0, 2.5, '2'],
    ['f', 0, 3.5, '4'],
    ['f', 0, -2.5, '-2'],
    ['f', 2, 1.005, '1.00'],
    ['f', 4, 12345.678949, '12345.6789'],
    ['f', 1, -0.04, '-0.0'],
    ['f', 3, 1e22, '10000000000000000000000.000'],
    ['e', 1, 12.5, '1.2e1'],
    ['e', 1, 13.5, '1.4e1'],
    ['e', 2, 9.996e-5, '1.00e-4'],
    ['e', 0, 2.5e6, '2e6'],
    ['e', 2, 0, '0.00e0'],
    ['p', 2, 1.236, '1.24'],
    ['p', 2, 100, '100'],
    ['p', 5, 123456.7, '123457'],
    ['p', 5, 0.000123456789, '0.000123457'],
    ['p', 2, 9.876e22, '98800000000000000000000'],
    ['p', 2, 0, '0'],
    ['f', 99, 1e-7, '0.0000001'],
    ['f', 99, 0.1, '0.1'],
    ['f', 99, -3, '-3'],
    ['f', 99, 1.5e22, '15000000000000000000000'],
    ['d', 99, 3, '3.0'],
    ['d', 99, 1e-7, '1e-7'],
    ['d', 99, 1.25e16, '1.25e16'],
    ['f', 2, Number.NaN, 'NaN'],
    ['f', 2, Number.NEGATIVE_INFINITY, '-inf'],
  ])('%s with %d digits of %d is %s', (form, digits, value, text) => {
    expect(shown(form, digits, value)).toBe(text)
  })

  it('a number of the core is one as Rust shows it, and other text stays', () => {
    expect(withDigits(`mass = \u0001${bits(-1)}: must be positive`)).toBe('mass = -1.0: must be positive')
    expect(withDigits('nothing f020000000000000000')).toBe('nothing f020000000000000000')
  })
})
