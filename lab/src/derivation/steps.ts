// Equalities of the way to the integral: force, energy, kind of motion, substitution, time and period.

import { ALL, BOTH, type Equality, one, SWING, square, TURN } from './equality'
import type { Moment } from './moment'
import { mean, quarterOf } from './second-route'

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
    right: ({ omega0, elliptic }) => omega0 * elliptic.delta,
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
    right: ({ omega0, elliptic }) => (omega0 / elliptic.k) * elliptic.delta,
    size: ({ omega0, kappa }) => omega0 * kappa,
  },
]

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

export const STEPS: readonly Equality[] = [...force, ...energy, ...regime, ...substitution, ...integral]
