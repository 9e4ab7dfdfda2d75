// Whether the second module of the core is there, and which curves wait for it.

/** Formulas of the angle in the second module of the core, which has those of the period and the elliptic functions too. */
const SECOND: readonly string[] = ['small-m', 'small-m-bounded', 'cubic', 'cubic-quintic']
let loaded = false

export const secondLoaded = (): boolean => loaded

export function secondIsLoaded(): void {
  loaded = true
}

export const needsSecond = (curve: string): boolean => SECOND.includes(curve)
