// Films as a browser shows them: where the bob is in some frames, by its colour; and the boxes of an MP4.

import type { Page } from '@playwright/test'
import { BOX, spot } from '../../src/draw/pendulum'
import { expect } from './lab'

export interface Place {
  readonly x: number
  readonly y: number
}

export interface Decoded {
  readonly width: number
  readonly height: number
  /** Frames, where the format counts them. */
  readonly frames: number
  /** Centre of the bob in the frames asked for. */
  readonly bobs: readonly Place[]
  /** Pixels of each of them as text, to be compared. */
  readonly pixels: readonly string[]
  /** How long each frame is shown, in hundredths of a second; of a GIF. */
  readonly delays: readonly number[]
}

/** What runs in the page: the centre of the brass-coloured disc, and all pixels in short. */
const READ = `(canvas) => {
  const { data, width } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height)
  let [n, x, y, sum] = [0, 0, 0, 0]
  for (let i = 0; i < data.length; i += 4) {
    const [r, g, b] = [data[i], data[i + 1], data[i + 2]]
    sum = (Math.imul(sum, 31) + r * 65536 + g * 256 + b) | 0
    if (Math.abs(r - 189) > 45 || Math.abs(g - 121) > 45 || b > 70) continue
    n++
    x += ((i / 4) % width) + 0.5
    y += Math.floor(i / 4 / width) + 0.5
  }
  return { bob: { x: x / n, y: y / n }, pixels: String(sum) }
}`

/** Frames of a GIF by the browser's own decoder. */
export async function decodedGif(page: Page, bytes: Buffer, frames: readonly number[]): Promise<Decoded> {
  return page.evaluate(
    async ({ text, wanted, read }) => {
      const reading = new Function(`return ${read}`)() as (canvas: OffscreenCanvas) => {
        bob: Place
        pixels: string
      }
      const data = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0))
      const decoder = new ImageDecoder({ data, type: 'image/gif' })
      await decoder.tracks.ready
      await decoder.completed
      const count = decoder.tracks.selectedTrack?.frameCount ?? 0
      const out = {
        width: 0,
        height: 0,
        frames: count,
        bobs: [] as Place[],
        pixels: [] as string[],
        delays: [] as number[],
      }
      const found = new Map<number, { bob: Place; pixels: string }>()
      for (let frameIndex = 0; frameIndex < count; frameIndex++) {
        const { image } = await decoder.decode({ frameIndex })
        out.width = image.displayWidth
        out.height = image.displayHeight
        out.delays.push((image.duration ?? 0) / 10_000)
        if (wanted.includes(frameIndex)) {
          const canvas = new OffscreenCanvas(out.width, out.height)
          canvas.getContext('2d')?.drawImage(image, 0, 0)
          found.set(frameIndex, reading(canvas))
        }
        image.close()
      }
      for (const frame of wanted) {
        const one = found.get(frame)
        if (!one) throw new Error(`no frame ${frame} of ${count}`)
        out.bobs.push(one.bob)
        out.pixels.push(one.pixels)
      }
      return out
    },
    { text: bytes.toString('base64'), wanted: [...frames], read: READ },
  )
}

/** Frames of a video by <video>, at the middle of the time for which each is shown. */
export async function decodedVideo(
  page: Page,
  bytes: Buffer,
  type: string,
  times: readonly number[],
): Promise<Omit<Decoded, 'frames' | 'delays'> & { readonly duration: number }> {
  return page.evaluate(
    async ({ text, kind, wanted, read }) => {
      const reading = new Function(`return ${read}`)() as (canvas: OffscreenCanvas) => {
        bob: Place
        pixels: string
      }
      const video = document.createElement('video')
      video.muted = true
      video.src = URL.createObjectURL(
        new Blob([Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0))], { type: kind }),
      )
      await new Promise((done, failed) => {
        video.onloadeddata = done
        video.onerror = () => failed(new Error(video.error?.message))
      })
      const bobs: Place[] = []
      const pixels: string[] = []
      for (const time of wanted) {
        // The frame of this time is there when it is presented; the first one may have been before.
        const presented = new Promise<void>((done) => {
          const look = (_: number, { mediaTime }: VideoFrameCallbackMetadata): void => {
            if (mediaTime <= time && time < mediaTime + 0.05) done()
            else video.requestVideoFrameCallback(look)
          }
          video.requestVideoFrameCallback(look)
        })
        const sought = new Promise((done) => {
          video.onseeked = done
        })
        video.currentTime = time
        await sought
        await Promise.race([presented, new Promise((done) => setTimeout(done, 3000))])
        const canvas = new OffscreenCanvas(video.videoWidth, video.videoHeight)
        canvas.getContext('2d')?.drawImage(video, 0, 0)
        const one = reading(canvas)
        bobs.push(one.bob)
        pixels.push(one.pixels)
      }
      const { videoWidth: width, videoHeight: height, duration } = video
      URL.revokeObjectURL(video.src)
      return { width, height, bobs, pixels, duration }
    },
    { text: bytes.toString('base64'), kind: type, wanted: [...times], read: READ },
  )
}

export interface Box {
  readonly type: string
  readonly body: Buffer
}

/** The boxes of an MP4, or of one of them. */
export function boxes(bytes: Buffer): Box[] {
  const out: Box[] = []
  for (let at = 0; at + 8 <= bytes.length; ) {
    const size = bytes.readUInt32BE(at)
    if (size < 8 || at + size > bytes.length) throw new Error(`a box of ${size} bytes at ${at} of ${bytes.length}`)
    out.push({ type: bytes.toString('latin1', at + 4, at + 8), body: bytes.subarray(at + 8, at + size) })
    at += size
  }
  return out
}

/** The box at the end of a path; `skip` bytes of its own stand before the boxes in it. */
export function boxAt(bytes: Buffer, ...path: readonly string[]): Buffer {
  return path.reduce((inside, wanted) => {
    const found = boxes(inside).find(({ type }) => type === wanted)
    if (!found) throw new Error(`no ${wanted}: ${boxes(inside).map(({ type }) => type)}`)
    return found.body
  }, bytes)
}

/** Where the bob of an angle is in a film so large: the drawing in its middle, as large as fits. */
export function place(theta: number, width: number, height: number): Place {
  const [wide, high] = [BOX.width + 28, BOX.height + 12]
  const scale = Math.min(width / wide, height / high)
  const { x, y } = spot(theta)
  return {
    x: (x + 14) * scale + (width - wide * scale) / 2,
    y: (y + 6) * scale + (height - high * scale) / 2,
  }
}

export function expectBobs(bobs: readonly Place[], wanted: readonly Place[]): void {
  bobs.forEach((bob, i) => {
    const at = wanted[i] as Place
    expect([i, Math.hypot(bob.x - at.x, bob.y - at.y)].map((each) => Math.floor(each))).toEqual([i, 0])
  })
}
