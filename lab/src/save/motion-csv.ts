// The exact motion as a table: the file that `libration solve` writes for the same pendulum and instants, byte for byte but for the last
// digits of numbers, which depend on whether a processor multiplies and adds with one rounding; a browser never does.

import { version } from '../../package.json'
import type { Setup } from '../model'
import { solved } from '../model/solved'
import { angleText } from '../number'
import { type DecimalSign, separatorOf } from './csv'

/** A number as Python writes it: the fewest digits that read back to the same double, and `.0` behind whole ones. */
export function written(value: number): string {
  if (Number.isNaN(value)) return 'nan'
  if (!Number.isFinite(value)) return value > 0 ? 'inf' : '-inf'
  if (value === 0) return Object.is(value, -0) ? '-0.0' : '0.0'
  const [mantissa = '', power = ''] = value.toExponential().split('e')
  const exponent = Number(power)
  if (exponent < -4 || exponent >= 16) {
    const size = String(Math.abs(exponent)).padStart(2, '0')
    return `${mantissa}e${exponent < 0 ? '-' : '+'}${size}`
  }
  const text = exponent < 0 ? value.toFixed(mantissa.replace(/[-.]/g, '').length - 1 - exponent) : String(value)
  return text.includes('.') ? text : `${text}.0`
}

interface Sampling {
  /** Last instant in s; the first is 0. */
  readonly until: number
  readonly samples: number
}

export function motionCsv(setup: Setup, { until, samples }: Sampling, sign: DecimalSign): string {
  const { parameters, columns } = solved(setup, until, samples)
  const number = (value: number) => written(value).replace('.', sign)
  const between = separatorOf(sign)
  const rows = Array.from({ length: samples }, (_, i) =>
    columns.map(([, , values]) => number(values[i] as number)).join(between),
  )
  return [
    ...(sign === ',' ? ['# decimal comma, columns separated by semicolons'] : []),
    `# libration = ${version}`,
    ...parameters.map(([name, value, unit]) =>
      `# ${name} = ${typeof value === 'number' ? number(value) : value} ${unit}`.trimEnd(),
    ),
    columns.map(([name, unit]) => `${name} [${unit}]`).join(between),
    ...rows,
    '',
  ].join('\n')
}

/** The command that writes the same file. */
export function motionCommand(setup: Setup, { until, samples }: Sampling, sign: DecimalSign): string {
  const { theta0, velocity0, length, gravity } = setup
  return [
    'libration solve',
    `--theta0 ${angleText(theta0)}`,
    ...(velocity0 === 0 ? [] : [`--velocity0 ${velocity0}`]),
    `--length ${length}m --gravity ${gravity}`,
    `--until ${until}s --samples ${samples}`,
    ...(sign === ',' ? ['--decimal comma'] : []),
    '--out motion.csv',
  ].join(' ')
}
