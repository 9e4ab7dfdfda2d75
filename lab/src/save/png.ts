// A drawing as pixels: an image of its SVG with the fonts inside it, on a canvas; and how large a pixel is, written into the PNG.

import { fontRules } from './fonts'

export const DOTS_PER_INCH = 300
const MM_PER_INCH = 25.4

export const pixelsOf = (mm: number): number => Math.round((mm / MM_PER_INCH) * DOTS_PER_INCH)

/** Draws an SVG over a whole canvas; `fonts` are those of `fontRules`. */
export async function paint(svg: string, canvas: HTMLCanvasElement, fonts: string): Promise<void> {
  const withFonts = svg.replace(/<svg[^>]*>/, (root) => `${root}<style>${fonts}</style>`)
  const image = new Image()
  // In pixels of the canvas: an image is drawn once, at its own size.
  image.src = URL.createObjectURL(new Blob([sized(withFonts, canvas)], { type: 'image/svg+xml' }))
  try {
    await image.decode()
    const context = canvas.getContext('2d', { willReadFrequently: true }) as CanvasRenderingContext2D
    context.fillStyle = '#ffffff'
    context.fillRect(0, 0, canvas.width, canvas.height)
    context.drawImage(image, 0, 0, canvas.width, canvas.height)
  } finally {
    URL.revokeObjectURL(image.src)
  }
}

function sized(svg: string, { width, height }: HTMLCanvasElement): string {
  return svg.replace(/ width="[\d.]+mm"/, ` width="${width}"`).replace(/ height="[\d.]+mm"/, ` height="${height}"`)
}

// The check sum of a chunk (PNG specification, annex D).
const CRC = Uint32Array.from({ length: 256 }, (_, n) => {
  let c = n
  for (let k = 0; k < 8; k++) c = c & 1 ? 0xedb88320 ^ (c >>> 1) : c >>> 1
  return c
})

export function checkSum(bytes: Uint8Array): number {
  let c = 0xffffffff
  for (const byte of bytes) c = (CRC[(c ^ byte) & 255] as number) ^ (c >>> 8)
  return (c ^ 0xffffffff) >>> 0
}

/** A PNG with a pHYs chunk behind its header: so many pixels in a metre. */
export function withDensity(png: Uint8Array, dotsPerInch: number): Uint8Array<ArrayBuffer> {
  const HEADER = 33
  const chunk = new Uint8Array(21)
  const view = new DataView(chunk.buffer)
  const perMetre = Math.round((1000 * dotsPerInch) / MM_PER_INCH)
  view.setUint32(0, 9)
  chunk.set(new TextEncoder().encode('pHYs'), 4)
  view.setUint32(8, perMetre)
  view.setUint32(12, perMetre)
  view.setUint8(16, 1)
  view.setUint32(17, checkSum(chunk.subarray(4, 17)))
  const out = new Uint8Array(png.length + chunk.length)
  out.set(png.subarray(0, HEADER))
  out.set(chunk, HEADER)
  out.set(png.subarray(HEADER), HEADER + chunk.length)
  return out
}

/** The PNG of a drawing of so many millimetres. */
export async function png(svg: string): Promise<Uint8Array<ArrayBuffer>> {
  const [width = 0, height = 0] = [/ width="([\d.]+)mm"/, / height="([\d.]+)mm"/].map((each) =>
    pixelsOf(Number(each.exec(svg)?.[1])),
  )
  const canvas = document.createElement('canvas')
  Object.assign(canvas, { width, height })
  await paint(svg, canvas, await fontRules())
  const blob = await new Promise<Blob | null>((done) => canvas.toBlob(done, 'image/png'))
  if (!blob) throw new Error('the browser gave no PNG')
  return withDensity(new Uint8Array(await blob.arrayBuffer()), DOTS_PER_INCH)
}
