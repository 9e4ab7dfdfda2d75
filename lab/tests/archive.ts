// A ZIP archive of some texts, deflated, as the tools of a laboratory write it (APPNOTE.TXT 4.3).

import { crc32, deflateRawSync } from 'node:zlib'

const little = (...fields: readonly (readonly [bytes: number, value: number])[]): Buffer =>
  Buffer.concat(
    fields.map(([bytes, value]) => {
      const field = Buffer.alloc(bytes)
      field.writeUIntLE(value, 0, bytes)
      return field
    }),
  )

export function archive(files: Readonly<Record<string, string>>): Uint8Array {
  const locals: Buffer[] = []
  const directory: Buffer[] = []
  let offset = 0
  for (const [path, text] of Object.entries(files)) {
    const [name, plain] = [Buffer.from(path), Buffer.from(text)]
    const packed = deflateRawSync(plain)
    // Version, flags, method, time, date, checksum, sizes, lengths of the name and of what is extra.
    const head = little([2, 20], [2, 0], [2, 8], [2, 0], [2, 33], [4, crc32(plain)], [4, packed.length])
    const tail = little([4, plain.length], [2, name.length], [2, 0])
    locals.push(little([4, 0x04034b50]), head, tail, name, packed)
    const place = little([2, 0], [2, 0], [2, 0], [4, 0], [4, offset])
    directory.push(little([4, 0x02014b50], [2, 20]), head, tail, place, name)
    offset += 30 + name.length + packed.length
  }
  const entries = Buffer.concat(directory)
  const count = Object.keys(files).length
  const end = little([4, 0x06054b50], [4, 0], [2, count], [2, count], [4, entries.length], [4, offset], [2, 0])
  return new Uint8Array(Buffer.concat([...locals, entries, end]))
}
