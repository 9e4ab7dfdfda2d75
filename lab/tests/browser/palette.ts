// A screenshot in 256 colours, a third of its bytes: the colours that stand most often and are not next to one another, and for
// every other one the nearest of them. The page decodes the picture; the file is written here, after the PNG specification (RFC 2083).

import { Buffer } from 'node:buffer'
import { crc32, deflateSync } from 'node:zlib'
import type { Page } from '@playwright/test'

interface Indexed {
  readonly width: number
  readonly height: number
  /** Red, green, blue of each colour. */
  readonly palette: readonly (readonly [number, number, number])[]
  /** In base64, a byte for each pixel. */
  readonly indices: string
}

/** In the page. */
async function indexed(png: string): Promise<Indexed> {
  const image = await createImageBitmap(await (await fetch(`data:image/png;base64,${png}`)).blob())
  const { width, height } = image
  const context = new OffscreenCanvas(width, height).getContext('2d')
  if (!context) throw new Error('no canvas')
  context.drawImage(image, 0, 0)
  const pixels = new Uint32Array(context.getImageData(0, 0, width, height).data.buffer)
  const counts = new Map<number, number>()
  for (const pixel of pixels) counts.set(pixel, (counts.get(pixel) ?? 0) + 1)
  const parts = (pixel: number) => [pixel & 255, (pixel >> 8) & 255, (pixel >> 16) & 255] as const
  const palette: (readonly [number, number, number])[] = []
  const nearest = (pixel: number) => {
    const [red, green, blue] = parts(pixel)
    let best = { at: -1, away: Number.POSITIVE_INFINITY }
    palette.forEach(([r, g, b], at) => {
      const away = (r - red) ** 2 + (g - green) ** 2 + (b - blue) ** 2
      if (away < best.away) best = { at, away }
    })
    return best
  }
  const often = [...counts].sort((a, b) => b[1] - a[1])
  // No two closer than this: else the many greys of letters leave no room for the rare colours.
  for (const apart of [200, 50, 12, 0]) {
    for (const [pixel] of often) if (palette.length < 256 && nearest(pixel).away > apart) palette.push(parts(pixel))
  }
  const index = new Map([...counts.keys()].map((pixel) => [pixel, nearest(pixel).at]))
  let bytes = ''
  for (const pixel of pixels) bytes += String.fromCharCode(index.get(pixel) ?? 0)
  return { width, height, palette, indices: btoa(bytes) }
}

function chunk(name: string, data: Uint8Array): Buffer {
  const body = Buffer.concat([Buffer.from(name, 'latin1'), data])
  const ends = Buffer.alloc(8)
  ends.writeUInt32BE(data.length, 0)
  ends.writeUInt32BE(crc32(body), 4)
  return Buffer.concat([ends.subarray(0, 4), body, ends.subarray(4)])
}

export async function inPalette(page: Page, png: Buffer): Promise<Buffer> {
  const { width, height, palette, indices } = await page.evaluate(indexed, png.toString('base64'))
  const header = Buffer.alloc(13)
  header.writeUInt32BE(width, 0)
  header.writeUInt32BE(height, 4)
  // Eight bits, colours by a palette.
  header.set([8, 3], 8)
  const rows = Buffer.from(indices, 'base64')
  // Each line begins with its filter: none.
  const lines = Buffer.alloc((width + 1) * height)
  for (let y = 0; y < height; y++) rows.copy(lines, y * (width + 1) + 1, y * width, (y + 1) * width)
  return Buffer.concat([
    Buffer.from([137, 80, 78, 71, 13, 10, 26, 10]),
    chunk('IHDR', header),
    chunk('PLTE', Uint8Array.from(palette.flat())),
    chunk('IDAT', deflateSync(lines, { level: 9 })),
    chunk('IEND', new Uint8Array(0)),
  ])
}
