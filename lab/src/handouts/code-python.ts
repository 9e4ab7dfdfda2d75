// Python: with SciPy alone, with mpmath for as many digits as one likes, and with libration.

import { type Given, lines, textOf } from './code-given'

function angle({ angle: given }: Given, radians: string): string {
  return 'degrees' in given ? `${radians}(${given.degrees})` : given.radians
}

export function scipy(given: Given): string {
  const { kind, say, sign, velocity, length, gravity, times } = given
  const start = [
    `theta0, velocity0 = ${angle(given, 'np.radians')}, ${velocity}  # rad, rad/s`,
    `length, gravity = ${length}, ${gravity}  # m, m/s^2`,
    `t = np.array([${times.join(', ')}])  # s`,
    'omega0 = np.sqrt(gravity / length)',
  ]
  const energy = [
    '',
    `# ${say.energy}`,
    's, c, v = np.sin(theta0 / 2), np.cos(theta0 / 2), velocity0 / (2 * omega0)',
    'm = s**2 + v**2',
    `mc = (c - v) * (c + v)  # ${say.complement}`,
  ]
  const shown = [
    '',
    kind !== 'rest' && `print("period", ${kind === 'separatrix' ? 'np.inf' : 'period'})`,
    'for row in zip(t, theta, velocity):',
    '    print(*row)',
  ]
  const convention = `# SciPy, ellipj ellipkinc ellipkm1: ${say.parameter}`
  return textOf(given, {
    comment: (text) => `# ${text}`,
    elliptic: [
      convention,
      'import numpy as np',
      'from scipy.special import ellipj, ellipkinc, ellipkm1',
      '',
      ...start,
      ...energy,
      '',
    ],
    elementary: ['import numpy as np', '', ...start, ''],
    libration: [
      'period = 4 * ellipkm1(mc) / omega0  # 4 K(m) / omega0',
      'u0 = ellipkinc(np.arctan2(s, v), m)',
      'sn, cn, dn, am = ellipj(omega0 * t + u0, m)',
      'theta = 2 * np.arcsin(np.sqrt(m) * sn)',
      'velocity = 2 * omega0 * np.sqrt(m) * cn',
    ],
    rotation: [
      `omega = ${sign < 0 ? '-' : ''}omega0 * np.sqrt(m)`,
      'period = 2 * ellipkm1(-mc / m) / abs(omega)  # 2 K(1/m) / (k omega0)',
      'u0 = ellipkinc(theta0 / 2, 1 / m)',
      'sn, cn, dn, am = ellipj(omega * t + u0, 1 / m)',
      `theta = 2 * am  # ${say.turns}`,
      'velocity = 2 * omega * dn',
    ],
    separatrix: [
      `u = ${sign < 0 ? '-' : ''}omega0 * t + np.arcsinh(np.tan(theta0 / 2))`,
      'theta = 2 * np.arctan(np.sinh(u))',
      `velocity = ${sign < 0 ? '-' : ''}2 * omega0 / np.cosh(u)`,
    ],
    rest: ['theta = np.full_like(t, theta0)', 'velocity = np.zeros_like(t)'],
    shown,
  })
}

export function mpmath(given: Given): string {
  const { kind, say, sign, velocity, length, gravity, times } = given
  const start = [
    'mp.dps = 30',
    `theta0, velocity0 = ${'degrees' in given.angle ? `mp.radians(${given.angle.degrees})` : `mp.mpf(${given.angle.radians})`}, mp.mpf(${velocity})  # rad, rad/s`,
    `length, gravity = mp.mpf(${length}), mp.mpf(${gravity})  # m, m/s^2`,
    'omega0 = mp.sqrt(gravity / length)',
  ]
  const energy = ['', `# ${say.energy}`, 's, v = mp.sin(theta0 / 2), velocity0 / (2 * omega0)', 'm = s**2 + v**2', '']
  const shown = [
    '',
    kind !== 'rest' && `print("period", ${kind === 'separatrix' ? 'mp.inf' : 'period'})`,
    `for t in map(mp.mpf, [${times.join(', ')}]):  # s`,
    '    print(t, *motion(t))',
  ]
  const convention = `# mpmath, ellipk ellipf ellipfun: ${say.parameter}`
  return textOf(given, {
    comment: (text) => `# ${text}`,
    elliptic: [convention, 'from mpmath import mp', '', ...start, ...energy],
    elementary: ['from mpmath import mp', '', ...start, '', ''],
    libration: [
      'period = 4 * mp.ellipk(m) / omega0',
      'u0 = mp.ellipf(mp.atan2(s, v), m)',
      '',
      '',
      'def motion(t):',
      '    u = omega0 * t + u0',
      '    theta = 2 * mp.asin(mp.sqrt(m) * mp.ellipfun("sn", u, m=m))',
      '    return theta, 2 * omega0 * mp.sqrt(m) * mp.ellipfun("cn", u, m=m)',
      '',
    ],
    rotation: [
      `omega = ${sign < 0 ? '-' : ''}omega0 * mp.sqrt(m)`,
      'quarter = mp.ellipk(1 / m)',
      'period = 2 * quarter / abs(omega)',
      'u0 = mp.ellipf(theta0 / 2, 1 / m)',
      '',
      '',
      'def motion(t):',
      '    u = omega * t + u0',
      `    turns = mp.nint(u / (2 * quarter))  # ${say.turns}`,
      '    sn, cn, dn = [mp.ellipfun(name, u - 2 * turns * quarter, m=1 / m) for name in ("sn", "cn", "dn")]',
      '    return 2 * (mp.atan2(sn, cn) + turns * mp.pi), 2 * omega * dn',
      '',
    ],
    separatrix: [
      'def motion(t):',
      `    u = ${sign < 0 ? '-' : ''}omega0 * t + mp.asinh(mp.tan(theta0 / 2))`,
      `    return 2 * mp.atan(mp.sinh(u)), ${sign < 0 ? '-' : ''}2 * omega0 / mp.cosh(u)`,
      '',
    ],
    rest: ['def motion(t):', '    return theta0, mp.mpf(0)', ''],
    shown,
  })
}

export function libration(given: Given): string {
  const { kind, say, sign, velocity, length, gravity, times } = given
  const head = [`# ${say.equation}`, 'import numpy as np', 'from libration import Pendulum', '']
  const t = `t = np.array([${times.join(', ')}])  # s`
  const shown = ['for row in zip(t, theta, velocity):', '    print(*row)']
  if (kind === 'rest')
    return lines(
      `# ${say.rest}`,
      'import numpy as np',
      '',
      t,
      `theta = np.full_like(t, ${angle(given, 'np.radians')})`,
      'velocity = np.zeros_like(t)',
      ...shown,
    )
  if (kind === 'separatrix')
    return lines(
      ...head,
      t,
      `theta0, length, gravity = ${angle(given, 'np.radians')}, ${length}, ${gravity}  # rad, m, m/s^2`,
      'omega0 = np.sqrt(gravity / length)',
      `# ${say.unit}`,
      `pendulum = Pendulum(0, ${2 * sign})`,
      `theta, velocity = pendulum.motion(omega0 * t ${sign < 0 ? '-' : '+'} np.arcsinh(np.tan(theta0 / 2)))`,
      'velocity = omega0 * velocity',
      '',
      'print("period", pendulum.period)',
      ...shown,
    )
  return lines(
    ...head,
    `pendulum = Pendulum(${angle(given, 'np.radians')}, ${velocity}, length=${length}, gravity=${gravity})  # rad, rad/s, m, m/s^2`,
    t,
    'theta, velocity = pendulum.motion(t)',
    '',
    'print("period", pendulum.period)',
    ...shown,
  )
}
