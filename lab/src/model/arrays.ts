// Where the numbers of a study go: into new arrays, or while a control is held into those of the frame before, so that a drag
// leaves nothing to be collected.

export interface Arrays {
  next(length: number): Float64Array
}

export const newArrays: Arrays = { next: (length) => new Float64Array(length) }

export class KeptArrays implements Arrays {
  #kept = new Float64Array(0)
  #used = 0

  /** What was given out before is free. */
  begin(): Arrays {
    this.#used = 0
    return this
  }

  /** Another object each time, so that what is remembered of an array is of its numbers. */
  next(length: number): Float64Array {
    if (this.#used + length > this.#kept.length) {
      this.#kept = new Float64Array(2 * (this.#used + length))
      this.#used = 0
    }
    this.#used += length
    return this.#kept.subarray(this.#used - length, this.#used)
  }
}
