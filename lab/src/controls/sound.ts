// Numbers as sound, after Desmos: pitch is the value, the pan goes from left to right, below zero the tone is rough.

export interface Trace {
  readonly values: Float64Array
  readonly low: number
  readonly high: number
}

export const SECONDS = 4
const LOWEST = 130.8
const OCTAVES = 2.5
const STEPS = 400

/** Frequency in Hz of each of so many steps; NaN where there is no value. Extremes of the pitch are those of the values. */
export function pitches({ values, low, high }: Trace, steps = STEPS): Float64Array {
  const range = high > low ? high - low : 1
  return Float64Array.from({ length: steps + 1 }, (_, i) => {
    const at = Math.round((i * (values.length - 1)) / steps)
    const part = ((values[at] as number) - low) / range
    return LOWEST * 2 ** (OCTAVES * Math.min(1, Math.max(0, part)))
  })
}

/** Puts the trace into an audio graph, so that a test can render it without a loudspeaker. */
function connect(context: BaseAudioContext, trace: Trace, start: number): OscillatorNode[] {
  const frequencies = pitches(trace)
  const smooth = context.createOscillator()
  const rough = context.createOscillator()
  smooth.type = 'sine'
  rough.type = 'sawtooth'
  const loud = context.createGain()
  const hoarse = context.createGain()
  const pan = context.createStereoPanner()
  loud.gain.setValueAtTime(0, start)
  hoarse.gain.setValueAtTime(0, start)
  smooth.connect(loud).connect(pan)
  rough.connect(hoarse).connect(pan)
  pan.connect(context.destination)
  pan.pan.setValueAtTime(-1, start)
  pan.pan.linearRampToValueAtTime(1, start + SECONDS)
  const { values } = trace
  frequencies.forEach((frequency, i) => {
    const when = start + (SECONDS * i) / (frequencies.length - 1)
    const value = values[Math.round((i * (values.length - 1)) / (frequencies.length - 1))] as number
    const there = Number.isFinite(frequency)
    if (there) {
      smooth.frequency.linearRampToValueAtTime(frequency, when)
      rough.frequency.linearRampToValueAtTime(frequency, when)
    }
    loud.gain.linearRampToValueAtTime(there ? 0.18 : 0, when)
    hoarse.gain.linearRampToValueAtTime(there && value < 0 ? 0.035 : 0, when)
  })
  const end = start + SECONDS
  loud.gain.linearRampToValueAtTime(0, end + 0.05)
  hoarse.gain.linearRampToValueAtTime(0, end + 0.05)
  for (const each of [smooth, rough]) {
    each.start(start)
    each.stop(end + 0.1)
  }
  return [smooth, rough]
}

/** Plays it; the result stops it. */
export function play(trace: Trace, ended: () => void): () => void {
  const context = new AudioContext()
  const [first] = connect(context, trace, context.currentTime + 0.05)
  const close = () => {
    if (context.state !== 'closed') void context.close()
  }
  first?.addEventListener('ended', () => {
    close()
    ended()
  })
  return close
}
