// Small controls that every view uses: switches, icon buttons, menus, messages, hints.

import { html, nothing, type TemplateResult } from 'lit-html'
import { type IconName, icon } from '../draw/icons'
import { rich } from '../language/rich'

interface Option<T> {
  readonly value: T
  readonly text?: string
  readonly icon?: IconName
  readonly name?: string
}

/** One of few: the chosen one is underlined. */
export function switches<T>(
  name: string,
  options: readonly Option<T>[],
  chosen: T,
  choose: (value: T) => void,
  className = '',
): TemplateResult {
  return html`<span class="switches ${className}" role="group" aria-label=${name}>${options.map(
    (option) =>
      html`<button type="button" class=${option.value === chosen ? 'on' : ''} aria-pressed=${option.value === chosen ? 'true' : 'false'}
      aria-label=${option.name ?? nothing} title=${option.icon ? (option.name ?? nothing) : nothing}
      @click=${() => choose(option.value)}>${option.icon ? icon(option.icon) : rich(option.text ?? '')}</button>`,
  )}</span>`
}

export function iconButton(
  name: string,
  drawing: IconName,
  act: () => void,
  pressed?: boolean,
  className = '',
): TemplateResult {
  return html`<button type="button" class="icon ${className}" title=${name} aria-label=${name}
    data-tool=${drawing} aria-pressed=${pressed === undefined ? nothing : pressed ? 'true' : 'false'} @click=${act}>${icon(drawing)}</button>`
}

export interface MenuItem {
  readonly text: string
  readonly note?: string
  readonly lang?: string
  readonly chosen?: boolean
  readonly disabled?: boolean
  readonly act: () => void
}

interface MenuSpec {
  readonly key: string
  readonly label: string | TemplateResult
  readonly name: string
  readonly open: boolean
  readonly items: readonly MenuItem[]
  readonly toggle: (open: boolean) => void
  readonly className?: string
  /** Above the button instead of below it. */
  readonly up?: boolean
}

/** A button with a list: Escape and a click elsewhere close it, arrows walk. */
export function menu(spec: MenuSpec): TemplateResult {
  const { key, open } = spec
  const walk = (event: KeyboardEvent) => {
    const list = (event.currentTarget as HTMLElement).querySelectorAll<HTMLElement>('[role^=menuitem]:not([disabled])')
    const all = [...list]
    const at = all.indexOf(document.activeElement as HTMLElement)
    const to = { ArrowDown: at + 1, ArrowUp: Math.max(at, 0) - 1, Home: 0, End: all.length - 1 }[event.key]
    if (event.key === 'Escape') {
      spec.toggle(false)
      document.getElementById(`menu-${key}`)?.focus()
      event.stopPropagation()
    } else if (to !== undefined && open) {
      all[(to + all.length) % all.length]?.focus()
      event.preventDefault()
    } else if (to !== undefined && event.key === 'ArrowDown') {
      spec.toggle(true)
      event.preventDefault()
    }
  }
  const leave = (event: FocusEvent) => {
    if (!(event.currentTarget as HTMLElement).contains(event.relatedTarget as Node | null) && open) spec.toggle(false)
  }
  return html`<div class="menu ${spec.className ?? ''}" @keydown=${walk} @focusout=${leave}>
    <button type="button" id="menu-${key}" class="button quiet" aria-haspopup="menu" aria-expanded=${open ? 'true' : 'false'} aria-label=${spec.name}
      @click=${() => spec.toggle(!open)}>${spec.label}</button>
    ${
      open
        ? html`<ul role="menu" aria-label=${spec.name} class=${spec.up ? 'up' : ''}>${spec.items.map(
            (
              item,
            ) => html`<li role="none"><button type="button" role=${item.chosen === undefined ? 'menuitem' : 'menuitemradio'} tabindex="-1"
          aria-checked=${item.chosen === undefined ? nothing : item.chosen ? 'true' : 'false'} lang=${item.lang ?? nothing} ?disabled=${item.disabled}
          @click=${() => {
            spec.toggle(false)
            document.getElementById(`menu-${key}`)?.focus()
            item.act()
          }}>${rich(item.text)}${item.note ? html`<small>${rich(item.note)}</small>` : nothing}</button></li>`,
          )}</ul>`
        : nothing
    }</div>`
}

/** What went wrong, why, and what now; stays until it is closed. */
export function message(
  text: TemplateResult,
  closeName: string,
  close: (() => void) | null,
  plainOne = false,
): TemplateResult {
  return html`<div class="message ${plainOne ? 'plain' : ''}" role="status">${plainOne ? nothing : icon('warn')}<div>${text}</div>
    ${close ? iconButton(closeName, 'close', close) : nothing}</div>`
}

/** A word with an explanation behind it, on focus, on a click and under the pointer. */
export function hint(
  key: string,
  word: string,
  text: string,
  open: boolean,
  show: (open: boolean) => void,
): TemplateResult {
  return html`<span class="hint" @pointerenter=${(event: PointerEvent) => event.pointerType === 'mouse' && show(true)}
    @pointerleave=${(event: PointerEvent) => event.pointerType === 'mouse' && show(false)}><button type="button" class="hint-word" aria-expanded=${open ? 'true' : 'false'}
    aria-describedby=${open ? `hint-${key}` : nothing} @click=${() => show(!open)} @blur=${() => show(false)}
    @keydown=${(event: KeyboardEvent) => event.key === 'Escape' && show(false)}>${word}</button>${
      open ? html`<span class="hint-text" role="tooltip" id="hint-${key}">${text}</span>` : nothing
    }</span>`
}
