// Mathematica, whose elliptic functions take the parameter m. Its numbers have a point, so that it computes with doubles.

import { type Given, textOf } from './code-given'

/** `1` is an exact number there, and `1e-7` is not a number. */
function double(text: string): string {
  const [digits = '', exponent] = text.split('e')
  const pointed = digits.includes('.') ? digits : `${digits}.`
  return exponent === undefined ? pointed : `${pointed}*^${Number(exponent)}`
}

export function mathematica(given: Given): string {
  const { kind, say, sign, velocity, length, gravity, times } = given
  const minus = sign < 0 ? '-' : ''
  const angle = 'degrees' in given.angle ? `${double(given.angle.degrees)} Degree` : double(given.angle.radians)
  const start = [
    `theta0 = ${angle}; velocity0 = ${double(velocity)}; (* rad, rad/s *)`,
    `length = ${double(length)}; gravity = ${double(gravity)}; (* m, m/s^2 *)`,
    'omega0 = Sqrt[gravity/length];',
  ]
  const energy = [`(* ${say.energy} *)`, 'm = Sin[theta0/2]^2 + (velocity0/(2 omega0))^2;']
  const shown = [
    kind !== 'rest' && 'Print["period ", period];',
    `Do[Print[{t, theta[t], velocity[t]}], {t, {${times.map(double).join(', ')}}}] (* s *)`,
  ]
  const convention = `(* EllipticK, EllipticF, JacobiSN, JacobiAmplitude: ${say.parameter} *)`
  return textOf(given, {
    comment: (text) => `(* ${text} *)`,
    elliptic: [convention, ...start, ...energy],
    elementary: start,
    libration: [
      'period = 4 EllipticK[m]/omega0;',
      'u0 = EllipticF[ArcTan[velocity0/(2 omega0), Sin[theta0/2]], m]; (* ArcTan[x, y] *)',
      'theta[t_] := 2 ArcSin[Sqrt[m] JacobiSN[omega0 t + u0, m]];',
      'velocity[t_] := 2 omega0 Sqrt[m] JacobiCN[omega0 t + u0, m];',
    ],
    rotation: [
      `omega = ${minus}omega0 Sqrt[m];`,
      'period = 2 EllipticK[1/m]/Abs[omega];',
      'u0 = EllipticF[theta0/2, 1/m];',
      `theta[t_] := 2 JacobiAmplitude[omega t + u0, 1/m]; (* ${say.turns} *)`,
      'velocity[t_] := 2 omega JacobiDN[omega t + u0, 1/m];',
    ],
    separatrix: [
      'u0 = ArcSinh[Tan[theta0/2]];',
      `theta[t_] := 2 ArcTan[Sinh[${minus}omega0 t + u0]];`,
      `velocity[t_] := ${minus}2 omega0/Cosh[${minus}omega0 t + u0];`,
      'period = Infinity;',
    ],
    rest: ['theta[t_] := theta0;', 'velocity[t_] := 0.;'],
    shown,
  })
}
