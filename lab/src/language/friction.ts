// The words of the view Friction, in all languages: they come with the view.

import { enFriction, type FrictionCatalogue } from './en-friction'
import { esFriction } from './es-friction'
import { addWords } from './index'
import { ptBRFriction } from './pt-BR-friction'

export type FrictionWords = FrictionCatalogue

addWords({ en: { damped: enFriction }, 'pt-BR': { damped: ptBRFriction }, es: { damped: esFriction } })
