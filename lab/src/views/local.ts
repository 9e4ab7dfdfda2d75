// What is said beside a link or a code that nobody else can open, because its address is of this machine alone.

import { html, nothing, type TemplateResult } from 'lit-html'
import type { Words } from '../language'

export function localNotice(words: Words): TemplateResult | typeof nothing {
  const local = location.protocol === 'file:' || /^(localhost|127\.|\[::1\])/.test(location.hostname)
  return local ? html`<p class="soft small local">${words.say.share.local}</p>` : nothing
}
