// English, of the menus "Save" and of the film. Marks as in en.ts.

import type { Loose } from './en'

export const enSave = {
  svg: 'SVG picture',
  svgNote: '{width} mm wide, for print and for changes',
  png: 'PNG picture',
  pngNote: '{width} mm wide at {dots} dots per inch',
  csv: 'CSV table',
  motion: 'CSV of the motion, {sign}',
  point: 'decimal point',
  comma: 'decimal comma',
  motionNote: 'as *libration solve* writes it',
  command: 'motion.csv is saved. This command writes the same table, last digits apart: {command}',
  film: 'Film: MP4 or GIF',
  filmNote: 'one exact period, frame by frame',
  picture: 'The pendulum at {t}',
  failed: 'The file could not be made: {why}',

  title: 'Film of the pendulum',
  shows: 'Shows',
  period: 'one period, _T_ = {t}',
  turn: 'one turn, _T_ = {t}',
  span: '{from} to {to}',
  format: 'Format',
  width: 'Width, pixels',
  rate: 'Frames in a second',
  speed: 'Speed',
  facts: '{frames} frames of {width} × {height} pixels: {seconds} at speed {speed}.',
  repeats: 'The frame after the last is the first: it repeats without a seam.',
  once: 'It ends elsewhere than it begins.',
  delays: 'A GIF counts hundredths of a second: a round takes {seconds} and not {true}.',
  exact: 'Only the exact motion is in the film, in the light colours.',
  noMp4: 'This browser writes no MP4 (H.264): the film is WebM (VP9).',
  noVideo: 'No video can be written here: the film is a GIF.',
  rest: 'At rest nothing moves: there is no film.',
  separatrix:
    'On the separatrix the period is infinite: no film of it ends. The time that the plots show can be filmed.',
  few: 'That is {frames} frames: too few to be seen moving. Choose more in a second, or a slower speed.',
  many: 'That is {frames} frames, more than {most}. Choose fewer in a second, or a faster speed.',
  make: 'Make the film',
  making: 'Frame {done} of {frames}',
  progress: 'Progress of the film',
  cancel: 'Cancel',
  cancelled: 'Cancelled. Nothing was saved.',
  saved: '{name} is saved: {size} kB.',
}

export type SaveCatalogue = Loose<typeof enSave>
