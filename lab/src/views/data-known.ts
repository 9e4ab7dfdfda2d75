// What is stated in Data: columns with their units, and what is known of the pendulum: a length, gravity, or the parts of a rigid one.

import { html, nothing, type TemplateResult } from 'lit-html'
import { iconButton, switches } from '../controls/parts'
import {
  FIELDS,
  type FieldName,
  isBad,
  isBadPart,
  KNOWN,
  MODELS,
  NEW_PART,
  type PartEntry,
  type PartField,
  ROLES,
  SHAPES,
} from '../entries'
import { rich } from '../language/rich'
import type { Measurement } from '../measurement'
import { entryField, entryLine, entryPair, notANumber, select } from './data-fields'
import type { Live } from './page'

function field(measurement: Measurement, name: FieldName, label: string, unit = ''): TemplateResult {
  const text = measurement.entries[name]
  return entryField({
    id: `data-${name}`,
    label,
    text,
    bad: isBad(name, text),
    unit,
    type: (typed) => measurement.type({ [name]: typed }),
    enter: () => measurement.entered(),
  })
}

/** Columns, units, rate and run: where what was understood is not so. */
export function correct(page: Live, measurement: Measurement): TemplateResult {
  const { data } = page.words.say
  const row = (role: (typeof ROLES)[number]) => {
    const name = data.roles[role]
    return html`<tr><th scope="row">${name}</th><td>${field(measurement, `column-${role}`, `${name}: ${data.column}`)}</td>
      <td>${field(measurement, `unit-${role}`, `${name}: ${data.unit}`)}</td></tr>`
  }
  return html`<details id="data-correct" ?open=${measurement.asked}><summary>${data.correct}</summary><p class="soft small">${data.correctHelp}</p>
    <table class="roles"><thead><tr><th scope="col">${data.role}</th><th scope="col">${data.column}</th><th scope="col">${data.unit}</th></tr></thead>
    <tbody>${ROLES.map(row)}</tbody></table>
    ${entryLine(data.rate, field(measurement, 'rate', data.rate))}${entryLine(data.run, field(measurement, 'run', data.run))}</details>`
}

function part(page: Live, measurement: Measurement, now: PartEntry, place: number): TemplateResult {
  const { data, units } = page.words.say
  const { parts } = measurement.entries
  const changed = (patch: Partial<PartEntry>) => ({
    parts: parts.map((each, i) => (i === place ? { ...each, ...patch } : each)),
  })
  const name = `${data.shapes[now.shape]} ${place + 1}`
  const label = (of: PartField) => (now.shape === 'rod' && of === 'size' ? data.rodLength : data.partFields[of])
  const one = (of: PartField) =>
    entryLine(
      label(of),
      entryField({
        id: `data-part-${place}-${of}`,
        label: `${name}: ${label(of)}`,
        text: now[of],
        bad: isBadPart(now, of),
        unit: of === 'mass' ? units.kg : units.m,
        type: (typed) => measurement.type(changed({ [of]: typed })),
        enter: () => measurement.entered(),
      }),
    )
  const remove = () => measurement.enter({ parts: parts.filter((_, i) => i !== place) })
  return html`<li class="part"><div class="entry">${select(
    `data-part-${place}`,
    `${data.shape} ${place + 1}`,
    SHAPES,
    now.shape,
    (each) => data.shapes[each],
    (shape) => measurement.enter(changed({ shape })),
  )}${parts.length > 1 ? iconButton(`${data.remove}: ${name}`, 'close', remove) : nothing}</div>
    ${FIELDS[now.shape].map(one)}</li>`
}

function parts(page: Live, measurement: Measurement): TemplateResult {
  const { data } = page.words.say
  const now = measurement.entries.parts
  return html`<p class="soft small">${rich(data.partsHelp)}</p><ul role="list">${now.map((each, i) => part(page, measurement, each, i))}</ul>
    <button type="button" class="button quiet" id="data-add-part" @click=${() => measurement.enter({ parts: [...now, { ...NEW_PART, shape: 'point' }] })}>${data.addPart}</button>`
}

/** Bob, wire and air of a simple pendulum. */
function corrections(page: Live, measurement: Measurement): TemplateResult {
  const { data, units } = page.words.say
  const line = (name: 'bobRadius' | 'bobMass' | 'wireMass', unit: string) =>
    entryLine(data[name], field(measurement, name, data[name], unit))
  return html`<details id="data-bob"><summary>${data.bob}</summary><p class="soft small">${data.bobHelp}</p>
    ${line('bobRadius', units.m)}${line('bobMass', units.kg)}${line('wireMass', units.kg)}</details>`
}

export function known(page: Live, measurement: Measurement): TemplateResult {
  const { data, units } = page.words.say
  const { entries } = measurement
  const which = entries.known
  const unit = units[which === 'length' ? 'm' : 'm/s2']
  const value = () =>
    which === 'parts'
      ? parts(page, measurement)
      : entryLine(
          data[which],
          entryPair(field(measurement, which, data[which]), field(measurement, `${which}U`, data[`${which}U`], unit)),
        )
  return html`<h2>${data.known}</h2>
    ${switches(
      data.known,
      KNOWN.map((each) => ({ value: each, text: data[each] })),
      which,
      (each) => measurement.enter({ known: each }),
    )}
    ${value()}
    ${entryLine(
      data.model,
      select(
        'data-model',
        data.model,
        MODELS,
        entries.model,
        (each) => data.models[each],
        (model) => measurement.enter({ model }),
      ),
    )}
    ${which === 'parts' ? nothing : corrections(page, measurement)}
    ${notANumber(page, measurement.bad)}`
}
