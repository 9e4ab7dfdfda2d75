// The licences of what is in the page besides our own: libraries and fonts, as they came, in one file beside it.

import { readdirSync, readFileSync } from 'node:fs'
import { createRequire } from 'node:module'
import type { Plugin } from 'vite'

const read = (path: string): string => readFileSync(new URL(path, import.meta.url), 'utf8').trim()

/** Name, version, address and licence of each library of package.json. */
function libraries(): string[] {
  const { dependencies } = createRequire(import.meta.url)('../package.json') as { dependencies: Record<string, string> }
  return Object.keys(dependencies)
    .filter((name) => name !== 'libration')
    .map((name) => {
      const folder = `../node_modules/${name}/`
      const { version, license } = JSON.parse(read(`${folder}package.json`)) as { version: string; license: string }
      const file = readdirSync(new URL(folder, import.meta.url)).find((each) => /^licen[cs]e/i.test(each))
      if (!file) throw new Error(`${name} comes without its licence`)
      const source = `Unchanged source: https://www.npmjs.com/package/${name}/v/${version}`
      return `${name} ${version}, ${license}\n${source}\n\n${read(`${folder}${file}`)}`
    })
}

function fonts(): string[] {
  const folder = '../src/style/fonts/'
  const files = readdirSync(new URL(folder, import.meta.url)).filter((each) => each.endsWith('.OFL.txt'))
  return files.map((each) => `Font ${each.replace('.OFL.txt', '')}\n\n${read(`${folder}${each}`)}`)
}

export function licences(): Plugin {
  return {
    name: 'licences',
    apply: 'build',
    generateBundle() {
      const source = [...libraries(), ...fonts()].join(`\n\n${'-'.repeat(78)}\n\n`)
      this.emitFile({ type: 'asset', fileName: 'licences.txt', source: `${source}\n` })
    },
  }
}
