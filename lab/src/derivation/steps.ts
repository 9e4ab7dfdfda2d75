// Equalities of the way to θ(t): force, energy, kind of motion, substitution, integral, inversion, solution, small swings.

import { ALL, BOTH, type Equality, LIMIT, MOVING, SWING, TURN } from './equality'
import type { Moment } from './moment'
import { mean, quarterOf } from './second-route'

const square = (x: number): number => x * x
const one = (): number => 1

const force: Equality[] = [
  {
    id: 'newton',
    tag: 'Horsley (2), Lima (1), Salas (1)',
    unit: 'm/s²',
    of: ALL,
    left: (now) => now.motion.setup.length * now.acceleration,
    right: (now) => -now.motion.setup.gravity * Math.sin(now.theta),
    size: (now) => now.motion.setup.length * now.strongest,
  },
  {
    id: 'omega0',
    tag: 'Salas (4)',
    unit: '1/s²',
    of: ALL,
    left: (now) => square(now.omega0),
    right: ({ motion: { setup } }) => setup.gravity / setup.length,
  },
  {
    id: 'pendulum',
    tag: 'Horsley (2), Lima (2), Salas (4)',
    unit: 'rad/s²',
    of: ALL,
    left: (now) => now.acceleration,
    right: (now) => -square(now.omega0) * Math.sin(now.theta),
    size: (now) => now.strongest,
  },
]

/** Energy per unit inertia by the core, kinetic and potential. */
const energyAt = ({ motion, omega0 }: Moment, theta: number, velocity: number): number => {
  const { kinetic, potential } = motion.energyAt(theta, velocity)
  return 2 * square(omega0) * (kinetic + potential)
}

const energy: Equality[] = [
  {
    id: 'multiplied',
    tag: 'Horsley, before (5)',
    unit: '',
    of: ALL,
    left: (now) => now.velocity * now.acceleration,
    right: (now) => -square(now.omega0) * now.velocity * Math.sin(now.theta),
    size: (now) => 2 * now.omega0 * now.kappa * now.strongest,
  },
  {
    id: 'energy',
    tag: 'Horsley (5), Lima (4)',
    unit: '1/s²',
    of: ALL,
    left: (now) => energyAt(now, now.theta, now.velocity),
    right: (now) => energyAt(now, now.motion.setup.theta0, now.motion.setup.velocity0),
  },
  {
    id: 'half-angle',
    tag: 'Lima, before (7)',
    unit: '',
    of: ALL,
    left: (now) => 2 * now.motion.energyAt(now.theta, 0).potential,
    right: (now) => 2 * square(now.now.s),
  },
  {
    id: 'speed',
    tag: 'Lima (5)',
    unit: '1/s²',
    of: ALL,
    left: (now) => square(now.velocity),
    right: ({ start, now, omega0 }) => 4 * square(omega0) * (square(start.x) + square(start.s) - square(now.s)),
    size: (now) => 4 * square(now.omega0) * now.m,
  },
]

const regime: Equality[] = [
  {
    id: 'kappa',
    tag: 'Salas (23)',
    unit: '',
    of: ALL,
    left: (now) => now.m,
    right: ({ start }) => square(start.s) + square(start.x),
  },
  {
    id: 'circle',
    tag: '',
    unit: '',
    of: ALL,
    left: ({ now }) => square(now.s) + square(now.x),
    right: (now) => now.m,
  },
  {
    id: 'turning',
    tag: 'Lima, before (7)',
    unit: '',
    of: SWING,
    left: (now) => Math.sin(now.motion.thetaMax / 2),
    right: (now) => now.kappa,
  },
  {
    id: 'separatrix',
    tag: '',
    unit: 'rad/s',
    of: ALL,
    left: (now) => now.motion.separatrixVelocity(now.motion.setup.theta0),
    right: ({ omega0, start }) => 2 * omega0 * start.c,
  },
]

const substitution: Equality[] = [
  {
    id: 'sine',
    tag: 'Lima, before (7)',
    unit: '',
    of: SWING,
    left: ({ now }) => now.s,
    right: ({ elliptic }) => elliptic.k * Math.sin(elliptic.am),
    size: (now) => now.kappa,
  },
  {
    id: 'cosine',
    tag: '',
    unit: '',
    of: SWING,
    left: ({ now }) => now.x,
    right: ({ elliptic }) => elliptic.k * Math.cos(elliptic.am),
    size: (now) => now.kappa,
  },
  {
    id: 'phi-rate',
    tag: 'Lima (7)',
    unit: 'rad/s',
    of: SWING,
    left: ({ elliptic }) => elliptic.slopeOfPhi,
    right: ({ omega0, elliptic }) => omega0 * delta(elliptic),
    size: (now) => now.omega0,
  },
  {
    id: 'turn-angle',
    tag: '',
    unit: '',
    of: TURN,
    left: ({ now, elliptic }) => elliptic.sign * now.s,
    right: ({ elliptic }) => Math.sin(elliptic.am),
    size: one,
  },
  {
    id: 'turn-rate',
    tag: '',
    unit: 'rad/s',
    of: TURN,
    left: ({ elliptic }) => elliptic.slopeOfPhi,
    right: ({ omega0, elliptic }) => (omega0 / elliptic.k) * delta(elliptic),
    size: ({ omega0, kappa }) => omega0 * kappa,
  },
]

/** √(1 − k² sin²φ) of the motion, without a difference. */
function delta({ sinPhi, cosPhi, parameter }: Moment['elliptic']): number {
  return Math.sqrt(square(cosPhi) + parameter.mc * square(sinPhi))
}

const integral: Equality[] = [
  {
    id: 'time',
    tag: 'Lima (7), Horsley (7)',
    unit: '',
    of: SWING,
    left: ({ omega0, t }) => omega0 * t,
    right: ({ elliptic }) => elliptic.integral - elliptic.u0,
    size: ({ elliptic }) => elliptic.quarter,
  },
  {
    id: 'turn-time',
    tag: '',
    unit: '',
    of: TURN,
    left: ({ omega0, t, elliptic }) => (omega0 * t) / elliptic.k,
    right: ({ elliptic }) => elliptic.integral - elliptic.u0,
    size: ({ elliptic }) => elliptic.quarter,
  },
  {
    id: 'quarter',
    tag: 'Lima (8)',
    unit: '',
    of: BOTH,
    left: ({ elliptic }) => elliptic.quarter,
    right: ({ elliptic }) => quarterOf(elliptic.parameter),
  },
  {
    id: 'period',
    tag: 'Lima (10), Salas (25)',
    unit: 's',
    of: SWING,
    left: ({ motion }) => motion.period,
    right: ({ elliptic, omega0 }) => (4 * elliptic.quarter) / omega0,
  },
  {
    id: 'turn-period',
    tag: 'Salas (25)',
    unit: 's',
    of: TURN,
    left: ({ motion }) => motion.period,
    right: ({ elliptic, omega0 }) => (2 * elliptic.k * elliptic.quarter) / omega0,
  },
  {
    id: 'mean',
    tag: '',
    unit: 's',
    of: SWING,
    left: ({ motion }) => motion.period,
    right: ({ omega0, mc }) => (2 * Math.PI) / (omega0 * mean(1, Math.sqrt(mc))),
  },
]

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
    right: ({ elliptic }) => delta(elliptic),
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

export const STEPS: readonly Equality[] = [
  ...force,
  ...energy,
  ...regime,
  ...substitution,
  ...integral,
  ...inversion,
  ...solution,
  ...small,
]
