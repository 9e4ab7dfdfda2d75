// From data to pixels and back: linear, logarithmic, and logarithmic on both sides of zero; and the numbers at their ticks.

export interface Scale {
  (value: number): number
  readonly invert: (pixel: number) => number
  /** The same for all values, times a factor. Without a call for each value, which would make an object of every number. */
  readonly fill: (out: Float64Array, values: Float64Array, factor: number) => void
  readonly low: number
  readonly high: number
  /** Tells scales that draw alike from others. */
  readonly key: string
}

export interface Tick {
  readonly value: number
  readonly text: string
}

function scaleBy(
  name: string,
  through: (value: number) => number,
  fillThrough: Scale['fill'],
  back: (value: number) => number,
  [low, high]: readonly [number, number],
  [from, to]: readonly [number, number],
): Scale {
  const start = through(low)
  const factor = (to - from) / (through(high) - start)
  const scale = (value: number) => from + factor * (through(value) - start)
  return Object.assign(scale, {
    invert: (pixel: number) => back(start + (pixel - from) / factor),
    fill: (out: Float64Array, values: Float64Array, times: number) => {
      fillThrough(out, values, times)
      for (let i = 0; i < values.length; i++) out[i] = from + factor * ((out[i] as number) - start)
    },
    low,
    high,
    key: `${name} ${low} ${high} ${from} ${to}`,
  })
}

type Ends = readonly [number, number]

export function linearScale(domain: Ends, pixels: Ends): Scale {
  const [low, high] = domain
  const [from, to] = pixels
  const factor = (to - from) / (high - low)
  const scale = (value: number) => from + factor * (value - low)
  return Object.assign(scale, {
    invert: (pixel: number) => low + (pixel - from) / factor,
    fill: (out: Float64Array, values: Float64Array, times: number) => {
      for (let i = 0; i < values.length; i++) out[i] = from + factor * ((values[i] as number) * times - low)
    },
    low,
    high,
    key: `linear ${low} ${high} ${from} ${to}`,
  })
}

export function logScale(domain: Ends, pixels: Ends): Scale {
  const fill: Scale['fill'] = (out, values, factor) => {
    for (let i = 0; i < values.length; i++) out[i] = Math.log10((values[i] as number) * factor)
  }
  return scaleBy('log', Math.log10, fill, (value) => 10 ** value, domain, pixels)
}

/** asinh(value/unit): linear up to about the unit, logarithmic beyond, with the sign kept. */
export function symmetricLogScale(unit: number, domain: Ends, pixels: Ends): Scale {
  const through = (value: number) => Math.asinh(value / unit)
  const fill: Scale['fill'] = (out, values, factor) => {
    for (let i = 0; i < values.length; i++) out[i] = Math.asinh(((values[i] as number) * factor) / unit)
  }
  return scaleBy(`asinh ${unit}`, through, fill, (value) => unit * Math.sinh(value), domain, pixels)
}

const SLACK = 1e-9

/** How many multiples of a step there are from low to high. */
function count(step: number, low: number, high: number): number {
  return Math.max(0, Math.floor(high / step + SLACK) - Math.ceil(low / step - SLACK) + 1)
}

/** They themselves, each the double nearest to its decimal. */
function multiples(step: number, low: number, high: number): number[] {
  const first = Math.ceil(low / step - SLACK)
  return Array.from({ length: count(step, low, high) }, (_, i) => Number(((first + i) * step).toPrecision(12)))
}

/** At most so many round numbers from low to high: multiples of 1, 2 or 5 times a power of ten. */
export function roundTicks(low: number, high: number, most: number): number[] {
  if (!(high > low)) return [low]
  let power = 10 ** Math.floor(Math.log10((high - low) / most))
  for (;;) {
    for (const digit of [1, 2, 5]) {
      if (count(digit * power, low, high) <= most) return multiples(digit * power, low, high)
    }
    power *= 10
  }
}

/** Multiples of 15, 30, 45, 90, 180, 360 … degrees, at most so many. */
export function degreeTicks(low: number, high: number, most: number): number[] {
  const steps = [0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 15, 30, 45, 90, 180, 360]
  for (let step = 720; steps.length < 40; step *= 2) steps.push(step)
  const step = steps.find((each) => count(each, low, high) <= most) ?? high - low
  return multiples(step, low, high)
}

/** −100, −10, −1, 0, 1, 10, 100: powers of ten on both sides of zero, fewer if there are too many. */
export function symmetricLogTicks(unit: number, high: number, most: number): number[] {
  const first = Math.ceil(Math.log10(unit) - 1e-9) + 1
  const last = Math.floor(Math.log10(high) + 1e-9)
  const side = Math.max(1, Math.floor((most - 1) / 2))
  const stride = Math.max(1, Math.ceil((last - first + 1) / side))
  const powers: number[] = []
  for (let exponent = last; exponent >= first; exponent -= stride) powers.push(10 ** exponent)
  if (powers.length === 0) powers.push(10 ** last)
  return [...powers.map((each) => -each), 0, ...powers.reverse()]
}

/** Decimals with which the numbers of an axis differ. */
export function tickDecimals(values: readonly number[]): number {
  const text = (value: number) => String(Number(value.toPrecision(12)))
  return Math.max(0, ...values.map((value) => text(value).split('e')[0]?.split('.')[1]?.length ?? 0))
}

/** The largest of 1, 2, 5 times a power of ten that is less than a pixel, so that a start is a short number and where the hand is. */
export function grainOf(perPixel: number): number {
  const power = 10 ** Math.floor(Math.log10(perPixel))
  return power * ([5, 2, 1].find((each) => each * power <= perPixel) ?? 1)
}

const ROUND = [1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10]

/** The first round number from a positive one on. */
export function roundUp(value: number): number {
  const power = 10 ** Math.floor(Math.log10(value))
  return power * (ROUND.find((each) => each * power >= value * (1 - 1e-12)) ?? 10)
}
