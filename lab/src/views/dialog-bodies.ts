// The dialogs: Share with the link and its QR code, the list of keys, and the errors against the step (convergence.ts).

import { html, nothing, type TemplateResult } from 'lit-html'
import { encode } from 'uqr'
import { embedCode } from '../embedding'
import { convergenceDialog } from './convergence'
import { dialog } from './dialogs'
import { localNotice } from './local'
import { copyText, isLive, type Page } from './page'
import { linkOf } from './table'

function qr(text: string, name: string): TemplateResult {
  const { size, data } = encode(text, { ecc: 'L', border: 0 })
  let d = ''
  data.forEach((line, y) => {
    line.forEach((dark, x) => {
      if (dark) d += `M${x} ${y}h1v1h-1z`
    })
  })
  const box = size + 8
  return html`<svg class="qr" viewBox="-4 -4 ${box} ${box}" role="img" aria-label=${name}><path d="M-4-4h${box}v${box}h-${box}z" fill="#fff"/><path d=${d} fill="#000"/></svg>`
}

function share(page: Page): TemplateResult {
  const { words, session } = page
  const say = words.say.share
  const link = linkOf(page)
  const body = html`<div class="share">${qr(link, say.qr)}<div>
      <textarea id="share-link" class="link" readonly rows="4" aria-label=${say.link} @focus=${(event: FocusEvent) => (event.target as HTMLTextAreaElement).select()} .value=${link}></textarea>
      <p class="soft small">${words.fill(say.about, { count: link.length })}</p>${localNotice(words)}</div></div>
    ${session.copyFailed ? html`<p class="soft small" role="status">${say.failed}</p>` : nothing}
    <div class="foot"><button type="button" class="button primary" @click=${() => copyText(page, link, '#share-link')}>${session.copied ? say.copied : say.copy}</button>
    <button type="button" class="button" @click=${() => copyText(page, embedCode(link, 800, 600), '#share-link')}>${say.embed}</button></div>
    <span class="unseen" role="status">${session.copied ? say.copied : ''}</span>`
  return dialog(page, 'share', say.title, body)
}

function keys(page: Page, views: number): TemplateResult {
  const { words, session, store } = page
  const say = words.say.keys
  const body = html`<dl class="key-list">${say.rows.map(
    ([key, what]) =>
      html`<dt>${words
        .fill(key, { views })
        .split(' + ')
        .map((each) => html`<kbd>${each}</kbd>`)}</dt><dd>${what}</dd>`,
  )}</dl>
    <label class="check"><input type="checkbox" .checked=${session.singleKeys} @change=${(event: Event) => store.setSession({ singleKeys: (event.target as HTMLInputElement).checked })}> ${say.singles}</label>`
  return dialog(page, 'keys', say.title, body)
}

export function dialogs(page: Page, views: number): TemplateResult | typeof nothing {
  if (page.session.dialog === 'share') return share(page)
  if (page.session.dialog === 'keys') return keys(page, views)
  if (page.session.dialog === 'convergence' && isLive(page)) return convergenceDialog(page)
  return nothing
}
