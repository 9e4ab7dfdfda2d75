// A press and the click that ends it are one: what moves controls waits in between, or the click would miss what was pressed.

let pressed = false
let waiting: (() => void)[] = []

/** A key too: of a press that opens a list of the browser's own the release is not always told. */
const ENDS = ['pointerup', 'pointercancel', 'keydown'] as const

function released(): void {
  for (const each of ENDS) removeEventListener(each, released, true)
  pressed = false
  const acts = waiting
  waiting = []
  // The click comes in the same task as the release.
  setTimeout(() => {
    for (const act of acts) act()
  })
}

/** A pointer went down. */
export function press(): void {
  if (pressed) return
  pressed = true
  for (const each of ENDS) addEventListener(each, released, true)
}

/** Acts now, or while a pointer is down after its click. */
export function afterRelease(act: () => void): void {
  if (pressed) waiting.push(act)
  else act()
}
