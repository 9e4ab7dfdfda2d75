// What every slider does: drag with a pointer, step with the keys. A slider is any element of role `slider`.

interface Stops {
  readonly value: number
  readonly least: number
  readonly most: number
  /** Of an arrow key; Shift is a tenth of it, Page ten times. */
  readonly step: number
}

/** The value after a key, or null if the key is not a slider's. */
export function afterKey(event: Pick<KeyboardEvent, 'key' | 'shiftKey'>, stops: Stops): number | null {
  const { value, least, most, step } = stops
  const by = (amount: number) => {
    // To a multiple of the step, so that 149.7 and one on is 150.7 and its digits stay few.
    const next = Number((value + amount).toPrecision(12))
    return Math.min(most, Math.max(least, next))
  }
  const small = event.shiftKey ? step / 10 : step
  switch (event.key) {
    case 'ArrowRight':
    case 'ArrowUp':
      return by(small)
    case 'ArrowLeft':
    case 'ArrowDown':
      return by(-small)
    case 'PageUp':
      return by(10 * step)
    case 'PageDown':
      return by(-10 * step)
    case 'Home':
      return least
    case 'End':
      return most
    default:
      return null
  }
}

export interface Drag {
  /** Client coordinates, and the element that is the measure. */
  readonly at: (x: number, y: number, element: Element) => void
  readonly begin?: () => void
  readonly end?: (dropped: boolean) => void
}

/** A handler of pointerdown that follows the pointer until it is let go; Escape drops it. */
export function dragging(drag: Drag): (event: PointerEvent) => void {
  return (event) => {
    if (event.button !== 0) return
    const element = event.currentTarget as HTMLElement | SVGElement
    event.preventDefault()
    element.setPointerCapture(event.pointerId)
    if (element.tabIndex >= 0) element.focus({ preventScroll: true })
    drag.begin?.()
    drag.at(event.clientX, event.clientY, element)
    const stop = new AbortController()
    const { signal } = stop
    const end = (dropped: boolean) => {
      stop.abort()
      drag.end?.(dropped)
    }
    element.addEventListener(
      'pointermove',
      (e) => drag.at((e as PointerEvent).clientX, (e as PointerEvent).clientY, element),
      { signal },
    )
    element.addEventListener('pointerup', () => end(false), { signal })
    element.addEventListener('pointercancel', () => end(false), { signal })
    window.addEventListener('keydown', (e) => e.key === 'Escape' && end(true), { signal })
  }
}

/** How far along an element a client x is, from 0 to 1. */
export function partAlong(x: number, element: Element): number {
  const box = element.getBoundingClientRect()
  return Math.min(1, Math.max(0, (x - box.left) / box.width))
}
