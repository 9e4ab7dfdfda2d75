// The audio trace of a plot: pitch is the value, left to right is the axis, a rougher tone is below zero.

import { play, type Trace } from '../controls/sound'
import type { Store } from '../store'

export type SoundSpec = Trace

let stopNow: (() => void) | null = null

export function toggleSound(store: Store, key: string, make: (() => SoundSpec) | undefined): void {
  const running = store.session.sounding
  stopNow?.()
  stopNow = null
  if (running === key || !make) {
    store.setSession({ sounding: null })
    return
  }
  stopNow = play(make(), () => store.setSession({ sounding: null }))
  store.setSession({ sounding: key })
}
