// A value: label, typed field and slider of one quantity. The field takes what can be read; else it says why and keeps the
// value before.

import { html, nothing, type TemplateResult } from 'lit-html'
import { icon } from '../draw/icons'
import { rich } from '../language/rich'
import { afterKey, dragging, partAlong } from './slide'

export interface ValueSpec {
  readonly key: string
  readonly label: string
  readonly symbol: string
  readonly unit: string
  /** Of the slider, in the unit of the field. */
  readonly value: number
  /** The value at this moment: keys may come faster than pictures. */
  readonly current?: () => number
  readonly least: number
  readonly most: number
  readonly step: number
  /** Where the filled part of the track begins. */
  readonly origin: number
  readonly ticks: readonly number[]
  /** As the field shows it at rest; as a screen reader says it. */
  readonly text: string
  readonly spoken: string
  readonly draft: string | undefined
  readonly fault: string | null
  readonly locked?: boolean
  /** What is said of it where the pointer is. */
  readonly title?: string
  /** Rounds what a drag gives. */
  readonly grain: number
  readonly onText: (text: string) => void
  readonly onDone: () => void
  readonly onSlide: (value: number) => void
  readonly onHold: (held: boolean) => void
}

const part = (value: number, { least, most }: ValueSpec): number =>
  (100 * (Math.min(Math.max(value, least), most) - least)) / (most - least)

/** The field alone. */
export function field(spec: ValueSpec, name: string): TemplateResult {
  const { key, unit, text, draft, fault, locked } = spec
  const id = `field-${key}`
  return html`<label class="field ${fault ? 'bad' : ''} ${locked ? 'locked' : ''}">
    <span class="unseen">${name}</span>
    <input id=${id} inputmode="decimal" autocomplete="off" spellcheck="false" ?disabled=${locked} .value=${draft ?? text}
      aria-invalid=${fault ? 'true' : 'false'} aria-describedby=${fault ? `${id}-fault` : nothing} style="width:${Math.max(2.75, 0.55 * (draft ?? text).length)}rem"
      @input=${(event: Event) => spec.onText((event.target as HTMLInputElement).value)}
      @blur=${spec.onDone}
      @keydown=${(event: KeyboardEvent) => {
        if (event.key === 'Enter') spec.onDone()
        if (event.key === 'ArrowUp' || event.key === 'ArrowDown') {
          const next = afterKey(event, { ...spec, value: spec.current?.() ?? spec.value })
          event.preventDefault()
          if (next !== null) spec.onSlide(next)
        }
      }}>
    ${unit ? html`<span class="unit">${unit}</span>` : nothing}${locked ? icon('lock') : nothing}</label>`
}

function slider(spec: ValueSpec): TemplateResult {
  const { value, least, most, origin, locked } = spec
  const at = part(value, spec)
  const from = part(origin, spec)
  const name = spec.label
  const move = (x: number, element: Element) => {
    const raw = least + (most - least) * partAlong(x, element)
    spec.onSlide(Number((spec.grain * Math.round(raw / spec.grain)).toPrecision(12)))
  }
  return html`<div class="track" @pointerdown=${
    locked
      ? nothing
      : dragging({
          at: (x, _, element) => move(x, element),
          begin: () => spec.onHold(true),
          end: () => spec.onHold(false),
        })
  }>
    ${spec.ticks.map((tick) => html`<i class="notch" style="left:${part(tick, spec)}%"></i>`)}
    <i class="fill" style="left:${Math.min(at, from)}%;width:${Math.abs(at - from)}%"></i>
    <b class="handle" role="slider" tabindex=${locked ? -1 : 0} aria-label=${name} aria-valuemin=${least} aria-valuemax=${most}
      aria-valuenow=${value} aria-valuetext=${spec.spoken} aria-disabled=${locked ? 'true' : nothing} style="left:${at}%"
      @keydown=${(event: KeyboardEvent) => {
        const next = locked ? null : afterKey(event, { ...spec, value: spec.current?.() ?? spec.value })
        if (next === null) return
        event.preventDefault()
        event.stopPropagation()
        spec.onSlide(next)
      }}></b>
  </div>`
}

const faultOf = ({ fault, key }: ValueSpec): TemplateResult | typeof nothing =>
  fault ? html`<p class="fault" id="field-${key}-fault" role="alert">${icon('warn')}<span>${fault}</span></p>` : nothing

export function value(spec: ValueSpec): TemplateResult {
  return html`<div class="value" data-value=${spec.key} title=${spec.title ?? nothing}>
    <span>${spec.label} ${rich(spec.symbol)}</span>${field(spec, spec.label)}${slider(spec)}
    ${faultOf(spec)}
  </div>`
}

/** Label and field on one line. */
export function entry(spec: ValueSpec): TemplateResult {
  return html`<div class="value" data-value=${spec.key}><span>${spec.label} ${rich(spec.symbol)}</span>${field(spec, spec.label)}${faultOf(spec)}</div>`
}
