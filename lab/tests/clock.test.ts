// The clock is true: 600 s at any frame rate, through pauses, at any speed.

import { describe, expect, it } from 'vitest'
import { Clock } from '../src/clock'

describe('the clock', () => {
  it.each([30, 60, 144])('reads 600 s after 600 s at %i frames a second', (rate) => {
    let now = 1234.5
    const clock = new Clock(0, 1, () => now)
    clock.play()
    for (let frame = 1; frame <= 600 * rate; frame++) now = 1234.5 + (1000 * frame) / rate
    expect(clock.t).toBeCloseTo(600, 9)
  })

  it('stands while it is paused and goes on from there', () => {
    let now = 0
    const clock = new Clock(2, 1, () => now)
    now = 5000
    expect(clock.t).toBe(2)
    clock.play()
    now = 6000
    clock.pause()
    now = 60_000
    expect(clock.t).toBe(3)
  })

  it('does not jump when its speed changes', () => {
    let now = 0
    const clock = new Clock(0, 1, () => now)
    clock.play()
    now = 1000
    clock.speed = 0.25
    expect(clock.t).toBe(1)
    now = 5000
    expect(clock.t).toBe(2)
  })

  it('does not go below zero', () => {
    const clock = new Clock()
    clock.seek(-1)
    expect(clock.t).toBe(0)
  })
})
