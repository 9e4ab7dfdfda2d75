// A film as GIF, by gifenc: one palette for all frames, so that what stands still does not flicker.

import { applyPalette, GIFEncoder, quantize } from 'gifenc/dist/gifenc.esm.js'
import { delaysOf, type Film, type Sink } from './film'

const COLOURS = 128
/** Frames of which the colours are taken. */
const SAMPLES = 6

function read(canvas: HTMLCanvasElement): Uint8ClampedArray {
  const context = canvas.getContext('2d') as CanvasRenderingContext2D
  return context.getImageData(0, 0, canvas.width, canvas.height).data
}

/** The colours of some frames; paper is exactly white. */
async function paletteOf(
  film: Film,
  canvas: HTMLCanvasElement,
  painted: (frame: number) => Promise<void>,
): Promise<number[][]> {
  const size = 4 * canvas.width * canvas.height
  const count = film.times.length
  const all = new Uint8ClampedArray(SAMPLES * size)
  for (let i = 0; i < SAMPLES; i++) {
    await painted(Math.floor((i * count) / SAMPLES))
    all.set(read(canvas), i * size)
  }
  return [[255, 255, 255], ...quantize(all, COLOURS - 2)]
}

/** What is as in the frame before is left to it: such stretches take next to no room. */
function changes(now: Uint8Array, before: Uint8Array | null, clear: number): Uint8Array {
  return before === null ? now : now.map((each, i) => (each === before[i] ? clear : each))
}

export async function gifSink(
  film: Film,
  canvas: HTMLCanvasElement,
  painted: (frame: number) => Promise<void>,
): Promise<Sink> {
  const palette = await paletteOf(film, canvas, painted)
  const delays = delaysOf(film)
  const clear = palette.length
  const gif = GIFEncoder()
  let before: Uint8Array | null = null
  return {
    ending: 'gif',
    type: 'image/gif',
    add: async (from, frame) => {
      const delay = 10 * (delays[frame] as number)
      const now = applyPalette(read(from), palette)
      gif.writeFrame(changes(now, before, clear), from.width, from.height, {
        delay,
        // Each frame is drawn over the one before.
        dispose: 1,
        ...(frame === 0
          ? { palette: [...palette, [0, 0, 0]], repeat: 0 }
          : { transparent: true, transparentIndex: clear }),
      })
      before = now
    },
    finish: async () => {
      gif.finish()
      return gif.bytes()
    },
    close: () => {},
  }
}
