// What is in the menus "Save", and what their choices do. A part of its own with all that makes the files; nothing is asked for
// when a file is made.

import '../language/save'
import '../style/save.css'
import type { TemplateResult } from 'lit-html'
import { version } from '../../package.json'
import type { MenuItem } from '../controls/parts'
import type { Ghost } from '../draw/pendulum'
import { plain } from '../language/rich'
import type { DecimalSign } from '../save/csv'
import { saveFile } from '../save/file'
import { fontRules } from '../save/fonts'
import { motionCommand, motionCsv } from '../save/motion-csv'
import { DOTS_PER_INCH, png } from '../save/png'
import { svgFile } from '../save/svg'
import { spanOf } from '../study'
import { pendulumAt } from './bench'
import type { ChartSpec } from './chart-spec'
import { openDialog } from './dialogs'
import { loadVideo } from './film'
import type { Live, Page } from './page'
import { CHART_MM, chartPicture, PENDULUM_MM, pendulumPicture } from './picture'
import { linkOf, saveCsv } from './table'
import { timeText } from './time-axis'

export { filmDialog } from './film'

/** Rows of the table of the motion: those of the plots. */
const SAMPLES = 1201

/** All that is fetched before a file can be made: the fonts and the writer of videos. */
export async function prepared(): Promise<void> {
  await Promise.all([fontRules(), loadVideo()])
}

function say({ store }: Page, text: string): void {
  const messages = store.session.messages.filter(({ key }) => key !== 'save')
  store.setSession({ messages: [...messages, { key: 'save', text }] })
}

/** A file that fails says why in a message of the page. */
async function made(page: Page, make: () => Promise<void>): Promise<void> {
  try {
    await make()
  } catch (error) {
    const why = error instanceof Error ? error.message : String(error)
    say(page, page.words.fill(page.words.say.save.failed, { why }))
  }
}

const aboutOf = (page: Page) => `libration ${version}, ${linkOf(page)}`

function pictures(page: Page, file: string, mm: number, className: string, picture: () => TemplateResult): MenuItem[] {
  const { words } = page
  const say = words.say.save
  const width = words.given(mm)
  return [
    {
      text: say.svg,
      note: words.fill(say.svgNote, { width }),
      act: () => void made(page, async () => saveFile([svgFile(className, picture())], 'image/svg+xml', `${file}.svg`)),
    },
    {
      text: say.png,
      note: words.fill(say.pngNote, { width, dots: DOTS_PER_INCH }),
      act: () =>
        void made(page, async () => saveFile([await png(svgFile(className, picture()))], 'image/png', `${file}.png`)),
    },
  ]
}

/** The sign of the language first. */
const signs = ({ words }: Page): readonly DecimalSign[] => (words.decimal === ',' ? [',', '.'] : ['.', ','])

export function chartItems(page: Page, spec: ChartSpec): readonly MenuItem[] {
  const { words } = page
  const table = spec.table
  if (!table) return []
  const tables = signs(page).map((sign) => ({
    text: words.say.save.csv,
    note: words.say.table[sign === ',' ? 'decimalComma' : 'decimalPoint'],
    act: () => saveCsv(page, table(), sign),
  }))
  return [
    ...tables,
    ...pictures(page, table().file, CHART_MM, `chart ${spec.className}`, () => chartPicture(spec, aboutOf(page))),
  ]
}

/** The file of `libration solve`; not where the page shows a motion that no doubles start. */
function motionItems(page: Live): MenuItem[] {
  const { words, motion, state } = page
  const texts = words.say.save
  if (!motion.asGiven) return []
  const sampling = { until: spanOf(state, motion), samples: SAMPLES }
  return signs(page).map((sign) => ({
    text: words.fill(texts.motion, { sign: sign === ',' ? texts.comma : texts.point }),
    note: texts.motionNote,
    act: () => {
      saveFile([motionCsv(motion.setup, sampling, sign)], 'text/csv;charset=utf-8', 'motion.csv')
      say(page, words.fill(texts.command, { command: motionCommand(motion.setup, sampling, sign) }))
    },
  }))
}

export function pendulumItems(page: Live, ghosts: readonly Ghost[]): readonly MenuItem[] {
  const { words, motion, t } = page
  const say = words.say.save
  const picture = () =>
    pendulumPicture(
      pendulumAt(page, motion.theta(t), motion.velocity(t), ghosts),
      plain(words.fill(say.picture, { t: timeText(words, t) })),
      aboutOf(page),
    )
  const drawn = pictures(page, 'pendulum', PENDULUM_MM, 'drawing', picture)
  // A film states the period, the command of the motion states g.
  if (page.state.hide) return drawn
  return [{ text: say.film, note: say.filmNote, act: () => openDialog(page, 'film') }, ...drawn, ...motionItems(page)]
}
