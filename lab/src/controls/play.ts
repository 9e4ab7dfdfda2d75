// The play bar: its track is the time axis of the plots above it. Head, steps, typed time, speed, span.

import { html, nothing, type TemplateResult } from 'lit-html'
import { icon } from '../draw/icons'
import { iconButton } from './parts'
import { afterKey, dragging, partAlong } from './slide'

interface PlaySpec {
  readonly playing: boolean
  readonly t: number
  /** The time at this moment. */
  readonly current: () => number
  readonly from: number
  readonly to: number
  readonly ticks: readonly number[]
  readonly names: {
    readonly play: string
    readonly pause: string
    readonly back: string
    readonly on: string
    readonly bar: string
  }
  /** As a screen reader says the time. */
  readonly spoken: string
  /** Typed time, once in the bar and once beside its track on a phone. */
  readonly field: (where: 'bar' | 'short') => TemplateResult
  readonly options: readonly TemplateResult[]
  readonly note: string | null
  readonly onPlay: () => void
  readonly onStep: (by: number) => void
  readonly onSeek: (t: number) => void
  readonly onHold: (held: boolean) => void
}

export function playBar(spec: PlaySpec): TemplateResult {
  const { playing, t, from, to, names } = spec
  const part = (time: number) => (100 * Math.min(Math.max(time - from, 0), to - from)) / (to - from)
  const at = part(t)
  return html`<div class="play" role="group" aria-label=${names.bar}>
    <button type="button" class="go" id="play" aria-label=${playing ? names.pause : names.play} title=${playing ? names.pause : names.play} @click=${spec.onPlay}>${icon(playing ? 'pause' : 'play')}</button>
    <div class="scrub" @pointerdown=${dragging({
      at: (x, _, element) => spec.onSeek(from + (to - from) * partAlong(x, element)),
      begin: () => spec.onHold(true),
      end: () => spec.onHold(false),
    })}>
      <i class="fill" style="width:${at}%"></i>
      ${spec.ticks.map((tick) => html`<i class="notch" style="left:${part(tick)}%"></i>`)}
      <b class="handle" role="slider" tabindex="0" aria-label=${names.bar} aria-valuemin=${from} aria-valuemax=${to} aria-valuenow=${playing ? from : Number(t.toFixed(3))}
        aria-valuetext=${playing ? nothing : spec.spoken} style="left:${at}%"
        @keydown=${(event: KeyboardEvent) => {
          const next = afterKey(event, { value: spec.current(), least: from, most: to, step: 0.1 })
          if (next === null) return
          event.preventDefault()
          event.stopPropagation()
          spec.onSeek(next)
        }}></b>
    </div>
    <div class="short">${spec.field('short')}</div>
    <div class="options"><span class="steps">${spec.field('bar')}${iconButton(names.back, 'back', () => spec.onStep(-1))}${iconButton(names.on, 'step', () => spec.onStep(1))}</span>
      ${spec.options}</div>
    ${spec.note ? html`<p class="soft note-line">${spec.note}</p>` : nothing}
  </div>`
}
