// A file for the reader, made on this machine: no request leaves the page.

export function saveFile(parts: readonly BlobPart[], type: string, name: string): void {
  const url = URL.createObjectURL(new Blob([...parts], { type }))
  const link = document.createElement('a')
  link.href = url
  link.download = name
  link.click()
  // A browser that asks where to put the file reads the address after the click.
  setTimeout(() => URL.revokeObjectURL(url), 60_000)
}
