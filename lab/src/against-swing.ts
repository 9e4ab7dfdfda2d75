// Periods against the turning angle: where each measured one stands by the fit, and the exact law (2/π) T₀ K through them.

import type { Points } from './draw/curve'
import type { Model } from './model'
import type { Estimate, Result } from './model/fit-protocol'

/** T₀ = 2π/ω₀ in s, of swings so small that their size does not count. */
export function smallPeriod({ value, u }: Pick<Estimate, 'value' | 'u'>): {
  readonly value: number
  readonly u: number
} {
  const period = (2 * Math.PI) / value
  return { value: period, u: (period * u) / value }
}

/** Points of the curve. */
const POINTS = 161

/** The law at the fitted ω₀ and friction over the angles of the points, in rad and s, where the core has the exact ratio yet. */
export function lawOf(model: Model, angles: Float64Array, { fit }: Result): Points | null {
  if (!model.complete || angles.length === 0) return null
  const [least, most] = [Math.min(...angles), Math.max(...angles)]
  const x = Float64Array.from({ length: POINTS }, (_, i) => least + ((most - least) * i) / (POINTS - 1))
  // A table's angles are those that were read; the rest may be elsewhere.
  const rest = fit.offset?.value ?? 0
  const ratio = model.periodRatio(
    'exact',
    x.map((each) => Math.abs(each - rest)),
  )
  // Friction makes small swings slower: ω² = ω₀² − γ².
  const friction = fit.friction.linear?.value ?? 0
  const { value } = smallPeriod({ value: Math.sqrt(fit.omega0.value ** 2 - friction ** 2), u: 0 })
  return { x, y: ratio.map((each) => each * value) }
}
