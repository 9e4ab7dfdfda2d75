// The frame of a dialog, and how it opens and closes. Focus returns to where it was. What is in it: dialog-bodies.ts.

import { html, type TemplateResult } from 'lit-html'
import { keyed } from 'lit-html/directives/keyed.js'
import { ref } from 'lit-html/directives/ref.js'
import { iconButton } from '../controls/parts'
import type { DialogName } from '../store'
import type { Page } from './page'

let opener: Element | null = null

export function openDialog({ store }: Pick<Page, 'store'>, dialog: DialogName): void {
  opener = document.activeElement
  store.setSession({ dialog, copied: false, copyFailed: false, menu: null })
}

function closed({ store }: Page): void {
  store.setSession({ dialog: null })
  if (opener instanceof HTMLElement || opener instanceof SVGElement) opener.focus()
  opener = null
}

export function dialog(page: Page, key: string, title: string, body: TemplateResult): TemplateResult {
  return html`${keyed(
    key,
    html`<dialog class="dialog" aria-labelledby="dialog-title" ${ref((element) => {
      // The element is in the page only after this render.
      queueMicrotask(() => {
        if (element instanceof HTMLDialogElement && element.isConnected && !element.open) element.showModal()
      })
    })}
      @close=${() => closed(page)} @click=${(event: MouseEvent) => event.target === event.currentTarget && (event.currentTarget as HTMLDialogElement).close()}>
      <div class="dialog-body"><div class="head"><h2 id="dialog-title">${title}</h2>${iconButton(
        page.words.say.shell.close,
        'close',
        () => document.querySelector<HTMLDialogElement>('dialog[open]')?.close(),
      )}</div>${body}</div></dialog>`,
  )}`
}
