// Octave and MATLAB, base language alone. Neither has the incomplete integral there; the arithmetic-geometric mean gives it (DLMF 19.8(i)).

import { type Given, textOf } from './code-given'

export function octave(given: Given): string {
  const { kind, say, sign, velocity, length, gravity, times } = given
  const angle = 'degrees' in given.angle ? `${given.angle.degrees}*pi/180` : given.angle.radians
  const minus = sign < 0 ? '-' : ''
  const start = [
    `theta0 = ${angle}; velocity0 = ${velocity};  % rad, rad/s`,
    `L = ${length}; g = ${gravity};  % m, m/s^2`,
    `t = [${times.join(' ')}];  % s`,
    'omega0 = sqrt(g/L);',
  ]
  const energy = [
    '',
    `% ${say.energy}`,
    's = sin(theta0/2); c = cos(theta0/2); v = velocity0/(2*omega0);',
    'm = s^2 + v^2;',
    `mc = (c - v)*(c + v);  % ${say.complement}`,
  ]
  // tan(φ' − φ) = (b/a) tan φ on the branch next to φ; after eight means a = b to the last digit.
  const incomplete = [
    `% ${say.incomplete}`,
    'for n = 1:8',
    '  d = atan2(b*sin(phi), a*cos(phi));',
    '  phi = phi + d + 2*pi*round((phi - d)/(2*pi));',
    '  [a, b] = deal((a + b)/2, sqrt(a*b));',
    'end',
    'u0 = phi/(2^8*a);',
  ]
  // MATLAB has no printf; both have fprintf.
  const shown = [
    '',
    kind !== 'rest' && "fprintf('period %.15g\\n', period)",
    "fprintf('%.15g %.15g %.15g\\n', [t; theta; velocity])",
  ]
  const convention = `% ellipke, ellipj: ${say.parameter}`
  return textOf(given, {
    comment: (text) => `% ${text}`,
    elliptic: [convention, ...start, ...energy, ''],
    elementary: [...start, ''],
    libration: [
      'period = 4*ellipke(m)/omega0;',
      'phi = atan2(s, v); a = 1; b = sqrt(mc);',
      ...incomplete,
      '[sn, cn, dn] = ellipj(omega0*t + u0, m);',
      'theta = 2*asin(sqrt(m)*sn);',
      'velocity = 2*omega0*sqrt(m)*cn;',
    ],
    rotation: [
      `omega = ${minus}omega0*sqrt(m);`,
      'K = ellipke(1/m);',
      'period = 2*K/abs(omega);',
      'phi = theta0/2; a = 1; b = sqrt(-mc/m);',
      ...incomplete,
      'u = omega*t + u0;',
      `turns = round(u/(2*K));  % ${say.turns}`,
      '[sn, cn, dn] = ellipj(u - 2*K*turns, 1/m);',
      'theta = 2*(atan2(sn, cn) + pi*turns);',
      'velocity = 2*omega*dn;',
    ],
    separatrix: [
      `u = ${minus}omega0*t + asinh(tan(theta0/2));`,
      'theta = 2*atan(sinh(u));',
      `velocity = ${minus}2*omega0./cosh(u);`,
      'period = Inf;',
    ],
    rest: ['theta = theta0*ones(size(t));', 'velocity = zeros(size(t));'],
    shown,
  })
}
