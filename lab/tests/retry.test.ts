// A part that is lost is asked for again, and not for ever.

import { expect, it } from 'vitest'
import { retried } from '../src/retry'

/** Fails so many times. */
function failing(times: number) {
  let asked = 0
  return {
    ask: async () => {
      asked++
      if (asked <= times) throw new Error(`lost ${asked}`)
      return 'part'
    },
    asked: () => asked,
  }
}

it('asks once for what comes, again for what is lost, and says the last failure', async () => {
  for (const [times, tries] of [
    [0, 1],
    [2, 3],
  ] as const) {
    const { ask, asked } = failing(times)
    expect(await retried(ask)).toBe('part')
    expect(asked()).toBe(tries)
  }
  const { ask, asked } = failing(9)
  await expect(retried(ask)).rejects.toThrow('lost 3')
  expect(asked()).toBe(3)
})
