// The state as the hash of a link, and back: readable, edited by hand, and each bad value is named and replaced.
//
// `#v=1&th0=150deg&L=1m&g=9.81&curves=linear,harmonic,fourier:4,rk45&t=2.4s`. What is as by default is left out, but for
// what makes the picture. Keys that are not known are reported, and kept in the link that is written next.

import { type Curve, curveKey, isCurveName, kindOf, usualCurve } from './curves'
import { coded, fromCode, saysNothing, shownViews } from './embedding'
import { angleText, parseNumber, parseQuantity, type Unit } from './number'
import { baseOf, readPeriod } from './periods'
import {
  CODES,
  curveFault,
  DATA_FROM,
  DEFAULTS,
  ENTRIES,
  type Fault,
  HANDOUTS,
  inRange,
  LANGUAGES,
  LETTERS,
  LOCKS,
  MOST_CURVES,
  MOST_ORBITS,
  MOST_STEPS,
  PAPERS,
  RANGES,
  type RangeName,
  SHOWN,
  SPRING_KINDS,
  type Start,
  type State,
  THEMES,
  VIEWS,
} from './state'

const VERSION = '1'

export interface Opened {
  readonly state: State
  readonly faults: readonly Fault[]
  /** Pairs that are not ours, as they were. */
  readonly kept: readonly (readonly [string, string])[]
  /** Keys that the link gave and that hold. */
  readonly given: ReadonlySet<string>
}

type Value<K extends keyof State> = State[K] | Fault
interface Key<K extends keyof State> {
  readonly of: K
  readonly read: (text: string, name: string) => Value<K>
  readonly write: (value: State[K], state: State) => string
  /** Written even if it is the default. */
  readonly always?: boolean
}

const isFault = (value: unknown): value is Fault => typeof value === 'object' && value !== null && 'kind' in value

function quantity<K extends RangeName>(of: K, write: (value: number) => string, always = false) {
  const read = (text: string, name: string): number | Fault => {
    const value = parseQuantity(text, RANGES[of].unit satisfies Unit)
    if (Number.isNaN(value)) return { kind: 'not-a-number', name, value: text }
    return inRange(of, value) ? value : { kind: 'out-of-range', name: of, value: text }
  }
  return { of, read, write, always }
}

function choice<K extends keyof State, const V extends string>(of: K, allowed: readonly V[]) {
  const read = (text: string, name: string): V | Fault => {
    const found = allowed.find((each) => each.toLowerCase() === text.toLowerCase())
    return found ?? { kind: 'not-one-of', name, value: text, allowed }
  }
  return { of, read, write: (value: unknown) => String(value) }
}

/** Yes or no, as 1 or 0, or as a word that stands for yes. */
function flag<K extends keyof State>(of: K, yes = '1') {
  const read = (text: string, name: string): boolean | Fault => {
    const found = [yes, '0'].indexOf(text)
    return found < 0 ? { kind: 'not-one-of', name, value: text, allowed: [yes, '0'] } : found === 0
  }
  return { of, read, write: (value: unknown) => (value ? yes : '0') }
}

/** Names, by commas. */
function names<K extends keyof State, const V extends string>(of: K, allowed: readonly V[]) {
  const read = (text: string, name: string): readonly V[] | Fault => {
    const parts = text.split(',').filter((each) => each !== '')
    const wrong = parts.find((each) => !allowed.includes(each as V))
    return wrong === undefined
      ? allowed.filter((each) => parts.includes(each))
      : { kind: 'not-one-of', name, value: wrong, allowed }
  }
  return { of, read, write: (value: unknown) => String(value) }
}

/** The quantity of the first plot stands among the views and parts that are shown. */
const QUANTITIES = ['angle', 'velocity'] as const
const writeShow = (value: State['show'], { quantity }: State): string =>
  [...(quantity === 'velocity' ? [quantity] : []), ...value].join(',')

/** Gravity, in words or not to be read at a glance. */
function readGravity(text: string, name: string): number | Fault {
  const value = text.startsWith('~') ? fromCode(text) : Number.NaN
  return inRange('gravity', value) ? value : quantity('gravity', String).read(text, name)
}

function readSeed(text: string, name: string): number | Fault {
  const value = parseNumber(text)
  if (Number.isNaN(value)) return { kind: 'not-a-number', name, value: text }
  if (!inRange('seed', value)) return { kind: 'out-of-range', name: 'seed', value: text }
  return Number.isInteger(value) ? value : { kind: 'not-whole', name, value: text }
}

/** A curve as it is written, or what is wrong with it. */
function readCurve(text: string, on: boolean): Curve | Fault {
  const [name = '', given, ...rest] = text.split(':')
  const known = name === 'solve_ivp' ? 'rk45' : name
  if (!isCurveName(known) || rest.length > 0) return { kind: 'unknown', name: 'curves', value: text }
  const usual = { ...usualCurve(known), on }
  if (given === undefined) return usual
  if (!kindOf(known).argument) return { kind: 'unknown', name: 'curves', value: text }
  const argument = parseNumber(given)
  if (Number.isNaN(argument)) return { kind: 'not-a-number', name: known, value: given }
  const curve = { ...usual, argument }
  return curveFault(curve) ?? curve
}

function readCurves(text: string): State['curves'] | Fault {
  const curves: Curve[] = []
  for (const part of text.split(',').filter((each) => each !== '')) {
    const curve = readCurve(part.replace(/^!/, ''), !part.startsWith('!'))
    if (isFault(curve)) return curve
    if (curves.some((each) => curveKey(each) === curveKey(curve))) return { kind: 'twice', name: 'curves', value: part }
    curves.push(curve)
  }
  const drawn = curves.filter((each) => each.on).length
  return drawn > MOST_CURVES ? { kind: 'too-many', name: 'curves', value: String(drawn), most: MOST_CURVES } : curves
}

const writeCurves = (curves: State['curves']): string =>
  curves.map((curve) => (curve.on ? '' : '!') + curveKey(curve)).join(',')

/** `60deg` or `0deg;7.5`: angle, then velocity. */
function readOrbits(text: string): State['orbits'] | Fault {
  const orbits: Start[] = []
  for (const part of text.split(',').filter((each) => each !== '')) {
    const [angle = '', velocity = '0'] = part.split(';')
    const theta0 = parseQuantity(angle, 'deg')
    const velocity0 = parseQuantity(velocity, 'rad/s')
    if (Number.isNaN(theta0) || Number.isNaN(velocity0)) return { kind: 'not-a-number', name: 'orbits', value: part }
    if (!inRange('theta0', theta0)) return { kind: 'out-of-range', name: 'theta0', value: angle }
    if (!inRange('velocity0', velocity0)) return { kind: 'out-of-range', name: 'velocity0', value: velocity }
    orbits.push({ theta0, velocity0 })
  }
  const most = MOST_ORBITS - 1
  return orbits.length > most ? { kind: 'too-many', name: 'orbits', value: String(orbits.length), most } : orbits
}

const writeOrbits = (orbits: State['orbits']): string =>
  orbits.map(({ theta0, velocity0 }) => angleText(theta0) + (velocity0 === 0 ? '' : `;${velocity0}`)).join(',')

function readLetter(text: string, name: string): number | Fault {
  const at = LETTERS.indexOf(text.toUpperCase())
  return text.length === 1 && at >= 0 ? at : { kind: 'not-one-of', name, value: text, allowed: [...LETTERS] }
}

function readStep(text: string, name: string): number | Fault {
  const value = parseNumber(text)
  const allowed = Array.from({ length: MOST_STEPS }, (_, i) => String(i + 1))
  return allowed.includes(String(value)) ? value : { kind: 'not-one-of', name, value: text, allowed }
}

function readPeriods(text: string): State['periods'] | Fault {
  const keys: string[] = []
  for (const part of text === 'none' ? [] : text.split(',').filter((each) => each !== '')) {
    const key = readPeriod(part)
    if (isFault(key)) return key
    if (keys.some((each) => baseOf(each) === baseOf(key))) return { kind: 'twice', name: 'periods', value: part }
    keys.push(key)
  }
  return keys
}

function readSpan(text: string): State['span'] | Fault {
  if (text === 'T' || text === '1T') return 'T'
  const value = parseQuantity(text, 's')
  if (Number.isNaN(value)) return { kind: 'not-a-number', name: 'span', value: text }
  return inRange('span', value) ? value : { kind: 'out-of-range', name: 'span', value: text }
}

const KEYS = {
  view: choice('view', VIEWS),
  th0: quantity('theta0', angleText, true),
  w0: quantity('velocity0', String),
  L: quantity('length', (value) => `${value}m`, true),
  g: {
    of: 'gravity',
    read: readGravity,
    write: (value: number, { hide }: State) => (hide ? coded(value) : String(value)),
    always: true,
  },
  curves: { of: 'curves', read: readCurves, write: writeCurves, always: true },
  t: quantity('t', (value) => `${value}s`),
  span: { of: 'span', read: readSpan, write: (value: State['span']) => (value === 'T' ? 'T' : `${value}s`) },
  speed: quantity('speed', String),
  show: { of: 'show', read: names('show', [...QUANTITIES, ...SHOWN]).read, write: writeShow },
  error: choice('errorAxis', ['auto', 'log', 'linear']),
  unit: choice('errorUnit', ['percent', 'degrees']),
  energy: choice('energy', ['auto', 'total', 'parts']),
  orbits: { of: 'orbits', read: readOrbits, write: writeOrbits },
  orbit: { of: 'orbit', read: readLetter, write: (value: number) => LETTERS[value] ?? 'A' },
  periods: {
    of: 'periods',
    read: readPeriods,
    write: (value: State['periods']) => (value === null ? '' : value.join(',') || 'none'),
  },
  axis: choice('periodAxis', ['log', 'linear']),
  sort: choice('periodOrder', ['registry', 'error']),
  entry: choice('entry', ENTRIES),
  step: { of: 'step', read: readStep, write: String },
  from: choice('from', DATA_FROM),
  spring: choice('spring', SPRING_KINDS),
  p: quantity('p', String),
  r: quantity('r', String),
  q: quantity('q', String),
  c: quantity('c', String),
  s: quantity('s', String),
  u0: quantity('u0', String),
  v0: quantity('springVelocity0', String),
  linear: quantity('linear', String),
  quadratic: quantity('quadratic', String),
  dry: quantity('dry', String),
  torque: quantity('torque', String),
  drive: quantity('drive', String),
  omega: quantity('driveFrequency', String),
  until: quantity('until', (value) => `${value}s`),
  lang: choice('language', ['auto', ...LANGUAGES]),
  theme: choice('theme', THEMES),
  handout: choice('handout', HANDOUTS),
  seed: { of: 'seed', read: readSeed, write: String },
  key: flag('key'),
  paper: choice('paper', PAPERS),
  code: choice('code', CODES),
  embed: flag('embed'),
  lock: names('lock', LOCKS),
  hide: flag('hide', 'g'),
} as const

type KeyName = keyof typeof KEYS
const KEY_NAMES = Object.keys(KEYS) as KeyName[]

const keyOf = (name: KeyName) => KEYS[name] as unknown as Key<keyof State>

/** What a link says; never throws. */
export function readLink(hash: string): Opened {
  const values: Partial<Record<keyof State, unknown>> = {}
  const faults: Fault[] = []
  const kept: (readonly [string, string])[] = []
  const given = new Set<string>()
  const seen = new Set<string>()
  let unread = false
  for (const pair of hash.replace(/^#/, '').split('&')) {
    if (pair === '') continue
    const at = pair.indexOf('=')
    const name = decoded(at < 0 ? pair : pair.slice(0, at))
    const text = decoded(at < 0 ? '' : pair.slice(at + 1))
    if (seen.has(name)) {
      faults.push({ kind: 'twice', name, value: text })
      continue
    }
    seen.add(name)
    if (name === 'v') {
      if (text !== VERSION) faults.push({ kind: 'not-one-of', name, value: text, allowed: [VERSION] })
    } else if (!Object.hasOwn(KEYS, name)) {
      faults.push({ kind: 'unknown', name, value: text })
      kept.push([name, text])
    } else {
      const key = keyOf(name as KeyName)
      const value = key.read(text, name)
      if (isFault(value)) faults.push(value)
      else {
        values[key.of] = value
        given.add(name)
        // Where g is not to be read, it is hidden.
        unread ||= name === 'g' && text.startsWith('~')
      }
    }
  }
  const show = (values.show ?? []) as readonly string[]
  if (show.includes('velocity')) values.quantity = 'velocity'
  values.show = SHOWN.filter((each) => show.includes(each))
  if (unread) values.hide = true
  return { state: agreed({ ...DEFAULTS, ...values } as State, faults, given), faults, kept, given }
}

/** The state with what its view and span may be where parts are shown or g is hidden. */
function agreed(state: State, faults: Fault[], given: ReadonlySet<string>): State {
  if (state.hide && state.show.length > 0 && !state.show.some(saysNothing)) {
    const allowed = SHOWN.filter(saysNothing)
    faults.push({ kind: 'not-one-of', name: 'show', value: String(state.show), allowed })
    return agreed({ ...state, show: [] }, faults, given)
  }
  const views = shownViews(state)
  const view = views.includes(state.view) ? state.view : (views[0] ?? 'lab')
  if (view !== state.view && given.has('view'))
    faults.push({ kind: 'not-one-of', name: 'view', value: state.view, allowed: views })
  // The plot of one period would be as good as its number.
  return { ...state, view, span: state.hide && state.span === 'T' ? DEFAULTS.span : state.span }
}

/** The hash of a state; what is not ours is put behind it as it was. */
export function writeLink(state: State, kept: Opened['kept'] = []): string {
  const pairs: [string, string][] = [['v', VERSION]]
  for (const name of KEY_NAMES) {
    const key = keyOf(name)
    const text = key.write(state[key.of], state)
    if (key.always || text !== key.write(DEFAULTS[key.of], DEFAULTS)) pairs.push([name, text])
  }
  return `#${[...pairs, ...kept].map(([name, text]) => `${encoded(name)}=${encoded(text)}`).join('&')}`
}

/** Only what a hash cannot hold is escaped, so that a person can read it. */
function encoded(text: string): string {
  return encodeURIComponent(text).replace(/%2C|%3A|%3B|%2F|%C2%B0/g, decodeURIComponent)
}

function decoded(text: string): string {
  try {
    return decodeURIComponent(text)
  } catch {
    return text
  }
}
