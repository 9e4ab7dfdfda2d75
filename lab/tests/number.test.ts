// Numbers as they are typed, and angles in degrees to the last bit.

import { describe, expect, it } from 'vitest'
import { angleText, degrees, parseNumber, parseQuantity, radians } from '../src/number'

describe('a typed number', () => {
  it.each([
    ['9.81', 9.81],
    ['9,81', 9.81],
    ['−3', -3],
    ['+.5', 0.5],
    ['5.', 5],
    ['1e-3', 0.001],
    [' 1 000 ', 1000],
  ])('%s is read', (text, value) => expect(parseNumber(text)).toBe(value))

  it.each(['', ' ', '-', '1.2.3', '1,2,3', 'abc', '0x10', 'Infinity', 'NaN', '1e', '--1'])('%s is none', (text) =>
    expect(parseNumber(text)).toBeNaN(),
  )
})

describe('a quantity', () => {
  it.each([
    ['70cm', 'm', 0.7],
    ['700 mm', 'm', 0.7],
    ['0,7', 'm', 0.7],
    ['9,81 m/s²', 'm/s2', 9.81],
    ['180°', 'deg', Math.PI],
    ['3 rad', 'deg', 3],
    ['250ms', 's', 0.25],
  ] as const)('%s', (text, unit, value) => expect(parseQuantity(text, unit)).toBe(value))

  it.each([
    ['1 kg', 'm'],
    ['1 s', 'm'],
    ['deg', 'deg'],
  ] as const)('%s in %s is none', (text, unit) => expect(parseQuantity(text, unit)).toBeNaN())
})

describe('degrees', () => {
  // From Python's decimal with 60 digits of pi: the doubles nearest to n pi/180.
  it.each([
    [1, 0.017453292519943295],
    [29, 0.5061454830783556],
    [57.3, 1.0000736613927508],
    [150, 2.6179938779914944],
    [157.5, 2.748893571891069],
    [171, 2.9845130209103035],
    [179.999, 3.141575200297273],
    [180, Math.PI],
  ])('%f are rounded once', (value, expected) => expect(radians(value)).toBe(expected))

  it('come back as they were typed', () => {
    for (let tenth = -1800; tenth <= 1800; tenth++) {
      expect(degrees(radians(tenth / 10))).toBe(tenth / 10)
      expect(angleText(radians(tenth / 10))).toBe(`${tenth / 10}deg`)
    }
  })

  it('of an angle that is none of them are left as radians', () => {
    expect(angleText(3)).toBe('3rad')
    expect(parseQuantity(angleText(1 / 3), 'deg')).toBe(1 / 3)
  })
})
