// The views that there are, in the order of their tabs. A view that does not exist yet has no tab.

import { motionSentence } from './bench'
import { functions, functionsSentence } from './functions'
import { lab, labAlarm } from './lab'
import { period, periodSentence } from './period'
import { phase, phaseSentence } from './phase'
import type { View } from './shell'

export const VIEWS: readonly View[] = [
  { name: 'lab', sentence: motionSentence, alarm: labAlarm, body: lab },
  { name: 'phase', sentence: phaseSentence, body: phase },
  { name: 'period', sentence: periodSentence, body: period },
  { name: 'functions', sentence: functionsSentence, body: functions },
]
