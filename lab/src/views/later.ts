// The views that are loaded beside the core and after the Lab, in one part: nothing is asked for when a tab is chosen.

export { functions, functionsSentence } from './functions'
export { period, periodSentence } from './period'
export { phase, phaseSentence } from './phase'
