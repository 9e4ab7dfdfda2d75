// The part of the page that needs no script: what to do when none runs, and the periods as a table, computed at the build.

import { readFile } from 'node:fs/promises'
import { createRequire } from 'node:module'
import type { Plugin } from 'vite'

const AMPLITUDES = [10, 30, 60, 90, 120, 150, 170, 179]

/** T/T0 by the core, in Node. */
async function periods(): Promise<string> {
  const { load, loadSecond, approx } = await import('libration')
  const place = createRequire(import.meta.url)
  const bytes = await readFile(place.resolve('libration/libration-scalar.wasm'))
  await load({ scalar: bytes, simd: bytes })
  await loadSecond(await readFile(place.resolve('libration/libration-second.wasm')))
  const exact = approx.period('exact')
  const head = AMPLITUDES.map((each) => `<th scope="col">${each}°</th>`).join('')
  const cells = AMPLITUDES.map(
    (each) => `<td>${exact.ratio({ thetaMax: (each * Math.PI) / 180 }).toFixed(4)}</td>`,
  ).join('')
  return `<table class="data"><caption>Period over the period of small swings, T/T₀, by release angle.</caption><thead><tr><th scope="col">angle</th>${head}</tr></thead><tbody><tr><th scope="row">T/T₀</th>${cells}</tr></tbody></table>`
}

async function still(): Promise<string> {
  return `<div class="no-script"><h1 class="sentence">The exact pendulum</h1>
<p>If nothing else appears here, the browser has not started the script of this page. Scripts may be switched off, or modules of JavaScript may be blocked.
<a href="offline.html">The offline file</a> is one page without modules: it may work where this one does not. The table needs neither.</p></div>
${await periods()}`
}

export function stillPage(build: boolean): Plugin {
  return {
    name: 'still-page',
    async transformIndexHtml(html) {
      return build ? html.replace('<!-- still -->', await still()) : html
    },
  }
}
