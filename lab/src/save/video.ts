// A film as MP4 with H.264, or as WebM with VP9 where the browser writes no H.264: encoded by the browser (WebCodecs), put into the
// file by mediabunny. A part of its own: it is as long as all the rest that saves.

import {
  BufferTarget,
  EncodedPacket,
  EncodedVideoPacketSource,
  Mp4OutputFormat,
  Output,
  type OutputFormat,
  WebMOutputFormat,
} from 'mediabunny'
import type { Film, Sink } from './film'

/** Bits for a pixel of a frame: lines stay sharp. */
const BITS = 0.25
/** Frames that may wait in the encoder. */
const WAITING = 4

interface Kind {
  readonly ending: 'mp4' | 'webm'
  readonly codec: 'avc' | 'vp9'
  readonly type: string
  /** Profiles and levels, the one that plays everywhere first. */
  readonly strings: readonly string[]
  readonly extra: Partial<VideoEncoderConfig>
  readonly format: () => OutputFormat
}

const KINDS: readonly Kind[] = [
  {
    ending: 'mp4',
    codec: 'avc',
    type: 'video/mp4',
    strings: ['avc1.640028', 'avc1.4d0028', 'avc1.42e028'],
    extra: { avc: { format: 'avc' } },
    format: () => new Mp4OutputFormat({ fastStart: 'in-memory' }),
  },
  {
    ending: 'webm',
    codec: 'vp9',
    type: 'video/webm',
    strings: ['vp09.00.40.08'],
    extra: {},
    format: () => new WebMOutputFormat(),
  },
]

interface Encoding extends Kind {
  readonly config: VideoEncoderConfig
}

/** The first kind of film that this browser writes at a size; null where it writes none. */
export async function encodingFor(width: number, height: number, framerate: number): Promise<Encoding | null> {
  if (typeof VideoEncoder !== 'function') return null
  for (const kind of KINDS) {
    for (const codec of kind.strings) {
      const bitrate = Math.round(BITS * width * height * framerate)
      const config = { codec, width, height, framerate, bitrate, ...kind.extra }
      const { supported } = await VideoEncoder.isConfigSupported(config).catch(() => ({ supported: false }))
      if (supported) return { ...kind, config }
    }
  }
  return null
}

export async function videoSink({ ending, codec, type, config, format }: Encoding, film: Film): Promise<Sink> {
  const target = new BufferTarget()
  const output = new Output({ format: format(), target })
  const source = new EncodedVideoPacketSource(codec)
  output.addVideoTrack(source)
  await output.start()
  let failure: unknown = null
  let written = Promise.resolve()
  const encoder = new VideoEncoder({
    output: (chunk, meta) => {
      written = written
        .then(() => source.add(EncodedPacket.fromEncodedChunk(chunk), meta))
        .catch((error: unknown) => {
          failure ??= error
        })
    },
    error: (error) => {
      failure ??= error
    },
  })
  encoder.configure(config)
  const check = () => {
    if (failure !== null) throw failure
  }
  // In whole microseconds, and each frame lasts to the next.
  const at = (frame: number) => Math.round((1e6 * film.seconds * frame) / film.times.length)
  const every = Math.max(1, Math.round((2 * film.times.length) / film.seconds))
  return {
    ending,
    type,
    add: async (canvas, frame) => {
      check()
      const picture = new VideoFrame(canvas, { timestamp: at(frame), duration: at(frame + 1) - at(frame) })
      encoder.encode(picture, { keyFrame: frame % every === 0 })
      picture.close()
      while (encoder.encodeQueueSize > WAITING) await new Promise((done) => setTimeout(done, 1))
    },
    finish: async () => {
      await encoder.flush()
      await written
      check()
      encoder.close()
      await output.finalize()
      return new Uint8Array(target.buffer as ArrayBuffer)
    },
    close: () => {
      if (encoder.state !== 'closed') encoder.close()
      void output.cancel()
    },
  }
}
