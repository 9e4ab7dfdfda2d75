// The fonts of the page as text, for a picture that is drawn apart from it: an image knows no font of the page around it.

/** A font face of the page's style sheets: its rule, and the address in it. */
function faces(): { readonly rule: string; readonly address: string; readonly base: string }[] {
  return [...document.styleSheets].flatMap((sheet) =>
    [...sheet.cssRules].flatMap((rule) => {
      const address = rule instanceof CSSFontFaceRule && /url\(["']?([^"')]+)["']?\)/.exec(rule.cssText)?.[1]
      return address ? [{ rule: rule.cssText, address, base: sheet.href ?? document.baseURI }] : []
    }),
  )
}

function dataAddress(blob: Blob): Promise<string> {
  return new Promise((done, failed) => {
    const reader = new FileReader()
    reader.onload = () => done(String(reader.result))
    reader.onerror = () => failed(reader.error)
    reader.readAsDataURL(blob)
  })
}

async function embedded(): Promise<string> {
  const all = faces().map(async ({ rule, address, base }) => {
    if (address.startsWith('data:')) return rule
    const answer = await fetch(new URL(address, base), { cache: 'force-cache' })
    if (!answer.ok) throw new Error(`${address}: answered ${answer.status}`)
    return rule.replace(address, await dataAddress(await answer.blob()))
  })
  return (await Promise.all(all)).join('\n')
}

let made: Promise<string> | null = null

/** Rules with the fonts in them; none where they cannot be had: then the picture has the fonts of the machine. */
export function fontRules(): Promise<string> {
  made ??= embedded().catch(() => '')
  return made
}
