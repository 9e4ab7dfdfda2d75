// English, of the view Springs. Marks as in en.ts. u and t have no unit.

import type { Loose } from './en'

export const enSprings = {
  kind: 'Kind of spring',
  kinds: { duffing: 'Duffing', 'cubic-quintic': 'Cubic–quintic' },
  values: {
    p: { label: 'Stiffness', symbol: '_p_' },
    q: { label: 'Cubic part', symbol: '_q_' },
    s: { label: 'Quintic part', symbol: '_s_' },
    u0: { label: 'Start', symbol: '_u_{0}' },
    springVelocity0: { label: 'Start velocity', symbol: "_u'_{0}" },
  },
  loading: 'Loading springs …',
  failed: 'Springs could not be loaded.',
  again: 'Try again',

  examples: 'Examples',
  presets: {
    hardening: 'Hardening spring',
    softening: 'Softening spring, swings',
    escape: 'Softening spring, escapes',
    saddles: 'Between two unstable equilibria',
    inside: 'Double well, inside',
    on: 'Double well, on the separatrix',
    outside: 'Double well, outside',
    bistable: 'Bistable cubic–quintic spring',
    quintic: 'Cubic–quintic spring, escapes',
    companion: 'Companion of the pendulum',
  },
  companionNote: '_u_ = tan(_θ_/2) of the Lab’s pendulum',

  names: {
    hardening: 'The hardening spring',
    softening: 'The softening spring',
    double: 'The double well',
    repelling: 'The repelling spring',
    linear: 'The linear spring',
    free: 'The free mass',
    quintic: 'The cubic–quintic spring',
  },
  swings: '{name} swings to *±{high}* and back once in *_T_ = {period}*.',
  well: '{name} stays *on one side*: it swings between *{low}* and *{high}* once in *_T_ = {period}*.',
  homoclinic:
    '{name} is *on the separatrix*: it leaves an unstable equilibrium and comes back to it, both in infinite time.',
  heteroclinic: '{name} is *on the separatrix*: it goes from one unstable equilibrium to another in infinite time.',
  escapes: '{name} *escapes to infinity* at *_t_ = {time}*.',
  escapesDown: '{name} *escapes to minus infinity* at *_t_ = {time}*.',
  came: '{name} came from infinity at _t_ = {time} and *nears an unstable equilibrium*, in infinite time.',
  rests: '{name} *rests* at _u_ = {u}.',
  balances: '{name} *balances* at _u_ = {u}: an unstable equilibrium. It stays.',
  runs: '{name} *runs away*, ever faster; it is at infinity at no finite time.',
  even: '{name} moves *evenly*: no force acts.',

  facts: {
    regime: 'Motion',
    period: 'Period _T_',
    escape: 'Escapes at _t_',
    infinite: 'infinite',
    from: 'came from infinity at',
    energy: 'energy _E_',
    range: 'range of _u_',
  },
  regimes: {
    rest: 'at rest',
    linear: 'linear',
    libration: 'swings about _u_ = 0',
    well: 'swings on one side',
    homoclinic: 'homoclinic',
    heteroclinic: 'heteroclinic',
    escape: 'escapes',
  },

  potential: 'Potential',
  potentialUnit: '_V_ against displacement _u_',
  energyLine: '_E_',
  portrait: 'Phase portrait',
  portraitUnit: "velocity _u'_ against displacement _u_",
  time: 'Displacement',
  timeUnit: '_u_ against time _t_',
  hatched: 'Hatched: after the escape at _t_ = {time} there is no motion.',
  cursor: 'Start of the spring',
  start: '{u}, velocity {velocity}: {regime}',
  help: 'Click or drag in the portrait to start there; arrow keys move the start. Dashed: the separatrices, through the unstable equilibria (rings).',
  equilibria: 'Equilibria',
  place: 'place _u_',
  height: 'potential _V_',
  stability: 'stability',
  stable: 'stable',
  unstable: 'unstable',

  captionPotential:
    'The potential from {from} to {to}. The energy is {energy}; the motion is where the potential is not above it: {range}.',
  captionEquilibria: 'Equilibria: {list}.',
  captionPlace: '{u}, {kind}',
  captionPortrait:
    'Velocity against displacement, with the curves through the unstable equilibria. The start is {start}.',
  captionTime: 'The displacement from 0 to {to}.',
  ranges: { both: 'from {low} to {high}', all: 'anywhere', above: 'from {low} on', below: 'up to {high}' },
  tablePotential: 'Potential and speed of the motion',
  tableTime: 'Displacement and velocity',
  speed: 'speed',
}

export type SpringCatalogue = Loose<typeof enSprings>
