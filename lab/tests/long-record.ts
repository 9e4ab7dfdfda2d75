// A record of 20,000 angles in 170 s with every friction term and noise: that of fit/examples/speed.rs.

import { DampedPendulum } from 'libration'

const SPAN = 170

/** Its table; `libration` has loaded friction. */
export function longRecord(count = 20_000): string {
  const friction = { linear: 0.004, quadratic: 0.01, dry: 0.016, presliding: 0.01 }
  const pendulum = new DampedPendulum({ theta0: 1.5, omega0: 4.7, friction })
  const t = Float64Array.from({ length: count }, (_, i) => (SPAN * i) / count)
  const { theta } = pendulum.motion(t)
  let seed = 1
  const noise = () => {
    seed = (seed * 48271) % 2147483647
    return seed / 2147483647 - 0.5
  }
  const row = (angle: number, i: number) => `${(t[i] as number).toFixed(4)},${(angle + 0.003 * noise()).toFixed(6)}`
  return `t / s,angle / rad\n${Array.from(theta, row).join('\n')}\n`
}
