// The left column of Data: the file or a pasted table, what was understood of it with the means to say otherwise, what is known.

import { html, nothing, type TemplateResult } from 'lit-html'
import { switches } from '../controls/parts'
import { icon } from '../draw/icons'
import { type Entries, type EntryName, isBad, type Measurement, MODELS, ROLES } from '../measurement'
import type { Live } from './page'

async function takeFile(page: Live, measurement: Measurement, file: File | undefined): Promise<void> {
  if (!file) return
  // What is found is spoken, and nothing is while the pendulum moves.
  page.store.pause()
  measurement.take(file.name, new Uint8Array(await file.arrayBuffer()))
}

function source(page: Live, measurement: Measurement): TemplateResult {
  const { data } = page.words.say
  const over = (on: boolean) => (event: DragEvent) => {
    event.preventDefault()
    ;(event.currentTarget as HTMLElement).classList.toggle('over', on)
  }
  const paste = (event: Event) => {
    const text = (event.currentTarget as HTMLElement).parentElement?.querySelector('textarea')?.value ?? ''
    page.store.pause()
    measurement.take(data.pasted, new TextEncoder().encode(text))
  }
  return html`<h2>${data.source}</h2>
    <div class="drop" @dragover=${over(true)} @dragleave=${over(false)} @drop=${(event: DragEvent) => {
      over(false)(event)
      void takeFile(page, measurement, event.dataTransfer?.files[0])
    }}><span>${data.drop}</span>
      <label class="button">${data.choose}<input type="file" id="data-file" @change=${(event: Event) => {
        const input = event.target as HTMLInputElement
        const [file] = input.files ?? []
        void takeFile(page, measurement, file)
        // The same file may be chosen again once it was changed.
        input.value = ''
      }}></label></div>
    <details><summary>${data.paste}</summary>
      <textarea class="paste" id="data-text" spellcheck="false" aria-label=${data.pasteLabel}></textarea>
      <button type="button" class="button" id="data-read" @click=${paste}>${data.read}</button></details>
    ${measurement.file ? nothing : html`<p class="soft small">${data.takes} ${data.privacy}</p>`}`
}

function understood(page: Live, { file, reading }: Measurement): TemplateResult | typeof nothing {
  if (!file) return nothing
  const { words } = page
  const { data } = words.say
  if (!reading) return html`<p class="file-name">${file.name}</p>`
  const [run, count] = reading.run
  const rows = words.fill(data.rows, { count: reading.y.length, what: data.kinds[reading.measured] })
  const sentences = [
    ...reading.understood.map((each) => html`<li lang="en">${each}</li>`),
    ...reading.dropped.map((each) => html`<li>${data.dropped}: <span lang="en">${each}</span></li>`),
  ]
  return html`<p class="file-name">${file.name}</p>
    <p class="small" id="data-rows">${rows}${count > 1 ? html`, ${words.fill(data.ofRuns, { run, count })}` : nothing}</p>
    <h2>${data.understood}</h2>
    <ul class="said" id="data-understood" tabindex="0" role="list" aria-label=${data.understood}>${sentences}</ul>`
}

/** A field whose value counts when it is left, Enter is pressed or a file comes. */
function field(measurement: Measurement, name: EntryName, label: string, unit: string, enter: Enter) {
  const text = measurement.entries[name]
  const typed = (event: Event) => ({ [name]: (event.target as HTMLInputElement).value })
  return html`<span class="field ${isBad(name, text) ? 'bad' : ''}"><input id="data-${name}" .value=${text} aria-label=${label}
    aria-invalid=${isBad(name, text) ? 'true' : 'false'} aria-describedby=${isBad(name, text) ? 'data-fault' : nothing}
    autocomplete="off" spellcheck="false" @input=${(event: Event) => measurement.type(typed(event))} @change=${(event: Event) => enter(typed(event))}>${
      unit === '' ? nothing : html`<span class="unit">${unit}</span>`
    }</span>`
}

type Enter = (patch: Partial<Entries>) => void

function select<T extends string>(
  id: string,
  label: string,
  all: readonly T[],
  now: T,
  say: (each: T) => string,
  set: (each: T) => void,
) {
  return html`<select id=${id} aria-label=${label} @change=${(event: Event) => set((event.target as HTMLSelectElement).value as T)}>${all.map(
    (each) => html`<option value=${each} ?selected=${each === now}>${say(each)}</option>`,
  )}</select>`
}

function correct(page: Live, measurement: Measurement, enter: Enter): TemplateResult {
  const { data } = page.words.say
  const { entries } = measurement
  const line = (name: EntryName, label: string) =>
    html`<div class="entry"><span aria-hidden="true">${label}</span>${field(measurement, name, label, '', enter)}</div>`
  return html`<details id="data-correct"><summary>${data.correct}</summary><p class="soft small">${data.correctHelp}</p>
    ${line('time', data.time)}
    <div class="entry"><span aria-hidden="true">${data.role}</span>${select(
      'data-role',
      data.role,
      ROLES,
      entries.role,
      (each) => data.roles[each],
      (role) => enter({ role }),
    )}</div>
    ${line('column', data.column)}${line('unit', data.unit)}${line('rate', data.rate)}${line('run', data.run)}</details>`
}

function known(page: Live, measurement: Measurement, enter: Enter): TemplateResult {
  const { words } = page
  const { data, units } = words.say
  const { entries } = measurement
  const which = entries.known
  const unit = units[which === 'length' ? 'm' : 'm/s2']
  const bad = (Object.keys(entries) as EntryName[]).find((name) => isBad(name, entries[name]))
  return html`<h2>${data.known}</h2>
    ${switches(
      data.known,
      (['length', 'gravity'] as const).map((value) => ({ value, text: data[value] })),
      which,
      (value) => enter({ known: value }),
    )}
    <div class="entry"><span aria-hidden="true">${data[which]}</span><span class="pair">${field(measurement, which, data[which], '', enter)}±${field(measurement, `${which}U`, data[`${which}U`], unit, enter)}</span></div>
    <div class="entry"><span aria-hidden="true">${data.model}</span>${select(
      'data-model',
      data.model,
      MODELS,
      entries.model,
      (each) => data.models[each],
      (model) => enter({ model }),
    )}</div>
    ${bad ? html`<p class="fault" id="data-fault" role="alert">${icon('warn')}<span>${words.fill(data.notANumber, { value: entries[bad] })}</span></p>` : nothing}`
}

export function dataSource(page: Live, measurement: Measurement): TemplateResult {
  const enter: Enter = (patch) => measurement.enter(patch)
  return html`${source(page, measurement)}${understood(page, measurement)}
    ${measurement.file ? correct(page, measurement, enter) : nothing}${known(page, measurement, enter)}`
}
