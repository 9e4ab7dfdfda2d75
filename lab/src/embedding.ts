// What a link may do to a page that stands in another one: show a part of it, lock values, and keep gravity out of sight.
//
// A hidden g is written as its bits in another order of signs. That keeps it from the eye and from nobody who wants to know it.

import { LOCKED, SECTIONS, type Shown, type State, VIEWS, type ViewName } from './state'

/** Views in which nothing says g, nor a time or a velocity that is as good as it; and the parts of the Lab that do. */
const WITHOUT_GRAVITY: readonly Shown[] = ['lab', 'data']
const WITH_GRAVITY: readonly Shown[] = ['facts', 'energy']

type Embedding = Pick<State, 'show' | 'hide' | 'lock'>

/** Whether a view or a part may be shown where gravity is hidden. */
export function saysNothing(name: Shown): boolean {
  return WITHOUT_GRAVITY.includes(name) || (SECTIONS.includes(name as never) && !WITH_GRAVITY.includes(name))
}

/** The views that have a tab; where only parts are named it is the Lab they are of. */
export function shownViews({ show, hide }: Pick<State, 'show' | 'hide'>): readonly ViewName[] {
  const named = VIEWS.filter((name) => show.includes(name))
  const views =
    show.length === 0 ? VIEWS : named.length === 0 || shownSections({ show }) ? ['lab' as const, ...named] : named
  return VIEWS.filter((name) => views.includes(name) && (!hide || saysNothing(name)))
}

/** The parts of the Lab that are shown, for its style; null for all. */
export function shownSections({ show }: Pick<State, 'show'>): string | null {
  return show.includes('lab') ? null : show.filter((name) => SECTIONS.includes(name as never)).join(' ') || null
}

export function isLocked({ lock, hide }: Embedding, name: keyof State): boolean {
  return lock.some((each) => LOCKED[each] === name) || (hide && name === 'gravity')
}

/** Whether a change would touch what is locked or leave what is shown. */
export function isRefused(state: State, patch: Partial<State>): boolean {
  if (patch.view && !shownViews(state).includes(patch.view)) return true
  const names = Object.keys(patch) as (keyof State)[]
  return names.some((name) => isLocked(state, name) && !Object.is(patch[name], state[name]))
}

const MASK = 0x5deece66d1b54a35n

/** The double as text that says nothing to the eye. */
export function coded(value: number): string {
  const [bits = 0n] = new BigUint64Array(Float64Array.of(value).buffer)
  return `~${(bits ^ MASK).toString(36)}`
}

/** The double of such a text; NaN if it is none. */
export function fromCode(text: string): number {
  if (!/^~[0-9a-z]{1,13}$/.test(text)) return Number.NaN
  let bits = 0n
  for (const letter of text.slice(1)) bits = 36n * bits + BigInt(Number.parseInt(letter, 36))
  return new Float64Array(BigUint64Array.of(bits ^ MASK).buffer)[0] as number
}

/** The code that puts a link of the page into another page. */
export function embedCode(link: string, width: number, height: number): string {
  return `<iframe src="${link.replaceAll('&', '&amp;')}" width="${width}" height="${height}" style="border:0" title="libration"></iframe>`
}
