// The displacement of a spring over time: two periods, or up to its escape and a little beyond, where nothing is.

import { html, nothing, type TemplateResult } from 'lit-html'
import type { TableSpec } from '../columns'
import { plot } from '../draw/plot'
import { linearScale } from '../draw/scale'
import { rich } from '../language/rich'
import { remember } from '../memory'
import type { SpringOrbit } from '../model/spring'
import { roundTicksOf } from './axis-ticks'
import { chart } from './chart'
import type { PlotSize } from './chart-spec'
import type { SpringView } from './spring-view'

const POINTS = 600

const trackOf = remember((orbit: SpringOrbit, span: number) => {
  const { escapeTime } = orbit
  // Ever closer towards an escape, where the curve is steepest; the last point is the escape itself, and no number.
  const part = (i: number) => i / POINTS
  const times = Number.isFinite(escapeTime)
    ? Float64Array.from({ length: POINTS + 1 }, (_, i) => escapeTime * (1 - (1 - part(i)) ** 2))
    : Float64Array.from({ length: POINTS + 1 }, (_, i) => span * part(i))
  return { times, ...orbit.sample(times) }
})

function draw({ page, orbit, axes, now }: SpringView, size: PlotSize): TemplateResult {
  const { width, height, rem } = size
  const { words, t } = page
  const { escapeTime } = orbit
  const escapes = Number.isFinite(escapeTime)
  const { times, u } = trackOf(orbit, axes.span)
  const sx = linearScale([0, axes.span], [0, width])
  const sy = linearScale(axes.times, [height, 0])
  const { period } = orbit
  const marks = escapes
    ? [{ x: escapeTime, text: '∞' }]
    : Number.isFinite(period) && orbit.regime !== 'rest'
      ? [{ x: period, text: '_T_' }]
      : []
  return plot(
    {
      ...size,
      sx,
      sy,
      xs: roundTicksOf(words, 0, axes.span, width < 26 * rem ? 5 : 7),
      ys: roundTicksOf(words, ...axes.times, 7),
      xLabels: true,
      lines: [{ x: times, y: u, clothes: 'c-exact' }],
      hatched: escapes ? [[escapeTime, axes.span]] : [],
      verticals: marks,
      now: t,
      dots: Number.isNaN(now.u) ? [] : [{ clothes: 'c-exact', y: now.u }],
    },
    [orbit, axes, words],
  )
}

function tableOf({ page, orbit, axes }: SpringView): TableSpec {
  const { words } = page
  const { spring, table } = words.say
  const { times, u, velocity } = trackOf(orbit, axes.span)
  return {
    caption: words.fill(table.caption, { plot: spring.tableTime, unit: '1' }),
    file: 'spring-time',
    first: { title: '_t_', values: times, factor: 1, decimals: 3 },
    columns: [
      { title: '_u_', values: u, factor: 1, decimals: 4 },
      { title: "_u'_", values: velocity, factor: 1, decimals: 4 },
    ],
  }
}

export function springTime(view: SpringView): TemplateResult {
  const { page, orbit, axes } = view
  const { words } = page
  const { spring } = words.say
  const escapes = Number.isFinite(orbit.escapeTime)
  const reason = words.fill(spring.hatched, { time: words.fixed(orbit.escapeTime, 3) })
  const to = words.significant(axes.span, 3)
  return chart(page, {
    key: 'spring-time',
    className: 'spring-time',
    title: spring.time,
    unit: spring.timeUnit,
    name: spring.time,
    height: 15,
    xLabels: true,
    window: { from: 0, to: axes.span },
    draw: (size) => draw(view, size),
    caption: `${words.fill(spring.captionTime, { to })}${escapes ? ` ${reason}` : ''}`,
    spoken: `${words.fixed(page.t, 2)}: ${words.significant(view.now.u, 3)}`,
    table: () => tableOf(view),
    sound: () => {
      const [low, high] = axes.times
      return { values: trackOf(orbit, axes.span).u.map((u) => Math.min(high, Math.max(low, u))), low, high }
    },
    note: escapes ? html`<p class="plot-note">${rich(reason)}</p>` : nothing,
  })
}
