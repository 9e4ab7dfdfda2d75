// The size in pixels at which the page has laid an element out: charts are drawn for it, not stretched.

import { AsyncDirective } from 'lit-html/async-directive.js'
import { directive, type ElementPart, type PartInfo, PartType } from 'lit-html/directive.js'

export interface Size {
  readonly width: number
  readonly height: number
}

const sizes = new Map<string, Size>()
let whenChanged = () => {}

/** Called when any measured element has another size. */
export function onResize(listener: () => void): void {
  whenChanged = listener
}

export function sizeOf(key: string): Size | undefined {
  return sizes.get(key)
}

class Measured extends AsyncDirective {
  #observer: ResizeObserver | null = null
  #element: Element | null = null
  #key = ''

  constructor(info: PartInfo) {
    super(info)
    if (info.type !== PartType.ELEMENT) throw new Error('measured() stands in an element')
  }

  render(_key: string): unknown {
    return undefined
  }

  override update(part: ElementPart, [key]: [string]): unknown {
    this.#key = key
    if (this.#element !== part.element) {
      this.#observer?.disconnect()
      this.#element = part.element
      this.#observe()
    }
    return undefined
  }

  #observe(): void {
    if (!this.#element) return
    this.#observer = new ResizeObserver(([entry]) => {
      if (!entry) return
      const { width, height } = entry.contentRect
      const before = sizes.get(this.#key)
      if (before?.width === width && before.height === height) return
      sizes.set(this.#key, { width, height })
      whenChanged()
    })
    this.#observer.observe(this.#element)
  }

  override disconnected(): void {
    this.#observer?.disconnect()
    this.#observer = null
  }

  override reconnected(): void {
    this.#observe()
  }
}

/** In an element: `<div ${measured('angle')}>`; then `sizeOf('angle')`. */
export const measured = directive(Measured)

/** Pixels of 1 rem. */
export function remPixels(): number {
  return Number.parseFloat(getComputedStyle(document.documentElement).fontSize)
}
