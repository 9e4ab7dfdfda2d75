// Links of earlier versions open the same state.

import { expect, it } from 'vitest'
import { readLink, writeLink } from '../src/link'
import { keptLinks } from './links'

it.each(keptLinks())('$link', ({ link, state }) => {
  const opened = readLink(link)
  expect(opened.faults).toEqual([])
  expect(opened.state).toMatchObject(state)
  expect(readLink(writeLink(opened.state)).state).toEqual(opened.state)
})
