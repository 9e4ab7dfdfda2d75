// The small plot of the portrait: the angle of every orbit over time, counted on through whole turns.

import { html, type TemplateResult } from 'lit-html'
import { extent } from '../draw/curve'
import { plot } from '../draw/plot'
import { degreeTicks, linearScale } from '../draw/scale'
import { rich } from '../language/rich'
import { remember } from '../memory'
import type { Motion } from '../model'
import { DEGREES } from '../number'
import { letterOf, placeOf } from '../orbits'
import { evenTimes, type Window } from '../study'
import { chart } from './chart'
import type { PlotSize } from './chart-spec'
import type { Live } from './page'
import { timeScale, timeText, timeTicks } from './time-axis'

const POINTS = 480

interface Angles {
  readonly times: Float64Array
  readonly all: readonly Float64Array[]
}

let last: { motions: readonly Motion[]; from: number; to: number; angles: Angles } | null = null

/** Kept while the orbits are the same ones. */
function anglesOf(motions: readonly Motion[], { from, to }: Window): Angles {
  const same = last && last.motions.length === motions.length && motions.every((each, i) => each === last?.motions[i])
  if (last && same && last.from === from && last.to === to) return last.angles
  const times = evenTimes({ from, to }, POINTS)
  const angles = { times, all: motions.map((each) => each.sample(times).theta) }
  last = { motions, from, to, angles }
  return angles
}

/** In degrees: the chosen orbit fills it; a circle at least where it swings wide. */
export function domainOf(theta: Float64Array): [number, number] {
  const [low, high] = extent(theta)
  const ends = [low * DEGREES, high * DEGREES] as const
  if (ends[0] > -181 && ends[1] < 181) {
    const reach = Math.max(-ends[0], ends[1], 10)
    return reach > 100 ? [-190, 190] : [-1.08 * reach, 1.08 * reach]
  }
  const margin = 0.05 * (ends[1] - ends[0])
  return [ends[0] - margin, ends[1] + margin]
}

/** Where a letter stands on its curve: inside the frame and away from those before it. */
const places = remember((angles: Angles, low: number, high: number): (number | null)[] => {
  const used: { x: number; y: number }[] = []
  const room = 0.04 * (high - low)
  return angles.all.map((theta, k) => {
    const count = theta.length - 1
    for (let j = 0; j < 24; j++) {
      const i = Math.round(count * (((0.3 + 0.23 * k + 0.083 * j) % 0.9) + 0.05))
      const y = (theta[i] as number) * DEGREES
      const x = i / count
      if (y < low + room || y > high - room) continue
      if (used.some((each) => Math.abs(each.x - x) < 0.09 && Math.abs(each.y - y) < 3 * room)) continue
      used.push({ x, y })
      return i
    }
    return null
  })
})

function draw(page: Live, motions: readonly Motion[], window: Window, size: PlotSize): TemplateResult {
  const { words, t, state } = page
  const angles = anglesOf(motions, window)
  const chosen = placeOf(state)
  const own = angles.all[chosen] as Float64Array
  const [low, high] = domainOf(own)
  const sx = timeScale(window, size)
  const sy = linearScale([low, high], [size.height, 0])
  const where = places(angles, low, high)
  const labels = where.flatMap((i, place) =>
    i === null
      ? []
      : [
          {
            x: sx(angles.times[i] as number),
            y: sy(((angles.all[place] as Float64Array)[i] as number) * DEGREES) + 0.3 * size.rem,
            text: `*${letterOf(place)}*`,
            ink: true,
          },
        ],
  )
  const lines = angles.all.map((y, place) => ({
    x: angles.times,
    y,
    clothes: place === chosen ? 'c-exact' : 'c-orbit',
    factor: DEGREES,
  }))
  return plot(
    {
      ...size,
      sx,
      sy,
      xs: timeTicks(words, window, size),
      ys: degreeTicks(low, high, 5).map((value) => ({ value, text: `${words.typed(value)}°` })),
      xLabels: true,
      lines: [...lines.filter((_, place) => place !== chosen), lines[chosen] as (typeof lines)[number]],
      labels,
      now: t,
      dots: [{ clothes: 'c-exact', y: page.motion.theta(t) * DEGREES }],
    },
    [angles, chosen, words, sy.key],
  )
}

export function orbitAngle(page: Live, motions: readonly Motion[], window: Window): TemplateResult {
  const { words, state, t, motion } = page
  const { phase, table } = words.say
  const letter = letterOf(placeOf(state))
  const theta = motion.theta(t)
  const reading = words.fill(phase.reading, {
    letter,
    t: words.with(words.fixed(t, 2), words.say.units.s),
    degrees: words.angle(theta, 2),
    radians: words.with(words.fixed(theta, 4), 'rad'),
  })
  const unit = words.fill(Number.isFinite(motion.period) ? phase.angleUnit : phase.angleUnitEndless, { letter })
  const own = () => anglesOf(motions, window).all[placeOf(state)] as Float64Array
  const [low, high] = extent(own())
  return chart(page, {
    key: 'orbit-angle',
    className: 'portrait orbit-angle',
    title: phase.angle,
    unit,
    name: phase.angle,
    height: 11,
    xLabels: true,
    draw: (size) => draw(page, motions, window, size),
    caption: words.fill(phase.captionAngle, {
      letter,
      from: timeText(words, window.from),
      to: timeText(words, window.to),
      least: words.angle(low, 1),
      most: words.angle(high, 1),
    }),
    spoken: `${timeText(words, t)}, ${words.angle(theta, 1)}`,
    window,
    table: () => {
      const { times, all } = anglesOf(motions, window)
      return {
        caption: words.fill(table.caption, { plot: phase.angle, unit: '°' }),
        file: 'orbits',
        first: { title: table.time, values: times, factor: 1, decimals: 3 },
        columns: all.map((values, place) => ({ title: letterOf(place), values, factor: DEGREES, decimals: 2 })),
      }
    },
    sound: () => ({ values: own(), low, high }),
    note: html`<p class="plot-note reading-line" aria-hidden="true">${rich(reading)}</p>`,
  })
}
