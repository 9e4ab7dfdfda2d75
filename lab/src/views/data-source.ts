// The left column of Data: the files or a pasted table, what was understood of them, the means to say otherwise, what is known.

import { html, nothing, type TemplateResult } from 'lit-html'
import { iconButton } from '../controls/parts'
import { isBad } from '../entries'
import { rich } from '../language/rich'
import { inLanguage } from '../language/sentences'
import type { Measurement } from '../measurement'
import type { Reading } from '../model/fit-protocol'
import { entryField, entryLine, entryPair } from './data-fields'
import { correct, known } from './data-known'
import type { Live } from './page'

type Taken = (...files: readonly (readonly [name: string, bytes: Uint8Array])[]) => void

/** Files are taken in the order in which they were chosen, however long they take to be read. */
let before: Promise<void> = Promise.resolve()

function takeFiles(page: Live, files: readonly File[], measurement: Measurement, taken: Taken): void {
  if (files.length === 0) return
  // What is found is spoken, and nothing is while the pendulum moves.
  page.store.pause()
  const read = async (file: File) => [file.name, new Uint8Array(await file.arrayBuffer())] as const
  const all = Promise.all(files.map(read))
  before = Promise.allSettled([all, before]).then(async () => {
    try {
      taken(...(await all))
    } catch (error) {
      // A folder, or a file that has gone or is larger than a browser reads.
      const why = error instanceof Error ? error.message : String(error)
      measurement.fail(`${files.map(({ name }) => name).join(', ')}: ${why.replace(/\.$/, '')}`)
    }
  })
}

function chooser(page: Live, id: string, text: string, measurement: Measurement, taken: Taken): TemplateResult {
  return html`<label class="button">${text}<input type="file" multiple id=${id} @change=${(event: Event) => {
    const input = event.target as HTMLInputElement
    const files = [...(input.files ?? [])]
    takeFiles(page, files, measurement, taken)
    // The same file may be chosen again once it was changed.
    input.value = ''
  }}></label>`
}

function source(page: Live, measurement: Measurement): TemplateResult {
  const { data } = page.words.say
  const take: Taken = (...files) => measurement.take(...files)
  const over = (on: boolean) => (event: DragEvent) => {
    event.preventDefault()
    ;(event.currentTarget as HTMLElement).classList.toggle('over', on)
  }
  const pasted = (event: Event) => {
    const text = (event.currentTarget as HTMLElement).parentElement?.querySelector('textarea')?.value ?? ''
    page.store.pause()
    return [data.pasted, new TextEncoder().encode(text)] as const
  }
  return html`<h2>${data.source}</h2>
    <div class="drop" @dragover=${over(true)} @dragleave=${over(false)} @drop=${(event: DragEvent) => {
      over(false)(event)
      takeFiles(page, [...(event.dataTransfer?.files ?? [])], measurement, take)
    }}><span>${data.drop}</span>${chooser(page, 'data-file', data.choose, measurement, take)}</div>
    <details><summary>${data.paste}</summary>
      <textarea class="paste" id="data-text" spellcheck="false" aria-label=${data.pasteLabel}></textarea>
      <button type="button" class="button" id="data-read" @click=${(event: Event) => take(pasted(event))}>${data.read}</button>
      ${
        measurement.files.length > 0
          ? html`<button type="button" class="button quiet" id="data-read-more" @click=${(event: Event) => measurement.add(pasted(event))}>${data.readMore}</button>`
          : nothing
      }</details>
    ${measurement.file ? nothing : html`<p class="soft small">${data.takes} ${data.privacy}</p>`}`
}

/** One of several files: its name shows it, and its length stands below. */
function ofSeveral(page: Live, measurement: Measurement, place: number): TemplateResult {
  const { data, units } = page.words.say
  const file = measurement.files[place] as Measurement['files'][number]
  const shown = place === measurement.shown
  const own = (name: 'length' | 'lengthU', unit = '') =>
    entryField({
      id: `data-${name}-${place}`,
      label: `${file.name}: ${data[name]}`,
      text: file[name],
      bad: isBad('length', file[name]),
      unit,
      type: (typed) => measurement.typeLength(place, { [name]: typed }),
      enter: () => measurement.entered(),
    })
  return html`<li><div class="entry"><button type="button" class="file-name ${shown ? 'on' : ''}" aria-pressed=${shown ? 'true' : 'false'}
    @click=${() => measurement.show(place)}>${file.name}</button>${iconButton(`${data.remove}: ${file.name}`, 'close', () => measurement.remove(place))}</div>
    ${measurement.entries.known === 'length' ? entryLine(data.ownLength, entryPair(own('length'), own('lengthU', units.m))) : nothing}</li>`
}

function files(page: Live, measurement: Measurement): TemplateResult {
  const { data } = page.words.say
  const several = measurement.files.length > 1
  const more = chooser(page, 'data-more', data.add, measurement, (...added) => measurement.add(...added))
  if (!several) return html`<div class="entry more"><p class="file-name">${measurement.file?.name}</p>${more}</div>`
  return html`<ul role="list" id="data-files" aria-label=${data.records}>${measurement.files.map((_, i) => ofSeveral(page, measurement, i))}</ul>
    <div class="more">${more}</div><p class="soft small">${rich(data.severalHelp)}</p>`
}

function understood(page: Live, measurement: Measurement): TemplateResult | typeof nothing {
  const { file, reading } = measurement
  if (!file) return nothing
  // The fields of the files stay in their places while a fit begins, and so does the focus.
  return html`${files(page, measurement)}${reading ? found(page, reading) : nothing}`
}

/** What the reader made of the record that is shown. */
function found({ words }: Live, reading: Reading): TemplateResult {
  const { data } = words.say
  const [run, count] = reading.run
  const rows = words.fill(data.rows, { count: reading.y.length, what: data.kinds[reading.measured] })
  const told = (sentence: string) => {
    const own = inLanguage(sentence, words.language)
    // What is not in the table is said in English.
    return html`<span lang=${own === sentence ? 'en' : nothing}>${own}</span>`
  }
  const sentences = [
    ...reading.understood.map((each) => html`<li>${told(each)}</li>`),
    ...reading.dropped.map((each) => html`<li>${data.dropped}: ${told(each)}</li>`),
  ]
  return html`<p class="small" id="data-rows">${rows}${count > 1 ? html`, ${words.fill(data.ofRuns, { run, count })}` : nothing}</p>
    <h2>${data.understood}</h2>
    <ul class="said" id="data-understood" role="list" aria-label=${data.understood}>${sentences}</ul>`
}

export function dataSource(page: Live, measurement: Measurement): TemplateResult {
  return html`${source(page, measurement)}${understood(page, measurement)}
    ${measurement.file ? correct(page, measurement) : nothing}${known(page, measurement)}`
}
