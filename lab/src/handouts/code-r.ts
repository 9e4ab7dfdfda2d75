// R, base language alone: K, F and am by the arithmetic-geometric mean (DLMF 19.8(i), 22.20(ii)), with the complement mc as argument.

import { type Given, textOf } from './code-given'

export function r(given: Given): string {
  const { kind, say, sign, velocity, length, gravity, times } = given
  const angle = 'degrees' in given.angle ? `${given.angle.degrees} * pi / 180` : given.angle.radians
  const minus = sign < 0 ? '-' : ''
  const start = [
    `theta0 <- ${angle}; velocity0 <- ${velocity}  # rad, rad/s`,
    `L <- ${length}; g <- ${gravity}  # m, m/s^2`,
    `t <- c(${times.join(', ')})  # s`,
    'omega0 <- sqrt(g / L)',
  ]
  const energy = [
    `# ${say.energy}`,
    's <- sin(theta0 / 2); c <- cos(theta0 / 2); v <- velocity0 / (2 * omega0)',
    'm <- s^2 + v^2',
    `mc <- (c - v) * (c + v)  # ${say.complement}`,
    '',
  ]
  const functions = [
    `# ${say.ownFunctions}`,
    'elliptic_f <- function(phi, mc) {',
    '  a <- 1; b <- sqrt(mc)',
    '  for (n in 1:8) {',
    '    d <- atan2(b * sin(phi), a * cos(phi))',
    '    phi <- phi + d + 2 * pi * round((phi - d) / (2 * pi))',
    '    mean <- (a + b) / 2; b <- sqrt(a * b); a <- mean',
    '  }',
    '  phi / (2^8 * a)',
    '}',
    'elliptic_k <- function(mc) elliptic_f(pi / 2, mc)',
    'jacobi_am <- function(u, mc) {',
    '  a <- 1; b <- sqrt(mc); ratio <- numeric(8)',
    '  for (n in 1:8) {',
    '    ratio[n] <- (a - b) / (a + b)',
    '    mean <- (a + b) / 2; b <- sqrt(a * b); a <- mean',
    '  }',
    '  phi <- 2^8 * a * u',
    '  for (n in 8:1) phi <- (phi + asin(ratio[n] * sin(phi))) / 2',
    '  phi',
    '}',
    '',
  ]
  const shown = [
    '',
    kind !== 'rest' && 'cat("period", format(period, digits = 15), "\\n")',
    'cat(sprintf("%.15g %.15g %.15g\\n", t, theta, velocity), sep = "")',
  ]
  return textOf(given, {
    comment: (text) => `# ${text}`,
    elliptic: [...functions, ...start, ...energy],
    elementary: [...start, ''],
    libration: [
      'period <- 4 * elliptic_k(mc) / omega0',
      'u0 <- elliptic_f(atan2(s, v), mc)',
      'am <- jacobi_am(omega0 * t + u0, mc)',
      'theta <- 2 * asin(sqrt(m) * sin(am))',
      'velocity <- 2 * omega0 * sqrt(m) * cos(am)',
    ],
    rotation: [
      `omega <- ${minus}omega0 * sqrt(m)`,
      'period <- 2 * elliptic_k(-mc / m) / abs(omega)',
      'am <- jacobi_am(omega * t + elliptic_f(theta0 / 2, -mc / m), -mc / m)',
      `theta <- 2 * am  # ${say.turns}`,
      'velocity <- 2 * omega * sqrt(cos(am)^2 - mc / m * sin(am)^2)',
    ],
    separatrix: [
      `u <- ${minus}omega0 * t + asinh(tan(theta0 / 2))`,
      'theta <- 2 * atan(sinh(u))',
      `velocity <- ${minus}2 * omega0 / cosh(u)`,
      'period <- Inf',
    ],
    rest: ['theta <- rep(theta0, length(t))', 'velocity <- numeric(length(t))'],
    shown,
  })
}
