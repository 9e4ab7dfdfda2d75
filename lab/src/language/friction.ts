// The words of the view Friction, in all languages: they come with the view.

import { enFriction } from './en-friction'
import { esFriction } from './es-friction'
import { addWords } from './index'
import { ptBRFriction } from './pt-BR-friction'

addWords({ en: { damped: enFriction }, 'pt-BR': { damped: ptBRFriction }, es: { damped: esFriction } })
