// The right column of Data for several records: what they share with its budget, whether they agree, and each in a row.

import { html, nothing, type TemplateResult } from 'lit-html'
import { rich } from '../language/rich'
import type { Measurement } from '../measurement'
import type { Estimate, Joint } from '../model/fit-protocol'
import { degrees } from '../number'
import { budget, corrections, quotedOf, verdicts, withUncertainty } from './data-result'
import type { Live } from './page'

/** What all records share, and in which unit: g, the length, or ω₀. */
export function sharedOf(page: Live, { together }: Joint) {
  const { g, length, omega0 } = together
  // At several lengths there is no common ω₀, and g is the result.
  const given = omega0 === null || (g !== null && g.statistical > 0)
  return quotedOf(page, { g, length, length_given: given, omega0: omega0 as Estimate })
}

function shared(page: Live, joint: Joint): TemplateResult {
  const { words } = page
  const { data, units } = words.say
  const { omega0, length_offset: offset, chi_squared: chi } = joint.together
  const { of, unit, what } = sharedOf(page, joint)
  const row = (name: string, text: string, id: string, big = false) =>
    html`<dt class=${big ? 'big' : ''}>${rich(name)}</dt><dd class=${big ? 'big' : ''} id=${id}>${rich(text)}</dd>`
  const names = {
    g: ['_g_', 'data-g'],
    length: ['_L_', 'data-length-found'],
    omega0: [data.omega0, 'data-omega0'],
  } as const
  const [name, id] = names[what]
  return html`<dl class="facts">${row(name, words.with(withUncertainty(words, of), unit), id, true)}
    ${what !== 'omega0' && omega0 ? row(data.omega0, words.with(withUncertainty(words, omega0), units['rad/s']), 'data-omega0') : nothing}
    ${offset ? row(data.lengthOffset, words.with(withUncertainty(words, offset), units.m), 'data-offset') : nothing}
    ${chi[1] > 0 ? row('_χ_²', `${words.fixed(chi[0], chi[0] < 10 ? 2 : 0)}, _ν_ = ${chi[1]}`, 'data-chi') : nothing}</dl>`
}

function records(page: Live, { files, results }: Measurement): TemplateResult {
  const { words } = page
  const { data, units } = words.say
  return html`<h2 id="data-records-title">${data.records}</h2>
    <table class="data" id="data-records" aria-labelledby="data-records-title"><thead><tr><th scope="col">${data.record}</th><th scope="col">${rich(data.omega0)}, ${units['rad/s']}</th><th scope="col">${data.swing}</th></tr></thead>
    <tbody>${results.map(
      ({ fit }, i) =>
        html`<tr><th scope="row">${files[i]?.name}</th><td>${rich(withUncertainty(words, fit.omega0))}</td><td>${words.fixed(degrees(fit.swing ?? Number.NaN), 0)}°</td></tr>`,
    )}</tbody></table>`
}

export function dataTogether(page: Live, measurement: Measurement, joint: Joint): TemplateResult {
  const { data } = page.words.say
  const { together, stands } = joint
  const quoted = sharedOf(page, joint)
  // A record that is no pendulum's makes all of them fall.
  const fallen = measurement.results.flatMap(({ fit, grades }) =>
    fit.verdicts.filter((_, i) => grades[i] === 'refuted'),
  )
  const told = verdicts(page, {
    verdicts: [...fallen, ...together.verdicts],
    grades: [...fallen.map(() => 'refuted' as const), ...joint.grades],
  })
  return html`<h2>${data.together}</h2>${stands ? nothing : told}${shared(page, joint)}${budget(page, together.budget, quoted)}
    ${stands ? told : nothing}${corrections(page, together.corrections)}${records(page, measurement)}`
}
