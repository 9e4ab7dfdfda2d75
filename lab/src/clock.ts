// The clock of the page: time is evaluated from a true clock, never stepped, so that no frame rate and no sleep changes it.
//
// A second of the pendulum is a second on the wall at speed 1. `read` is the wall's clock in ms.

export class Clock {
  #t: number
  #since: number | null = null
  #speed: number

  constructor(
    t = 0,
    speed = 1,
    private readonly read: () => number = () => performance.now(),
  ) {
    this.#t = t
    this.#speed = speed
  }

  get playing(): boolean {
    return this.#since !== null
  }

  get speed(): number {
    return this.#speed
  }

  /** Time of the pendulum in s. */
  get t(): number {
    return this.#since === null ? this.#t : this.#t + (this.#speed * (this.read() - this.#since)) / 1000
  }

  play(): void {
    if (this.#since === null) this.#since = this.read()
  }

  pause(): void {
    this.#t = this.t
    this.#since = null
  }

  /** Goes to a time; goes on playing if it was. */
  seek(t: number): void {
    this.#t = Math.max(0, t)
    if (this.#since !== null) this.#since = this.read()
  }

  set speed(speed: number) {
    this.seek(this.t)
    this.#speed = speed
  }
}
