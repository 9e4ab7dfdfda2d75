// What each curve wears: the class of its family, and a longer dash for the second and third of one family.

import { type Curve, type Family, kindOf } from '../curves'

const ORDINALS = ['', 'second', 'third'] as const

/** The classes of `.c` for every curve of a list, in its order. */
export function clothesOf(curves: readonly Curve[]): string[] {
  const seen = new Map<Family, number>()
  return curves.map((curve) => {
    const { family } = kindOf(curve.name)
    const before = seen.get(family) ?? 0
    seen.set(family, before + 1)
    return `c-${family} ${ORDINALS[Math.min(before, ORDINALS.length - 1)]}`.trim()
  })
}

/** The colour of clothes, as a CSS value. */
export function colourOf(clothes: string): string {
  return `var(--${clothes.split(' ')[0]})`
}
