// What a chart of the page is: its texts, its size, what it lets one move, its table and its sound.

import type { noChange, nothing, TemplateResult } from 'lit-html'
import type { TableSpec } from '../columns'
import type { Drag } from '../controls/slide'
import type { Window } from '../study'
import type { SoundSpec } from './trace'

export interface PlotSize {
  readonly width: number
  readonly height: number
  readonly rem: number
}

/** What a plot lets one move: the time, an amplitude, a start. */
export interface Cursor {
  readonly label: string
  readonly least: number
  readonly most: number
  readonly now: number
  /** As a screen reader says it; null while it moves by itself. */
  readonly text: string | typeof noChange | null
  /** Whether the key was one of its own. */
  readonly key: (event: KeyboardEvent) => boolean
  readonly drag: Drag
}

export type Text = string | (() => string)

export interface ChartSpec {
  readonly key: string
  readonly className: string
  readonly title: string
  readonly unit?: string
  /** In words, for names of buttons. */
  readonly name: string
  /** In rem. */
  readonly height: number
  readonly xLabels: boolean
  readonly switches?: TemplateResult | typeof nothing
  /** The plot, once its size is known; the text of a plot that has none. */
  readonly draw: (size: PlotSize) => TemplateResult
  readonly waiting?: string
  /** One sentence from the state: the figure in words. A function where it takes time: not asked while a control is held. */
  readonly caption: Text
  /** What an arrow key on the plot says, likewise. */
  readonly spoken?: Text
  readonly window?: Window
  /** Instead of the time of `window`. */
  readonly cursor?: Cursor
  readonly table?: () => TableSpec
  readonly sound?: () => SoundSpec
  /** Below the plot: reasons of hatching, what to do when it is empty. */
  readonly note?: TemplateResult | typeof nothing
  readonly over?: TemplateResult | typeof nothing
}
