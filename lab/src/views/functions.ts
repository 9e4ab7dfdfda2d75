// What sn, cn and dn are: lengths in an ellipse, whose x is the chord of the pendulum, and their graph; all at one time.

import { html, nothing, type TemplateResult } from 'lit-html'
import type { TableSpec } from '../columns'
import { afterKey, dragging } from '../controls/slide'
import { CHORD_BOX, chordAngle, chordDrawing, chordSpot } from '../draw/chord'
import { ELLIPSE_BOX, ellipseAngle, ellipseDrawing, ellipseSpot } from '../draw/ellipse'
import { placedLabels } from '../draw/labels'
import { plot } from '../draw/plot'
import { linearScale, type Tick } from '../draw/scale'
import {
  argumentAt,
  type Graph,
  graphOf,
  heightOf,
  type Instant,
  instantAt,
  type Swing,
  shorteningOf,
  swingOf,
  timeAtAngle,
} from '../ellipse'
import { plain, rich } from '../language/rich'
import { degrees, radians } from '../number'
import { type Window, windowOf } from '../study'
import { chart } from './chart'
import type { PlotSize } from './chart-spec'
import { ellipseValues } from './ellipse-values'
import type { Live } from './page'
import { player } from './player'

interface Shown {
  readonly swing: Swing
  readonly now: Instant
  readonly window: Window
  readonly graph: Graph
}

/** A handle over a drawing: a slider whose picture is its place. */
interface Knob {
  readonly className: string
  readonly box: { readonly width: number; readonly height: number }
  readonly at: { readonly x: number; readonly y: number }
  readonly label: string
  readonly least: number
  readonly most: number
  readonly now: number
  readonly text: string
  readonly radius: number
  /** In the units of the box. */
  readonly move: (x: number, y: number) => void
  readonly step: number
  readonly value: number
  readonly set: (value: number) => void
  readonly held: string
}

function knob({ store }: Live, spec: Knob): TemplateResult {
  const { box, at, radius } = spec
  const drag = dragging({
    begin: () => store.setSession({ held: spec.held }),
    at: (x, y, element) => {
      const drawing = (element as SVGElement).ownerSVGElement
      if (!drawing) return
      const area = drawing.getBoundingClientRect()
      const scale = box.width / area.width
      spec.move((x - area.left) * scale, (y - area.top) * scale)
    },
    end: () => store.setSession({ held: null }),
  })
  const keys = (event: KeyboardEvent) => {
    const next = afterKey(event, { value: spec.value, least: spec.least, most: spec.most, step: spec.step })
    if (next === null) return
    event.preventDefault()
    event.stopPropagation()
    spec.set(next)
  }
  return html`<svg class="bob-drawing" viewBox="0 0 ${box.width} ${box.height}"><g class="bob-handle ${spec.className}" role="slider" tabindex="0" aria-label=${spec.label}
    aria-valuemin=${spec.least} aria-valuemax=${spec.most} aria-valuenow=${spec.now} aria-valuetext=${spec.text} transform="translate(${at.x.toFixed(2)} ${at.y.toFixed(2)})"
    @pointerdown=${drag} @keydown=${keys}><circle class="reach-target" r="16"/><circle class="bob" r=${radius}/></g></svg>`
}

function seek({ store }: Live, { from, to }: Window, t: number): void {
  store.clock.pause()
  store.seek(Math.max(0, Math.min(Math.max(t, from), to - 1e-6 * (to - from))))
}

/** A number of the page with all its digits beside those that are shown, so that what is claimed can be checked. */
function figure(page: Live, name: string, value: number): TemplateResult {
  return html`<span class="figure-value" data-number=${name} data-exact=${String(value)}>${page.words.fixed(value, 4)}</span>`
}

const residual = ({ words }: Live, value: number): string => (value === 0 ? '0' : words.significant(value, 2))

/** sn, cn and dn in words: the picture for who does not see it. */
function threeNumbers({ words }: Live, { u, sn, cn, dn }: Instant): string {
  const fixed = (value: number) => words.fixed(value, 4)
  return words.fill(words.say.functions.three, { u: fixed(u), sn: fixed(sn), cn: fixed(cn), dn: fixed(dn) })
}

function ellipseFigure(page: Live, { swing, now, window, graph }: Shown): TemplateResult {
  const { words, store, t } = page
  const { functions } = words.say
  const { parameter } = swing
  const { place, sn, cn, dn, difference } = now
  const shortening = shorteningOf(parameter)
  const height = heightOf(parameter)
  const spec = { ...place, sn, cn, height, shortening, text: (value: number) => words.given(Number(value.toFixed(2))) }
  const handle = knob(page, {
    className: 'ellipse-handle',
    box: ELLIPSE_BOX,
    at: ellipseSpot(spec),
    label: functions.point,
    least: window.from,
    most: window.to,
    now: store.clock.playing ? window.from : Number(t.toFixed(3)),
    text: threeNumbers(page, now),
    radius: 8,
    move: (x, y) => seek(page, window, timeAtAngle(graph, ellipseAngle(x, y, spec))),
    step: (window.to - window.from) / 100,
    value: t,
    set: (next) => seek(page, window, next),
    held: 'time',
  })
  const unit =
    shortening === 1 ? functions.equation : words.fill(functions.shortened, { times: words.given(shortening) })
  return html`<figure class="drawing ellipse-figure" aria-label=${plain(functions.ellipse)}>
    <div class="head"><h2>${functions.ellipse} <span class="unit">${rich(unit)}</span></h2></div>
    <div class="drawing-box"><svg viewBox="0 0 ${ELLIPSE_BOX.width} ${ELLIPSE_BOX.height}" aria-hidden="true">${ellipseDrawing(spec)}</svg>${handle}</div>
    <div class="equations" aria-hidden="true"><span>${rich('sn _u_')}</span><span class="soft">${rich(words.formula('= sin _φ_ = _y_/_r_'))}</span>${figure(page, 'sn', place.y / place.r)}
      <span>${rich('cn _u_')}</span><span class="soft">${rich('= cos _φ_ = _x_/_r_')}</span>${figure(page, 'cn', place.x / place.r)}
      <span>${rich('dn _u_')}</span><span class="soft">${rich('= 1/_r_')}</span>${figure(page, 'dn', 1 / place.r)}
      <small class="soft" data-number="difference" data-exact=${String(difference)} data-sn=${String(sn)} data-cn=${String(cn)} data-dn=${String(dn)}>${rich(words.fill(functions.difference, { size: residual(page, difference) }))}</small></div>
    <figcaption class="unseen">${store.clock.playing ? nothing : `${threeNumbers(page, now)} ${words.fill(functions.lengths, { x: words.fixed(place.x, 4), y: words.fixed(place.y, 4), r: words.fixed(place.r, 4) })}`}</figcaption>
  </figure>`
}

function chordFigure(page: Live, { swing, now }: Shown): TemplateResult {
  const { words, store, motion, state } = page
  const { functions, units, drawing } = words.say
  const { theta, chord, projection, place } = now
  const { length } = motion.setup
  const release = (angle: number) => {
    store.clock.pause()
    store.draft('amplitude', null)
    store.set({ theta0: radians(angle), velocity0: 0, t: 0 })
  }
  const begun = degrees(state.theta0)
  const handle = knob(page, {
    className: 'chord-handle',
    box: CHORD_BOX,
    at: chordSpot(theta),
    label: drawing.bob,
    least: -179,
    most: 179,
    now: begun,
    text: words.fill(drawing.bobText, { angle: words.typed(begun) }),
    radius: 10,
    move: (x, y) => release(Math.min(179, Math.max(-179, Math.round(degrees(chordAngle(x, y)))))),
    step: 1,
    value: begun,
    set: release,
    held: 'bob',
  })
  const rest = chord - projection
  const metres = words.with(residual(page, rest), units.m)
  return html`<figure class="drawing chord-figure" aria-label=${plain(functions.pendulum)}>
    <div class="head"><h2>${functions.pendulum} <span class="unit">${rich('_θ_')} = ${words.angle(theta, 1)}</span></h2></div>
    <div class="drawing-box"><svg viewBox="0 0 ${CHORD_BOX.width} ${CHORD_BOX.height}" aria-hidden="true">${chordDrawing({ angle: theta, reach: motion.thetaMax, chord: functions.chord })}</svg>${handle}</div>
    <div class="equations" aria-hidden="true"><span>${rich(functions.chordOver)}</span><span class="soft">${rich(words.formula('= sin(_θ_/2)'))}</span>${figure(page, 'chord', chord / (2 * length))}
      <span>${rich('_k x_')}</span><span class="soft">= ${words.fixed(swing.k, 4)} × ${words.fixed(place.x, 4)}</span>${figure(page, 'kx', projection / (2 * length))}
      <small class="soft" data-number="rest" data-exact=${String(rest)}>${rich(words.fill(functions.rest, { rest: metres }))}</small></div>
    <figcaption class="unseen">${
      store.clock.playing
        ? nothing
        : words.fill(functions.chordCaption, {
            angle: words.angle(theta, 1),
            chord: words.with(words.fixed(chord, 4), units.m),
          })
    }</figcaption>
  </figure>`
}

/** Multiples of K in the window of u. */
function quarterTicks({ quarter }: Swing, from: number, to: number): Tick[] {
  const ticks: Tick[] = []
  for (let i = Math.ceil(from / quarter - 1e-6); i <= Math.floor(to / quarter + 1e-6); i++) {
    ticks.push({
      value: i * quarter,
      text: i === 0 ? '0' : i === 1 ? '_K_' : i === -1 ? '−_K_' : `${String(i).replace('-', '−')}_K_`,
    })
  }
  return ticks
}

const NAMES = ['sn', 'cn', 'dn'] as const

function draw(page: Live, { swing, now, window, graph }: Shown, size: PlotSize): TemplateResult {
  const { words } = page
  const { width, height, rem } = size
  const ends = [argumentAt(swing, window.from), argumentAt(swing, window.to)] as const
  const sx = linearScale(ends, [0, width])
  const sy = linearScale([-1.12, 1.12], [height, 0])
  const x = graph.u
  const curves = [
    { x, y: graph.cosine, clothes: 'c-linear', text: '' },
    ...NAMES.map((name) => ({ x, y: graph[name], clothes: `c-${name}`, text: name as string })),
    { x, y: graph.x, clothes: 'c-exact', text: 'x = cd' },
  ]
  return plot(
    {
      ...size,
      sx,
      sy,
      xs: quarterTicks(swing, ...ends),
      ys: [-1, -0.5, 0, 0.5, 1].map((value) => ({ value, text: words.typed(value) })),
      xLabels: true,
      lines: curves,
      labels: () =>
        placedLabels(curves, { sx, sy, width, height, letter: 0.5 * rem, line: 0.95 * rem }).map((label) => ({
          x: label.x,
          y: label.y + 0.3 * rem,
          text: label.text === 'x = cd' ? '_x_ = cd' : label.text,
          ink: true,
        })),
      now: now.u,
      dots: [...NAMES.map((name) => ({ clothes: `c-${name}`, y: now[name] })), { clothes: 'c-exact', y: now.place.x }],
    },
    [graph, words],
  )
}

function tableOf(page: Live, graph: Graph): TableSpec {
  const { words } = page
  const { functions, table } = words.say
  const column = (title: string, values: Float64Array) => ({ title, values, factor: 1, decimals: 6 })
  return {
    caption: words.fill(table.caption, { plot: functions.graph, unit: functions.tableUnit }),
    file: 'functions',
    first: { title: '_u_', values: graph.u, factor: 1, decimals: 4 },
    columns: [
      { title: table.time, values: graph.times, factor: 1, decimals: 4 },
      ...NAMES.map((name) => column(name, graph[name])),
      column('_x_ = cd', graph.x),
      column(functions.cosine, graph.cosine),
    ],
  }
}

function graphChart(page: Live, shown: Shown): TemplateResult {
  const { words } = page
  const { functions } = words.say
  const { swing, graph, window, now } = shown
  return chart(page, {
    key: 'functions',
    className: 'first-chart functions-chart',
    title: functions.graph,
    unit: words.fill(functions.graphUnit, { quarter: words.fixed(swing.quarter, 3) }),
    name: functions.graph,
    height: 28.5,
    xLabels: true,
    draw: (size) => draw(page, shown, size),
    caption: words.fill(functions.caption, { m: words.fixed(swing.parameter.m, 4) }),
    spoken: threeNumbers(page, now),
    window,
    table: () => tableOf(page, graph),
    sound: () => ({ values: graph.x, low: -1, high: 1 }),
  })
}

export function functions(page: Live): TemplateResult {
  const { model, motion, t, words } = page
  const swing = swingOf(model, motion)
  if (!swing) {
    return html`<div class="function-columns none"><div class="column"><p class="soft">${words.say.functions.why}</p>${ellipseValues(page, null)}</div></div>`
  }
  const window = windowOf(motion.period, t)
  const shown = {
    swing,
    window,
    now: instantAt(model, swing, t),
    graph: graphOf(model, swing, window.from, window.to),
  }
  const quarters: number[] = []
  for (const tick of quarterTicks(swing, argumentAt(swing, window.from), argumentAt(swing, window.to))) {
    quarters.push(swing.turned + tick.value / motion.omega0)
  }
  const last = html`<span class="soft option"><span>${rich(words.say.functions.onePeriod)}</span></span>`
  return html`<div class="function-columns"><div class="column ellipse-column">${ellipseFigure(page, shown)}</div>
    <div class="column chord-column">${chordFigure(page, shown)}${ellipseValues(page, swing)}</div>
    <div class="column graph-column">${graphChart(page, shown)}${player(page, window, quarters, last)}</div></div>`
}

export function functionsSentence({ model, motion, words }: Live): string {
  const { functions: say } = words.say
  const swing = swingOf(model, motion)
  if (!swing) return motion.regime === 'rotation' ? say.rotation : say.limit
  return swing.parameter.m === 0 ? say.circle : say.sentence
}
