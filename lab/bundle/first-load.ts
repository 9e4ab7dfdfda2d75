// All that the page begins with in one script. Left to itself the bundler puts what the first load shares with the later parts into a
// script of its own, which is asked for only once the first has come.

import type { Plugin } from 'vite'

const first = new Set<string>()

/** Whether a module is needed to begin: one that the entry imports, or an import of it, but not one that is asked for later. */
export const isFirst = (id: string): boolean => first.has(id)

export function firstLoad(): Plugin {
  return {
    name: 'first-load',
    apply: 'build',
    buildEnd() {
      first.clear()
      const waiting = [...this.getModuleIds()].filter((id) => this.getModuleInfo(id)?.isEntry)
      for (let id = waiting.pop(); id !== undefined; id = waiting.pop()) {
        if (first.has(id)) continue
        first.add(id)
        waiting.push(...(this.getModuleInfo(id)?.importedIds ?? []))
      }
    },
  }
}
