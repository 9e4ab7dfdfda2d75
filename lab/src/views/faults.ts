// What is wrong with a link, in the words of the language: key, value, range, what is used instead.

import type { TemplateResult } from 'lit-html'
import type { Words } from '../language'
import { rich } from '../language/rich'
import { DEFAULTS, type Fault, RANGES, type RangeName } from '../state'
import { quantityText } from './page'

/** Keys of the link by the names of the state. */
const KEYS: Readonly<Record<string, string>> = {
  theta0: 'th0',
  velocity0: 'w0',
  length: 'L',
  gravity: 'g',
  springVelocity0: 'v0',
  driveFrequency: 'omega',
}

/** The name of the state by its key in the link, of a number. */
function nameOf(key: string): RangeName | null {
  const name = Object.keys(KEYS).find((each) => KEYS[each] === key) ?? key
  return Object.hasOwn(RANGES, name) ? (name as RangeName) : null
}

/** The values are the link's own and have no marks. Where gravity is hidden, the value that is shown instead of another one is not said either. */
export function faultText(words: Words, fault: Fault, hide: boolean): TemplateResult {
  const say = words.say.linkFaults
  const usual = say.usual
  const keptOf = (name: RangeName | null): string =>
    name === null || (hide && name === 'gravity') || typeof DEFAULTS[name] !== 'number'
      ? usual
      : quantityText(words, name, Number(DEFAULTS[name]))
  switch (fault.kind) {
    case 'out-of-range': {
      const { least, most } = RANGES[fault.name]
      return rich(say['out-of-range'], {
        name: KEYS[fault.name] ?? fault.name,
        value: fault.value,
        least: quantityText(words, fault.name, least),
        most: quantityText(words, fault.name, most),
        kept: keptOf(fault.name),
      })
    }
    case 'not-one-of':
      return rich(say['not-one-of'], {
        name: fault.name,
        value: fault.value,
        allowed: fault.allowed.join(', '),
        kept: usual,
      })
    case 'argument':
      return rich(say.argument, {
        value: fault.value,
        least: words.given(fault.least),
        most: words.given(fault.most),
      })
    case 'too-many':
      return rich(say['too-many'], { name: fault.name, value: fault.value, most: fault.most, kept: usual })
    case 'unknown':
      return rich(fault.name === 'curves' ? say['unknown-curve'] : say.unknown, {
        name: fault.name,
        value: fault.value,
      })
    case 'not-a-number': {
      const kept = keptOf(nameOf(fault.name))
      return rich(say['not-a-number'], { name: fault.name, value: fault.value, kept })
    }
    default:
      return rich(say[fault.kind], { name: fault.name, value: fault.value, kept: usual })
  }
}
