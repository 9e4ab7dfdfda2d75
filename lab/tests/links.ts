// The links kept in links-v1.txt, each with the state that it must open.

import { readFileSync } from 'node:fs'

export interface Kept {
  readonly link: string
  readonly state: Readonly<Record<string, unknown>>
}

export function keptLinks(): Kept[] {
  const lines = readFileSync(new URL('links-v1.txt', import.meta.url), 'utf8').split('\n')
  const pairs = lines.filter((line) => line !== '' && !line.startsWith('#'))
  if (pairs.length === 0 || pairs.length % 2 !== 0) throw new Error('links-v1.txt has no pairs of link and state')
  return Array.from({ length: pairs.length / 2 }, (_, i) => ({
    link: pairs[2 * i] as string,
    state: JSON.parse(pairs[2 * i + 1] as string) as Kept['state'],
  }))
}
