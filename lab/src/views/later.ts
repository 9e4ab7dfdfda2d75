// What is loaded beside the core and after the Lab, in one part: the first views and the dialogs with their words. Nothing is asked
// for when their tab is chosen or a dialog opened.

import '../language/later'

export { dialogs } from './dialog-bodies'
export { functions, functionsSentence } from './functions'
export { period, periodSentence } from './period'
export { phase, phaseSentence } from './phase'
