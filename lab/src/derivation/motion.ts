// Equalities of the way from the integral to θ(t): Jacobi's functions, the motion from any start, and the limit of small swings.

import { ALL, BOTH, type Equality, LIMIT, MOVING, one, SWING, square, TURN } from './equality'
import type { Moment } from './moment'

/** The point of the ellipse of the view Functions (src/ellipse.ts), whose x is cd: a quarter behind φ. */
function placeOf(now: Moment): { readonly x: number; readonly y: number } {
  const { u, quarter, parameter } = now.elliptic
  const { sn, cn } = now.jacobi(u - quarter, parameter)
  const r = 1 / Math.sqrt(square(cn) + parameter.mc * square(sn))
  return { x: r * cn, y: r * sn }
}

const inversion: Equality[] = [
  {
    id: 'sn',
    tag: 'Lima (11)',
    unit: '',
    of: BOTH,
    left: ({ elliptic }) => elliptic.sn,
    right: ({ elliptic }) => elliptic.sinPhi,
    size: one,
  },
  {
    id: 'cn',
    tag: 'Lima (11)',
    unit: '',
    of: BOTH,
    left: ({ elliptic }) => elliptic.cn,
    right: ({ elliptic }) => elliptic.cosPhi,
    size: one,
  },
  {
    id: 'dn',
    tag: 'Lima (11)',
    unit: '',
    of: BOTH,
    left: ({ elliptic }) => elliptic.dn,
    right: ({ elliptic }) => elliptic.delta,
  },
  {
    id: 'ellipse',
    tag: '',
    unit: '',
    of: SWING,
    left: (now) => {
      const { x, y } = placeOf(now)
      return square(x) + now.mc * square(y)
    },
    right: one,
  },
  {
    id: 'chord',
    tag: '',
    unit: '',
    of: SWING,
    left: ({ now }) => now.s,
    right: (now) => now.kappa * placeOf(now).x,
    size: (now) => now.kappa,
  },
  {
    id: 'sn-slope',
    tag: 'Lima (12)',
    unit: '',
    of: BOTH,
    left: (now) => now.slopeOfJacobi((sn) => sn),
    right: ({ elliptic: { cn, dn } }) => cn * dn,
    size: one,
  },
  {
    id: 'sn-second',
    tag: 'Lima (13)',
    unit: '',
    of: BOTH,
    left: (now) => now.slopeOfJacobi((_, cn, dn) => cn * dn),
    right: ({ elliptic: { sn, parameter } }) => 2 * parameter.m * sn ** 3 - (1 + parameter.m) * sn,
    size: one,
  },
]

const solution: Equality[] = [
  {
    id: 'start-sine',
    tag: 'Horsley (7)',
    unit: '',
    of: SWING,
    left: (now) => now.elliptic.k * now.jacobi(now.elliptic.u0, now.elliptic.parameter).sn,
    right: ({ start }) => start.s,
    size: (now) => now.kappa,
  },
  {
    id: 'start-cosine',
    tag: '',
    unit: '',
    of: SWING,
    left: (now) => now.elliptic.k * now.jacobi(now.elliptic.u0, now.elliptic.parameter).cn,
    right: ({ start }) => start.x,
    size: (now) => now.kappa,
  },
  {
    id: 'theta',
    tag: 'Lima (16), Horsley (3)',
    unit: 'rad',
    of: SWING,
    left: (now) => now.theta,
    // The arcsine of k sn by both its sine and its cosine, which is dn: near the top the sine alone has lost half its digits.
    right: ({ elliptic: { k, sn, dn } }) => 2 * Math.atan2(k * sn, dn),
    size: (now) => now.motion.thetaMax,
  },
  {
    id: 'velocity',
    tag: '',
    unit: 'rad/s',
    of: SWING,
    left: (now) => now.velocity,
    right: ({ omega0, elliptic: { k, cn } }) => 2 * k * omega0 * cn,
    size: ({ omega0, kappa }) => 2 * omega0 * kappa,
  },
  {
    id: 'turn-theta',
    tag: '',
    unit: 'rad',
    of: TURN,
    left: (now) => now.theta,
    right: ({ elliptic: { sign, am } }) => sign * 2 * am,
    size: () => Math.PI,
  },
  {
    id: 'turn-velocity',
    tag: '',
    unit: 'rad/s',
    of: TURN,
    left: (now) => now.velocity,
    right: ({ omega0, elliptic: { sign, k, dn } }) => (sign * 2 * omega0 * dn) / k,
  },
  {
    id: 'limit-theta',
    tag: '',
    unit: 'rad',
    of: LIMIT,
    left: (now) => now.theta,
    right: (now) => limitSign(now) * 2 * Math.atan(Math.sinh(limitArgument(now))),
    size: () => Math.PI,
  },
  {
    id: 'limit-velocity',
    tag: '',
    unit: 'rad/s',
    of: LIMIT,
    left: (now) => now.velocity,
    right: (now) => (limitSign(now) * 2 * now.omega0) / Math.cosh(limitArgument(now)),
  },
]

const limitSign = ({ start }: Moment): number => (start.x < 0 ? -1 : 1)
const limitArgument = (now: Moment): number =>
  now.omega0 * now.t + Math.asinh((limitSign(now) * now.start.s) / now.start.c)

const small: Equality[] = [
  {
    id: 'small-sn',
    tag: '',
    unit: '',
    of: MOVING,
    left: (now) => now.jacobi(now.omega0 * now.t, { m: 0, mc: 1 }).sn,
    right: ({ omega0, t }) => Math.sin(omega0 * t),
    size: one,
  },
  {
    id: 'small-period',
    tag: 'Lima, after (3)',
    unit: 's',
    of: ALL,
    left: ({ motion }) => motion.smallPeriod,
    right: ({ omega0 }) => (2 * Math.PI) / omega0,
  },
  {
    id: 'small-theta',
    tag: 'Horsley (4), Lima (3)',
    unit: 'rad',
    of: ALL,
    left: (now) => now.approximate({ name: 'linear', on: true }),
    right: ({ motion: { setup }, omega0, t }) =>
      setup.theta0 * Math.cos(omega0 * t) + (setup.velocity0 / omega0) * Math.sin(omega0 * t),
    size: ({ motion: { setup }, omega0 }) => Math.abs(setup.theta0) + Math.abs(setup.velocity0) / omega0,
  },
]

export const MOTION: readonly Equality[] = [...inversion, ...solution, ...small]
