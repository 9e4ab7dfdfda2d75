// Modulus k, parameter m = k² and modular angle α, k = sin α, from any of them; and what the one does in the place of the other.

import type { Model, Parameter } from '../model'

export const MODULUS_NAMES = ['k', 'm', 'alpha', 'theta0'] as const
export type ModulusName = (typeof MODULUS_NAMES)[number]

export interface Modulus extends Parameter {
  readonly k: number
  /** In rad; the swing from rest at twice of it has this parameter. */
  readonly alpha: number
}

/** What may be typed: numbers of k and m, angles in rad. Below 1, where the period is infinite. */
export const MODULUS_MOST: Readonly<Record<ModulusName, number>> = {
  k: 0.999999,
  m: 0.999999,
  alpha: (Math.PI / 180) * 89.9,
  theta0: (Math.PI / 180) * 179.8,
}

export function modulusOf(name: ModulusName, value: number): Modulus {
  switch (name) {
    case 'k':
      return { k: value, m: value * value, mc: (1 - value) * (1 + value), alpha: Math.asin(value) }
    case 'm':
      return { k: Math.sqrt(value), m: value, mc: 1 - value, alpha: Math.asin(Math.sqrt(value)) }
    default: {
      const alpha = name === 'alpha' ? value : value / 2
      const k = Math.sin(alpha)
      return { k, m: k * k, mc: Math.cos(alpha) ** 2, alpha }
    }
  }
}

/** Relative errors of the period, which goes as K: by k for m, and by m for k. */
export function mistakes(model: Model, { k, m, mc }: Modulus): { readonly kForM: number; readonly mForK: number } {
  const right = model.completeK({ m, mc })
  return {
    kForM: model.completeK({ m: k, mc: mc / (1 + k) }) / right - 1,
    mForK: model.completeK({ m: m * m, mc: mc * (1 + m) }) / right - 1,
  }
}
