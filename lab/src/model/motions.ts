// The module of springs and friction: asked for once, when one of their views opens.

import { loadMotions } from 'libration'

export type Phase = 'waiting' | 'ready' | 'failed'

let phase: Phase | null = null

/** How far the module is; the first call asks for it, and `changed` is called when it has come or failed. */
export function motionsPhase(source: Parameters<typeof loadMotions>[0], changed: (phase: Phase) => void): Phase {
  if (phase !== null) return phase
  phase = 'waiting'
  void loadMotions(source)
    .then(() => {
      phase = 'ready'
    })
    .catch(() => {
      phase = 'failed'
    })
    .then(() => changed(phase as Phase))
  return phase
}

/** After a failure it is asked for again. */
export function forgetFailure(): void {
  if (phase === 'failed') phase = null
}
