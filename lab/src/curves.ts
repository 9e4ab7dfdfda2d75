// The curves that can be drawn beside the exact motion: their names, what each takes, and the family that clothes it.
//
// Names are those of libration's registries (NOTATION.md, docs/approximations.md), and `rk45` for SciPy's solve_ivp at
// its defaults. A curve is written `linear`, `fourier:4`, `rk4:0.025`: the name, then the order or the step in s.

/** Colour and dash belong to a family in every view, theme and export. */
export type Family =
  | 'exact'
  | 'linear'
  | 'harmonic'
  | 'fourier'
  | 'trigonometric'
  | 'polynomial'
  | 'integrator'
  | 'euler'

/** What follows the colon: a number of terms or a degree, or a step in s. */
export interface Argument {
  readonly of: 'order' | 'step'
  readonly least: number
  readonly most: number
  readonly usual: number
}

interface CurveKind {
  readonly family: Family
  readonly argument?: Argument
  /** Whether it goes step by step in time, so that its energy may drift. */
  readonly numerical: boolean
}

const order = (least: number, most: number, usual: number): Argument => ({ of: 'order', least, most, usual })
const step: Argument = { of: 'step', least: 0.0001, most: 1, usual: 0.025 }
const formula = (family: Family, argument?: Argument): CurveKind =>
  argument ? { family, argument, numerical: false } : { family, numerical: false }
const scheme = (family: Family, argument?: Argument): CurveKind =>
  argument ? { family, argument, numerical: true } : { family, numerical: true }

export const KINDS = {
  linear: formula('linear'),
  harmonic: formula('harmonic'),
  fourier: formula('fourier', order(1, 50, 4)),
  'fourier-theta': formula('fourier', order(1, 50, 2)),
  trigonometric: formula('trigonometric'),
  'small-m': formula('polynomial'),
  'small-m-bounded': formula('polynomial'),
  cubic: formula('polynomial'),
  'cubic-quintic': formula('polynomial'),
  taylor: formula('polynomial', order(1, 100, 8)),
  rk45: scheme('integrator'),
  rk4: scheme('integrator', step),
  verlet: scheme('integrator', step),
  'euler-cromer': scheme('euler', step),
  euler: scheme('euler', step),
} as const satisfies Record<string, CurveKind>

export type CurveName = keyof typeof KINDS
export const CURVE_NAMES = Object.keys(KINDS) as CurveName[]

export interface Curve {
  readonly name: CurveName
  /** Order or step, where the kind takes one. */
  readonly argument?: number
  readonly on: boolean
}

export function kindOf(name: CurveName): CurveKind {
  return KINDS[name]
}

export function isCurveName(name: string): name is CurveName {
  return Object.hasOwn(KINDS, name)
}

/** As it stands in the list when it is added. */
export function usualCurve(name: CurveName): Curve {
  const { argument } = kindOf(name)
  return argument ? { name, argument: argument.usual, on: true } : { name, on: true }
}

/** `fourier:4`. Two curves of one list differ in it. */
export function curveKey(curve: Curve): string {
  return curve.argument === undefined ? curve.name : `${curve.name}:${curve.argument}`
}
