// A press and the click that ends it are one: what moves controls waits in between, or the click would miss what was pressed.

let pressed = false
let waiting: (() => void)[] = []

const ENDS = ['pointerup', 'pointercancel', 'contextmenu', 'keydown'] as const

function released(): void {
  for (const each of ENDS) removeEventListener(each, released, true)
  removeEventListener('pointermove', moved, true)
  pressed = false
  const acts = waiting
  waiting = []
  // The click comes in the same task as the release.
  setTimeout(() => {
    for (const act of acts) act()
  })
}

/** A release that was not told, as beyond the window. */
function moved({ buttons }: PointerEvent): void {
  if (buttons === 0) released()
}

/** A pointer went down. The list of a choice has its release for itself. */
export function press({ button, target }: PointerEvent): void {
  if (pressed || button !== 0 || (target as Element).closest('select')) return
  pressed = true
  for (const each of ENDS) addEventListener(each, released, true)
  addEventListener('pointermove', moved, true)
}

/** Acts now, or while a pointer is down after its click. */
export function afterRelease(act: () => void): void {
  if (pressed) waiting.push(act)
  else act()
}
