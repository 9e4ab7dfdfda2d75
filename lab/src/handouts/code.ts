// Texts of code for one pendulum, in the languages of its readers: each prints the period and the motion at a few times.
//
// A text is for the kind of motion that the start makes, so that it is as short as the textbook's. Its formulas are DLMF 22.19(i):
// swings sin(θ/2) = k sn(ω₀t + u₀ | m), turns θ = 2 am(kω₀t + u₀ | 1/m), the separatrix sin(θ/2) = tanh(ω₀t + u₀).

import type { Motion } from '../model'
import { angleText } from '../number'
import type { Code } from '../state'
import type { Comments, Given } from './code-given'
import { mathematica } from './code-mathematica'
import { octave } from './code-octave'
import { libration, mpmath, scipy } from './code-python'
import { r } from './code-r'

export const CODE_NAMES: Readonly<Record<Code, string>> = {
  scipy: 'Python, SciPy',
  mpmath: 'Python, mpmath',
  libration: 'Python, libration',
  octave: 'Octave, MATLAB',
  r: 'R',
  mathematica: 'Mathematica',
}

/** In s. */
export const TIMES = [0, 0.5, 1, 2, 5]

const WRITERS: Readonly<Record<Code, (given: Given) => string>> = { scipy, mpmath, libration, octave, r, mathematica }

function givenOf(motion: Motion, say: Comments): Given {
  const { theta0, velocity0, length, gravity } = motion.setup
  const angle = angleText(theta0)
  return {
    kind: motion.regime,
    angle: angle.endsWith('deg') ? { degrees: angle.slice(0, -3) } : { radians: String(theta0) },
    velocity: String(velocity0),
    length: String(length),
    gravity: String(gravity),
    sign: velocity0 < 0 ? -1 : 1,
    times: TIMES.map(String),
    say,
  }
}

export function codeText(code: Code, motion: Motion, say: Comments): string {
  return WRITERS[code](givenOf(motion, say))
}

/** How near to 1 the parameter may be for the functions of SciPy, Octave and MATLAB: below it their own series begin. */
const NEAR = 1e-8

/** Whether a text loses digits at this start. */
export function losesDigits(code: Code, motion: Motion): boolean {
  const near = motion.regime !== 'separatrix' && motion.regime !== 'rest' && Math.abs(motion.energyRatioC) < NEAR
  return near && (code === 'scipy' || code === 'octave')
}
