// The amplitude of the motion, which Period and Functions share: read from the motion, set as a release from rest.

import type { TemplateResult } from 'lit-html'
import { value } from '../controls/value'
import { plain } from '../language/rich'
import { degrees, parseQuantity, radians } from '../number'
import type { Live } from './page'

/** Turning angle of the motion in degrees; null where it does not turn back. */
export function amplitudeOf({ motion }: Live): number | null {
  return motion.regime === 'rotation' ? null : degrees(motion.thetaMax)
}

/** A release from rest at an amplitude: as a slider, a field and a cursor do it. */
export function release({ store }: Live, amplitude: number): void {
  store.draft('amplitude', null)
  store.set({ theta0: radians(amplitude), velocity0: 0 })
}

/** In degrees, three decimals at most. */
export const angleText = ({ words }: Live, amplitude: number): string => `${words.given(Number(amplitude.toFixed(3)))}°`

/** The amplitude as a value of the page: field and slider. */
export function amplitudeValue(page: Live): TemplateResult {
  const { words, store, session } = page
  const { period, faults } = words.say
  const amplitude = amplitudeOf(page)
  const draft = session.drafts.amplitude
  const read = draft === undefined || draft.trim() === '' ? null : parseQuantity(draft, 'deg')
  const valid = read === null || (read >= 0 && read <= Math.PI)
  const shown = amplitude === null ? '–' : words.typed(Number(amplitude.toFixed(6)))
  const fault = valid
    ? null
    : words.fill(faults[Number.isNaN(read) ? 'not-a-number' : 'out-of-range'], {
        name: period.amplitude,
        value: `${draft?.trim().replace(/\s*(?!e[-+]?\d)[a-z°].*$/i, '')}${Number.isNaN(read) ? '' : '°'}`,
        kept: amplitude === null ? '–' : angleText(page, amplitude),
        least: '0°',
        most: '180°',
      })
  return value({
    key: 'amplitude',
    label: period.amplitude,
    symbol: '_θ_{max}',
    unit: '°',
    value: amplitude ?? 180,
    least: 0,
    most: 180,
    step: 1,
    grain: 1,
    origin: 0,
    ticks: [0, 60, 120, 180],
    text: shown,
    spoken: amplitude === null ? plain(period.rotation) : angleText(page, amplitude),
    draft,
    fault,
    onText: (text) => {
      store.draft('amplitude', text)
      const next = parseQuantity(text, 'deg')
      if (next >= 0 && next <= Math.PI) store.set({ theta0: next, velocity0: 0 })
    },
    onDone: () => valid && store.draft('amplitude', null),
    onSlide: (next) => release(page, next),
    onHold: (held) => store.setSession({ held: held ? 'amplitude' : null }),
  })
}
