// English, of the view Friction. Marks as in en.ts.

import type { Loose } from './en'

export const enFriction = {
  values: {
    linear: { label: 'Linear friction', symbol: '_γ_' },
    quadratic: { label: 'Quadratic', symbol: '_β_' },
    dry: { label: 'Dry', symbol: '_μ_' },
    torque: { label: 'Constant torque/mL²', symbol: '_τ_{0}' },
    drive: { label: 'Driving torque/mL²', symbol: '_τ_{1}' },
    driveFrequency: { label: 'Frequency', symbol: '_Ω_' },
    until: { label: 'Seconds shown', symbol: '' },
  },
  equation: "_θ''_ + 2_γ_ _θ'_ + _β_|_θ'_| _θ'_ + _μ_ sgn _θ'_ + _ω_{0}² sin _θ_ = _τ_{0} + _τ_{1} cos _Ωt_",
  loading: 'Loading friction …',
  failed: 'Friction could not be loaded.',
  again: 'Try again',

  examples: 'Examples',
  presets: {
    weak: 'Weakly damped lab pendulum',
    dry: 'Dry friction',
    quadratic: 'Strong quadratic friction',
    over: 'Thrown over the top',
    one: 'Driven, period one',
    two: 'Driven, period two',
    chaos: 'Driven, chaotic',
    josephson: 'Steady rotation, as a Josephson junction',
  },

  computing: 'The motion is *being computed*: it is a fast one.',
  endHere: 'End here',
  reached: 'Computed up to {time}.',
  exact: 'Without friction and torque this is the *exact pendulum* of the Lab.',
  still: 'It *stays* where it is.',
  stops: 'It *comes to rest at {angle}* after *{time}*: dry friction holds it.',
  halves: 'It *loses half its energy in {time}*.',
  keeps: 'After {time} it still has *{percent}* of its energy.',
  turnsOnce: 'It *turns over once*, then swings.',
  turns: 'It *turns over {count} times*, then swings.',
  turnsStill: 'It *turns over {count} times* in {time}, and still turns.',
  rotates: 'The torque turns it *round and round*, in the mean at *{velocity}*.',
  settles: 'The torque holds it aside: after {time} it is at *{angle}*.',
  repeats: 'Driven, it comes to *repeat every period* of the drive, {period}.',
  repeatsMany: 'Driven, it comes to *repeat every {count} periods* of the drive.',
  chaotic:
    'Driven, it *does not repeat*: after {count} periods of the drive no cycle of up to {longest} of them is found.',
  driving: 'Driven: {count} of {most} periods are computed.',
  tooFast: 'Driven, it becomes *too fast* to be followed: {count} of {most} periods are computed.',

  angle: 'Angle',
  angleUnit: 'blue: turning points; red dots: predicted by averaging; dashed: no friction',
  angleUnitDriven: '_θ_; dashed: no friction, no torque',
  energy: 'Energy',
  energyUnit: '% of that at the top; dashed: no friction',
  half: '½',
  phase: 'Phase portrait',
  phaseUnit: "_θ'_, rad/s",
  section: 'Poincaré section',
  sectionUnit: 'once a period',
  progress: 'Points of the section',
  points: '{count} of {most} points',
  held: 'Hatched: dry friction holds it.',

  facts: {
    half: 'Half the energy after',
    rest: 'At rest from',
    restAngle: 'at rest at',
    turns: 'whole turns at the end',
    swings: 'turning points',
    end: 'energy at the end',
    quality: 'quality _Q_ = _ω_{0}/2_γ_',
    qualityLinear: '_Q_ of the linear friction alone',
    repeats: 'repeats after',
    one: 'one period of the drive',
    periods: '{count} periods of the drive',
    none: '–',
  },

  captionAngle: 'The angle from 0 to {to}: between {least} and {most}, with {count} turning points.',
  captionEnergy: 'The energy goes from {first} to {last} of that at the top.',
  captionPhase:
    'Velocity against angle within one turn, from the start to {to}, with the separatrix of the pendulum without friction.',
  captionSection:
    '{count} points of angle and velocity, one for each period of the drive. Of a motion that repeats only its cycle is drawn.',
  dampedColumn: 'with friction',
  freeColumn: 'without',
}

export type FrictionCatalogue = Loose<typeof enFriction>
