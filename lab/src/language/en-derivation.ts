// English, of the view Derivation. Marks as in en.ts; a formula's names of functions are put in by the page.

import type { Loose } from './en'

export const enDerivation = {
  sentence: 'From the *force* to _θ_(_t_), with your numbers. Step *{step}* of {count}: *{title}*.',
  entry: 'Written for',
  entries: { novice: 'Novices', lima: 'Readers of Lima', salas: 'Readers of Salas' },
  steps: 'Steps',
  stepName: 'Step {step}: {title}',
  back: 'Previous step',
  next: 'Next step',
  digits: '{count} digits agree',
  before: 'before',
  after: 'after',
  formula: 'Formula',
  not: {
    rest: 'This pendulum is at rest.',
    libration: 'For swings, not for this motion.',
    rotation: 'For turns over the top, not for this motion.',
    separatrix: 'For the separatrix, not for this motion.',
    moving: 'This pendulum is at rest.',
    both: 'For swings and turns, not for this motion.',
    value: 'No value here: _u_ is infinite at 180°.',
    arcsine: 'No value here: the terms make the sine larger than 1.',
    small: 'No numbers here: they are smaller than the computer can hold.',
  },
  erratum: 'Erratum',
  printed: 'as printed',
  corrected: 'corrected',
  truth: 'the motion',
  noReal: 'no real value',
  noArcsine: 'no real value: the arcsine of {argument}',
  notThis: 'The line is not about this motion: no number.',
  errata: {
    'salas-9': 'The dots, which mean velocity, stand on the wrong letters.',
    'salas-10': '_u_{0} and its velocity are exchanged throughout.',
    'salas-25': '_K_/_ω_{0} is a quarter of the period. For turns, _m_ > 1, it has no real value.',
    'salas-26': 'The factor before the fraction makes it a quarter of the period.',
    'salas-27': 'The factor before the fraction makes it a quarter of the period.',
    'salas-28': 'The factor before the fraction makes it a quarter of the period.',
    'lima-16': 'Jacobi’s sn has become a sine. Time counts from the turn on the right.',
    'horsley-3':
      'The root of _k_ belongs above, and sn has become a sine. Here _k_ is sin²(_θ_{0}/2), _γ_{0} = _κ_/√_k_, _F_{0} the integral of the start, _H_ the sign of the velocity. For _θ_{0} < 0 the corrected line has the other sign before it.',
  },
  kind: {
    rest: 'Here _κ_² = *{m}*: the pendulum is *at rest*, and stays.',
    libration: 'Here _κ_² = *{m}*, below 1: the pendulum *swings*, up to *{angle}*.',
    separatrix: 'Here _κ_² = *1*: it is *on the separatrix*, climbs to the top and never arrives.',
    rotation: 'Here _κ_² = *{m}*, above 1: the pendulum *turns over*.',
  },
  forces: {
    name: 'The forces on the mass',
    weight: 'weight _mg_',
    along: '_mg_ sin _θ_',
    across: '_mg_ cos _θ_',
    rod: 'rod',
    caption:
      'For each kilogram of your pendulum now: weight {weight}; of the weight along the arc {along}, along the rod {across}; the rod pulls with {pull}.',
  },
  circle: {
    name: 'The circle of the energy',
    caption:
      "The point has the width _θ'_/(2_ω_{0}) = {x} and the height sin(_θ_/2) = {s}. It stays at the distance _κ_ = {kappa}. Dashed: the separatrix, _κ_ = 1: it just reaches the top.",
    angle: 'Its angle is _φ_ = {phi}.',
  },
  coefficients: {
    name: 'Coefficients of the series of sn',
    order: '_n_',
    value: '_b_{2n−1}',
    sum: '_k_ times the first terms, at the turning point',
  },
  errors: {
    name: 'Largest errors in one period',
    formula: 'formula',
    error: 'largest error, % of _θ_{max}',
    noValue: 'no value in a part of it',
    refused: 'not for this motion',
    fourier: 'Lima (22), _N_ = {n}',
  },

  lessons: {
    novice: {
      force: {
        title: 'The force along the arc',
        text: [
          'A mass hangs on a rigid rod of length _L_ that weighs nothing. _θ_ is its angle from the bottom. Two forces act on it: its weight, and the rod.',
          'The rod pulls across the arc, so it cannot change the speed along it. Of the weight the part _mg_ sin _θ_ points along the arc, back to the bottom. The arc is _Lθ_. Newton’s law along it, for each kilogram:',
          'The mass stood on both sides and is gone. Divide by _L_. One number is left of the pendulum, the frequency of its small swings:',
          'The minus sign says that the force points back. The sine is what makes it hard; step 8 does without it.',
        ],
      },
      energy: {
        title: 'From acceleration to speed',
        text: [
          'The acceleration depends on the angle, and the angle is what we look for. A trick helps: multiply both sides by the velocity.',
          "Now both sides are derivatives that we know: on the left of _θ'_²/2, on the right of _ω_{0}² cos _θ_. So one sum never changes. It is the energy, counted from the bottom; now it is what it was at the start:",
          'With half the angle, 1 − cos _θ_ becomes a square:',
        ],
      },
      kind: {
        title: 'Three kinds of motion',
        text: [
          'Divide the energy by what it takes to stand on the top, 2_ω_{0}². Call the quotient _κ_². The start says how large it is, and it stays:',
          "_θ'_{top} is the velocity with which it would just reach the top from where it starts.",
        ],
      },
      substitution: {
        title: 'An angle that goes round',
        text: [
          "The last sum is a circle: its point has the height sin(_θ_/2) and the width _θ'_/(2_ω_{0}), and _κ_ is its radius. For a swing call the radius _k_, and the angle of the point _φ_. Where _θ_ turns back, _φ_ goes on:",
          'How fast does it go round? Take the derivative of the first line and put in the second. The cosine of _φ_ cancels, and cos(_θ_/2) = √(1 − _k_² sin²_φ_):',
          'If the pendulum turns over, _θ_ itself goes on. Then half of it is _φ_, with the sign of the turn, and _k_ is 1/_κ_:',
        ],
      },
      integral: {
        title: 'Time as an integral',
        text: [
          'Each small step of _φ_ takes a time: the step over the rate. All of them together are the time since the start, where _φ_ was _φ_{0}. This integral is no elementary function. It has a name, the *elliptic integral of the first kind*, _F_:',
          'From the bottom to the turning point _φ_ grows by a right angle. That takes a quarter of the period:',
          'Nobody has to do the integral. Gauss found it from averages. Begin with 1 and √(1−_k_²); take their arithmetic and their geometric mean, of these again, until both are one number, _M_. Then:',
          'A turn takes _φ_ through two right angles:',
        ],
      },
      inversion: {
        title: 'The function that undoes it',
        text: [
          'The integral gives the time to an angle. We want the angle to a time. So read it backwards, as the sine undoes the arcsine: with _u_ = _F_(_φ_), the sine, the cosine and the root become functions of _u_:',
          'There is a picture of them, the ellipse of the view Functions. Its point has the width _x_. The chord from the lowest point to the bob is 2_L_ sin(_θ_/2). It is the width, times 2_Lk_:',
          'For small swings the ellipse is a circle, the chord is the arc, and sn is the sine.',
        ],
      },
      solution: {
        title: 'The motion, from any start',
        text: [
          'The pendulum need not be released from rest. Where it starts on its circle is the first argument, _u_{0} = _F_(_φ_{0}):',
          'From then on _u_ grows by _ω_{0} each second. Undo the substitution of step 4:',
          'In a turn _k_ is 1/_κ_, and the angle is am, the inverse of _F_ itself. It counts its turns on; an arcsine would fold them back:',
          'Between the two, at _κ_ = 1, the integral is elementary:',
        ],
      },
      small: {
        title: 'The limit of small swings',
        text: [
          'When _k_ goes to 0 the root in the integral goes to 1. Then _F_(_φ_) is _φ_, and what undoes it is the sine:',
          'What is left is the motion that first lessons teach:',
          'At this time the exact angle is *{exact}*, and this one is *{linear}*.',
        ],
      },
      dropped: {
        title: 'What approximations drop',
        text: [
          'The linear motion has the period _T_{0} whatever the swing. The true period is 2_K_/π times as long. As a series in the turning angle it begins with two terms that everybody uses; the rest is dropped:',
          'They are *{seriesError}* from the true ratio. Another idea keeps the cosine and gives it the true period; _t_{m} is when it last turned on the right:',
          'What formulas are off by, at most, in one period of your pendulum:',
          'How the last two come about is written for the readers of Lima and of Salas.',
        ],
      },
    },
    lima: {
      motion: {
        title: 'Equation and energy',
        text: [
          'A point mass on a rigid rod without mass, no friction. One integration gives the velocity:',
          'Lima releases from rest, so that _k_ = sin(_θ_{0}/2). Here any swing will do: _k_ belongs to its turning angle.',
        ],
      },
      integral: {
        title: 'The proper integral',
        text: [
          'The substitution makes the improper integral a proper one. _k_ is the *modulus*; many programs ask for the parameter _m_ = _k_² instead.',
          'A quarter of the period is the complete integral:',
        ],
      },
      inversion: {
        title: 'Abel’s and Jacobi’s inversion',
        text: [
          'Jacobi’s functions undo the integral, _u_ = _F_(_φ_). Their derivatives follow from d_u_/d_φ_ = 1/dn:',
          'With _z_ = sin(_θ_/2)/_k_ the equation of motion has the same form:',
          'So _z_ is sn of an argument that runs at _ω_{0}. The free factor _C_ of (15) is none: with _k_ fixed only _C_ = 0 and ±1 solve (14). The free constants are _k_ and the phase.',
        ],
      },
      solution: {
        title: 'The exact motion',
        text: [
          'For a release from rest the phase is _K_; from any start it is _u_{0} = _F_(_φ_{0}):',
          'cn gives the velocity its sign, which the root of (5) leaves open.',
        ],
      },
      harmonic: {
        title: 'A cosine with the exact period',
        text: [
          'The first approximation keeps the period and drops the form. _t_{m} is when it last turned on the right, 0 for Lima:',
          'Its largest error in a period of your pendulum is *{harmonicError}* of the turning angle.',
        ],
      },
      series: {
        title: 'The Fourier series',
        text: [
          'sn is odd and has the period 4_K_, so it is a sum of sines. The paper does the integral of the coefficients in the complex plane; here it stands beside its value, for the first:',
          'Four terms, put into the arcsine:',
          'Where the terms make the sine larger than 1 there is no angle: an odd number of them does so at the turning points, an even number inside the swing. The series of _θ_ itself needs no arcsine; the Lab draws it.',
        ],
      },
      errors: {
        title: 'What the terms leave out',
        text: [
          'At the turning points all sines are ±1, and the whole sum is known:',
          'No finite number of terms gives it, so the motion does not begin quite where it was released. What the formulas are off by, at most, in one period of your pendulum:',
          'The paper says that this is always at _t_ = 0 and _T_. For an even number of terms and large swings it is inside.',
        ],
      },
    },
    salas: {
      motion: {
        title: 'Any start',
        text: [
          "Given are an angle and a velocity, _φ_{0} and its derivative for Salas, _θ_{0} and _θ'_{0} here. His _m_ in (23) is the energy ratio _κ_²:",
        ],
      },
      duffing: {
        title: 'The pendulum as a spring',
        text: [
          'The tangent of half the angle, _u_ = tan(_θ_/2), moves like a mass on a spring with a cubic force: Duffing’s equation. On the left is what the chain rule makes of the pendulum’s own motion:',
          'The spring has an energy of its own:',
        ],
      },
      coefficients: {
        title: 'The two constants of the spring',
        text: [
          'The pendulum’s equation holds where the factors of _u_ and _u_³ vanish:',
          'Solved for _p_ and _q_. By the energy they are simpler, and have a value at 180° too:',
          'On the separatrix _q_ is 0: there the spring is linear.',
        ],
      },
      cosine: {
        title: 'The solution is a cn',
        text: [
          'The paper tries nine of Jacobi’s twelve functions. For a swing cn has real constants: _c_{1} is the tangent of half the turning angle. Then its rate is _ω_{0}, and its parameter _m_ again:',
          'The phase is _c_{2} = _a_ − _K_, with _a_ = _F_(_φ_{0}):',
          'Near the top _u_ is large. The motion is not: the tangent has its pole there.',
        ],
      },
      start: {
        title: 'One formula for every start',
        text: [
          'The addition theorem of cn takes the phase out. What is left has the start in it as it is given, for swings and for turns; _z_ is _ω_{0}_t_, the parameter _m_:',
          'The arctangent knows one turn, so whole turns are lost; here they are given back. Formulas that count them:',
          'On the way, in (14), (15), (17) and (18), factors and signs are lost in print. The errata of this project list them.',
        ],
      },
      period: {
        title: 'The period',
        text: [
          'A swing takes four times the complete integral. For a turn the parameter is above 1, and its reciprocal takes its place:',
          'Three quotients stand for 2_K_/π, Padé’s approximants in _m_. They are right; the factor before them is not:',
          'At _m_ = 1 the period is infinite, and these are not. For your pendulum (28) is *{salasError}* from the exact ratio.',
        ],
      },
      trigonometric: {
        title: 'Without elliptic functions',
        text: [
          'The sine becomes a polynomial of degree 5, and its motion a cosine over a root. The turning angle alone gives _ν_ and _λ_. Time counts from the last turn:',
          'What formulas are off by, at most, in one period of your pendulum:',
        ],
      },
    },
  },
}

export type DerivationCatalogue = Loose<typeof enDerivation>
