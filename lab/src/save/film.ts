// The instants of a film and the exact motion at them: frame i is the motion at from + i/perSecond.
//
// A film of a period has a whole number N of frames in it, N/T in a second of the motion: frame N would be frame 0 again, so that
// it repeats without a seam.

import type { Motion } from '../model'
import type { Window } from '../study'

export const WIDTHS = [320, 480, 720, 1080] as const
export const RATES = [10, 20, 25, 30, 50] as const
/** Below, nothing seems to move; above, the files are too large for a slide. */
export const FEWEST = 12
export const MOST = 2000

interface FilmChoice {
  /** One period, or the time that the plots show. */
  readonly of: 'period' | Window
  /** Frames in a second of the film, at most. */
  readonly rate: number
  /** Seconds of the motion in a second of the film. */
  readonly speed: number
}

export interface Film {
  /** Frames in a second of the motion. */
  readonly perSecond: number
  readonly times: Float64Array
  readonly theta: Float64Array
  readonly velocity: Float64Array
  /** How long it lasts, in s. */
  readonly seconds: number
  readonly repeats: boolean
}

/** Why there is no film, and how many frames it would have. */
export interface FilmRefusal {
  readonly refused: 'rest' | 'separatrix' | 'few' | 'many'
  readonly frames: number
}

export function filmOf(motion: Motion, { of, rate, speed }: FilmChoice): Film | FilmRefusal {
  if (motion.regime === 'rest') return { refused: 'rest', frames: 0 }
  if (of === 'period' && !Number.isFinite(motion.period)) return { refused: 'separatrix', frames: 0 }
  const from = of === 'period' ? 0 : of.from
  const span = of === 'period' ? motion.period : of.to - of.from
  const seconds = span / speed
  // Not more often than the rate: what shows a GIF waits for at least two hundredths of a second.
  const frames = Math.floor(seconds * rate * (1 + 1e-12))
  if (frames < FEWEST) return { refused: 'few', frames }
  if (frames > MOST) return { refused: 'many', frames }
  const perSecond = frames / span
  const times = Float64Array.from({ length: frames }, (_, i) => from + i / perSecond)
  const { theta, velocity } = motion.sample(times)
  return { perSecond, times, theta, velocity, seconds, repeats: of === 'period' }
}

/** How long each frame of a GIF is shown, in hundredths of a second: together as long as the film, to the nearest. */
export function delaysOf({ times, seconds }: Pick<Film, 'times' | 'seconds'>): number[] {
  const until = (i: number) => Math.round((100 * seconds * i) / times.length)
  return Array.from(times, (_, i) => until(i + 1) - until(i))
}

/** Where the frames go, one after the other. */
export interface Sink {
  readonly ending: 'gif' | 'mp4' | 'webm'
  readonly type: string
  add(canvas: HTMLCanvasElement, frame: number): Promise<void>
  finish(): Promise<Uint8Array<ArrayBuffer>>
  /** Ends it early; nothing is left running. */
  close(): void
}

/** Paints and adds frame after frame; the page works on in between. Rejects when the signal says so. */
export async function makeFilm(
  film: Film,
  canvas: HTMLCanvasElement,
  painted: (frame: number) => Promise<void>,
  sink: Sink,
  tell: (done: number) => void,
  signal: AbortSignal,
): Promise<Uint8Array<ArrayBuffer>> {
  try {
    for (let i = 0; i < film.times.length; i++) {
      signal.throwIfAborted()
      await painted(i)
      await sink.add(canvas, i)
      tell(i + 1)
      // Another task, so that keys and the pointer come in between.
      await new Promise((done) => setTimeout(done, 0))
    }
    signal.throwIfAborted()
    return await sink.finish()
  } catch (error) {
    sink.close()
    throw error
  }
}
