// Numbers from a seed, in 32-bit integers alone, so that every machine draws the same: xorshift (Marsaglia 2003, J. Stat. Softw. 8,
// 14), begun with the seed as a finalizer mixes it (MurmurHash3), so that seeds beside one another have nothing in common.

export class Draws {
  #state: number

  constructor(seed: number) {
    let mixed = (seed + 0x9e3779b9) | 0
    mixed = Math.imul(mixed ^ (mixed >>> 16), 0x85ebca6b)
    mixed = Math.imul(mixed ^ (mixed >>> 13), 0xc2b2ae35)
    // Zero is the one state that xorshift never leaves.
    this.#state = (mixed ^ (mixed >>> 16)) | 0 || 1
  }

  #next(): number {
    let bits = this.#state
    bits ^= bits << 13
    bits ^= bits >>> 17
    bits ^= bits << 5
    this.#state = bits
    return bits >>> 0
  }

  /** A whole number from the least to the most, in steps. */
  between(least: number, most: number, step = 1): number {
    return least + step * (this.#next() % (Math.floor((most - least) / step) + 1))
  }
}
