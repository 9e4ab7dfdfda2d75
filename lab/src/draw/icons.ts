// The icons, drawn in a box of 20 by 20.

import { html, svg, type TemplateResult } from 'lit-html'

const ICONS = {
  play: svg`<path d="M5 3l12 7-12 7z"/>`,
  pause: svg`<path d="M5 3h3.5v14H5zM11.5 3H15v14h-3.5z"/>`,
  back: svg`<path d="M12 4l-6 6 6 6M15.5 4v12"/>`,
  step: svg`<path d="M8 4l6 6-6 6M4.5 4v12"/>`,
  before: svg`<path d="M12.5 4l-6 6 6 6"/>`,
  next: svg`<path d="M7.5 4l6 6-6 6"/>`,
  table: svg`<path d="M3 4h14v12H3zM3 8h14M3 12h14M8 4v12"/>`,
  sound: svg`<path d="M3 8v4h3l4 3.5v-11L6 8zM13 7.5a3.5 3.5 0 010 5M15.5 5a7 7 0 010 10"/>`,
  plus: svg`<path d="M10 4v12M4 10h12"/>`,
  open: svg`<path d="M8 4H4v12h12v-4M11 4h5v5M16 4l-7 7"/>`,
  share: svg`<path d="M10 12V3M6.5 6L10 2.5 13.500 6M5 9H4v8h12V9h-1"/>`,
  save: svg`<path d="M10 3v9M6.5 8.5l3.5 3.5 3.5-3.5M4 13v4h12v-4"/>`,
  sun: svg`<circle cx="10" cy="10" r="3.5"/><path d="M10 2v2M10 16v2M2 10h2M16 10h2M4.3 4.3l1.4 1.4M14.3 14.3l1.4 1.4M4.3 15.7l1.4-1.4M14.3 5.7l1.4-1.4"/>`,
  moon: svg`<path d="M16 12.5A6.5 6.5 0 017.5 4 6.5 6.5 0 1016 12.5z"/>`,
  auto: svg`<circle cx="10" cy="10" r="6.5"/><path d="M10 3.5v13a6.5 6.5 0 000-13z" fill="currentColor"/>`,
  keys: svg`<path d="M2.5 5.5h15v9h-15zM5.5 8.5h.01M8.5 8.5h.01M11.5 8.5h.01M14.5 8.5h.01M6 11.5h8"/>`,
  down: svg`<path d="M5 8l5 5 5-5"/>`,
  close: svg`<path d="M5 5l10 10M15 5L5 15"/>`,
  lock: svg`<path d="M5 9h10v8H5zM7 9V6.5a3 3 0 016 0V9"/>`,
  dots: svg`<circle cx="10" cy="4.5" r=".8"/><circle cx="10" cy="10" r=".8"/><circle cx="10" cy="15.5" r=".8"/>`,
  warn: svg`<path d="M10 3l8 14H2zM10 8.5v4M10 14.8v.01"/>`,
  check: svg`<path d="M4 10.500l4 4 8-9"/>`,
}

export type IconName = keyof typeof ICONS

export function icon(name: IconName): TemplateResult {
  return html`<svg class="icon-drawing" viewBox="0 0 20 20" aria-hidden="true">${ICONS[name]}</svg>`
}

/** The mark of the page. */
export const mark = html`<svg class="mark-drawing" viewBox="0 0 24 24" aria-hidden="true"><path d="M3.5 12a8.5 8.5 0 0017 0" fill="none" stroke="var(--edge)" stroke-width="1.5"/><path d="M12 4l6.2 12" stroke="var(--ink)" stroke-width="2"/><circle cx="18" cy="16.5" r="3.6" class="bob" style="stroke-width:1.5"/><circle cx="12" cy="4" r="1.6" fill="var(--ink)"/></svg>`
