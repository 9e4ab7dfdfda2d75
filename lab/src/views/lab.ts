// The Lab: pendulum and values, angle, error and energy over one axis of time, and the list of curves beside them.

import { html, nothing, type TemplateResult } from 'lit-html'
import { rememberedStudy, type Study, spanOf, windowOf } from '../study'
import { alarmText, angleChart } from './angle'
import { bench } from './bench'
import { compareList } from './compare'
import { energyChart } from './energy'
import { errorChart } from './error'
import type { Live } from './page'
import { player, spanSwitch } from './player'
import { portraitChart } from './portrait'
import { periodMarks } from './time-axis'

/** The study of the page as it is; made again only when something but the time has changed. */
function studyOf({ motion, state, t, session }: Live): Study {
  const { from, to } = windowOf(spanOf(state, motion), t)
  const quick = session.held !== null && session.held !== 'time'
  return rememberedStudy(motion, state.curves, from, to, quick)
}

/** What is wrong with a curve shown, for the screen reader. */
export const labAlarm = (page: Live): string => alarmText(page, studyOf(page))

/** A long list leaves the portrait no room. */
function crowding(rows: number): string {
  return rows > 5 ? 'very-crowded' : ''
}

export function lab(page: Live): TemplateResult {
  const study = studyOf(page)
  const { t, session, state } = page
  const ghosts = study.shown.map(({ clothes, key, solution }) => ({
    clothes,
    angle: solution.theta(t),
    faded: session.pointed !== null && session.pointed !== key,
  }))
  return html`<div class="columns lab-columns">${bench(page, ghosts)}
    <div class="column middle">${angleChart(page, study)}${errorChart(page, study)}${state.hide ? nothing : energyChart(page, study)}${player(page, study.window, state.hide ? [] : periodMarks(study), spanSwitch(page))}</div>
    <div class="column right ${crowding(study.rows.length)}">${compareList(page, study)}${portraitChart(page)}</div>
  </div>`
}
