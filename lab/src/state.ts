// The state of the page: one plain object, its defaults, and what each value may be. SI units and radians.
//
// Everything that a link carries stands here and nothing else; what passes with the visit is the session's (store.ts).

import { CURVE_NAMES, type Curve, curveKey, kindOf } from './curves'
import { radians, type Unit } from './number'

export const VIEWS = [
  'lab',
  'phase',
  'period',
  'functions',
  'derivation',
  'springs',
  'friction',
  'data',
  'handouts',
] as const
export type ViewName = (typeof VIEWS)[number]
/** Ways through the derivation, and most steps of one. */
export const ENTRIES = ['novice', 'lima', 'salas'] as const
export type EntryName = (typeof ENTRIES)[number]
export const MOST_STEPS = 9
/** What the view Data begins from. */
export const DATA_FROM = ['file', 'period'] as const
export const LANGUAGES = ['en', 'pt-BR', 'es'] as const
export type Language = (typeof LANGUAGES)[number]
export const THEMES = ['auto', 'light', 'dark'] as const
export type Theme = (typeof THEMES)[number]
export const HANDOUTS = ['worksheet', 'code', 'embed'] as const
export const PAPERS = ['A4', 'Letter'] as const
export const CODES = ['scipy', 'mpmath', 'libration', 'octave', 'r', 'mathematica'] as const
export type Code = (typeof CODES)[number]
/** Parts of the Lab that can be shown alone. */
export const SECTIONS = [
  'pendulum',
  'values',
  'facts',
  'motion',
  'error',
  'energy',
  'curves',
  'portrait',
  'play',
] as const
export const SHOWN = [...VIEWS, ...SECTIONS] as const
export type Shown = (typeof SHOWN)[number]
/** What can be locked, by its key in a link, and what it is in the state. */
export const LOCKED = { th0: 'theta0', w0: 'velocity0', L: 'length', g: 'gravity', curves: 'curves' } as const
export type Lock = keyof typeof LOCKED
export const LOCKS = Object.keys(LOCKED) as Lock[]

export const SPRING_KINDS = ['duffing', 'helmholtz-duffing', 'cubic-quintic'] as const
export type SpringKind = (typeof SPRING_KINDS)[number]

/** Where a motion begins. */
export interface Start {
  readonly theta0: number
  readonly velocity0: number
}

/** What acts on the pendulum besides gravity. */
export interface FrictionAndTorque {
  /** Friction: γ, β and μ. */
  readonly linear: number
  readonly quadratic: number
  readonly dry: number
  /** Torque: constant, and amplitude and frequency of what drives it. */
  readonly torque: number
  readonly drive: number
  readonly driveFrequency: number
}

export interface State extends Start, FrictionAndTorque {
  readonly view: ViewName
  readonly length: number
  readonly gravity: number
  readonly curves: readonly Curve[]
  /** Time shown, in s. */
  readonly t: number
  readonly speed: number
  /** What the plots show: one period, or as many seconds. */
  readonly span: number | 'T'
  readonly quantity: 'angle' | 'velocity'
  readonly errorAxis: 'auto' | 'log' | 'linear'
  readonly errorUnit: 'percent' | 'degrees'
  readonly energy: 'auto' | 'total' | 'parts'
  /** Orbits of the portrait beside that of theta0 and velocity0. */
  readonly orbits: readonly Start[]
  /** Place of theta0 and velocity0 among the letters of the portrait: 0 is A. */
  readonly orbit: number
  /** Formulas of the period that are drawn, by their names in the registry; null is the usual choice. */
  readonly periods: readonly string[] | null
  readonly periodAxis: 'log' | 'linear'
  /** How the list of formulas is sorted: as the registry, or by the error at the amplitude. */
  readonly periodOrder: 'registry' | 'error'
  readonly entry: EntryName
  /** Step of the derivation, from 1 on. */
  readonly step: number
  readonly from: (typeof DATA_FROM)[number]
  /** The spring u″ + p u (+ r u²) + q u³ (+ s u⁵) = 0 (or c) and its start. */
  readonly spring: SpringKind
  readonly p: number
  readonly r: number
  readonly q: number
  readonly c: number
  readonly s: number
  readonly u0: number
  readonly springVelocity0: number
  /** Seconds of the motion with friction. */
  readonly until: number
  readonly language: Language | 'auto'
  readonly theme: Theme
  readonly handout: (typeof HANDOUTS)[number]
  /** Of the numbers of the worksheet. */
  readonly seed: number
  /** Whether the worksheet has its answers. */
  readonly key: boolean
  readonly paper: (typeof PAPERS)[number]
  readonly code: Code
  /** In a page of others: without the bar. */
  readonly embed: boolean
  /** Values that stay as the sender set them. */
  readonly lock: readonly Lock[]
  /** Views and parts that are shown; none named is all. */
  readonly show: readonly Shown[]
  /** Whether gravity is hidden. */
  readonly hide: boolean
}

export const DEFAULTS: State = {
  view: 'lab',
  theta0: radians(150),
  velocity0: 0,
  length: 1,
  gravity: 9.81,
  curves: [
    { name: 'linear', on: true },
    { name: 'harmonic', on: true },
    { name: 'fourier', argument: 4, on: true },
    { name: 'rk45', on: true },
  ],
  t: 0,
  speed: 1,
  span: 8,
  quantity: 'angle',
  errorAxis: 'auto',
  errorUnit: 'percent',
  energy: 'auto',
  orbits: [
    { theta0: radians(60), velocity0: 0 },
    { theta0: 0, velocity0: 7.5 },
  ],
  orbit: 0,
  periods: null,
  periodAxis: 'log',
  periodOrder: 'registry',
  entry: 'novice',
  step: 1,
  from: 'file',
  spring: 'duffing',
  p: 1,
  r: 0,
  q: -0.5,
  c: 0,
  s: 0,
  u0: 1.2,
  springVelocity0: 0,
  linear: 0.05,
  quadratic: 0,
  dry: 0,
  torque: 0,
  drive: 0,
  driveFrequency: 2,
  until: 30,
  language: 'auto',
  theme: 'auto',
  handout: 'worksheet',
  seed: 1,
  key: false,
  paper: 'A4',
  code: 'scipy',
  embed: false,
  lock: [],
  show: [],
  hide: false,
}

export const SPEEDS = [0.25, 0.5, 1, 2] as const
/** Curves drawn at once, the exact one apart. */
export const MOST_CURVES = 6
export const MOST_ORBITS = 6
/** What the orbits of the portrait are called. */
export const LETTERS = 'ABCDEF'

/** A number of the state, its unit, and what it may be. */
interface Range {
  readonly unit: Unit
  readonly least: number
  readonly most: number
}

export const RANGES = {
  theta0: { unit: 'deg', least: -Math.PI, most: Math.PI },
  velocity0: { unit: 'rad/s', least: -100, most: 100 },
  length: { unit: 'm', least: 0.001, most: 1000 },
  gravity: { unit: 'm/s2', least: 0.001, most: 1000 },
  t: { unit: 's', least: 0, most: 100_000 },
  speed: { unit: '', least: 0.01, most: 10 },
  span: { unit: 's', least: 0.1, most: 600 },
  seed: { unit: '', least: 1, most: 999_999 },
  p: { unit: '', least: -1e6, most: 1e6 },
  r: { unit: '', least: -1e6, most: 1e6 },
  q: { unit: '', least: -1e6, most: 1e6 },
  c: { unit: '', least: -1e6, most: 1e6 },
  s: { unit: '', least: -1e6, most: 1e6 },
  u0: { unit: '', least: -1000, most: 1000 },
  springVelocity0: { unit: '', least: -1e6, most: 1e6 },
  linear: { unit: '1/s', least: 0, most: 100 },
  quadratic: { unit: '1/rad', least: 0, most: 100 },
  dry: { unit: 'rad/s2', least: 0, most: 1000 },
  torque: { unit: 'rad/s2', least: -1000, most: 1000 },
  drive: { unit: 'rad/s2', least: 0, most: 1000 },
  driveFrequency: { unit: 'rad/s', least: 0.01, most: 1000 },
  until: { unit: 's', least: 1, most: 600 },
} as const satisfies Record<string, Range>

export type RangeName = keyof typeof RANGES

/** What is wrong with a value; the words are the language's. */
export type Fault =
  | { readonly kind: 'not-a-number'; readonly name: string; readonly value: string }
  | { readonly kind: 'out-of-range'; readonly name: RangeName; readonly value: string }
  | { readonly kind: 'not-one-of'; readonly name: string; readonly value: string; readonly allowed: readonly string[] }
  | { readonly kind: 'argument'; readonly value: string; readonly least: number; readonly most: number }
  | { readonly kind: 'too-many'; readonly name: 'curves' | 'orbits'; readonly value: string; readonly most: number }
  | { readonly kind: 'not-whole'; readonly name: string; readonly value: string }
  | { readonly kind: 'unknown'; readonly name: string; readonly value: string }
  | { readonly kind: 'twice'; readonly name: string; readonly value: string }

/** Whether a number may stand in the state; a millionth of a degree beyond the top is the top itself. */
export function inRange(name: RangeName, value: number): boolean {
  const range = RANGES[name]
  return value >= range.least && value <= range.most
}

/** What is wrong with a curve's argument. */
export function curveFault(curve: Curve): Fault | null {
  const { argument } = kindOf(curve.name)
  const given = curve.argument
  if (!argument || given === undefined) return null
  const whole = argument.of === 'step' || Number.isInteger(given)
  if (whole && given >= argument.least && given <= argument.most) return null
  return { kind: 'argument', value: curveKey(curve), least: argument.least, most: argument.most }
}

/** The list with one more curve, on while there is room. */
export function withCurve(curves: readonly Curve[], curve: Curve): readonly Curve[] {
  if (curves.some((each) => curveKey(each) === curveKey(curve))) return curves
  const room = curves.filter((each) => each.on).length < MOST_CURVES
  return [...curves, { ...curve, on: curve.on && room }]
}

/** Curves that the list lacks: a kind with an argument may stand there again with another one. */
export function missingCurves(curves: readonly Curve[]): typeof CURVE_NAMES {
  return CURVE_NAMES.filter((name) => kindOf(name).argument || !curves.some((each) => each.name === name))
}
