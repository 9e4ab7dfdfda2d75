// The words of the view Springs, in all languages: they come with the view.

import { enSprings, type SpringCatalogue } from './en-springs'
import { esSprings } from './es-springs'
import { addWords } from './index'
import { ptBRSprings } from './pt-BR-springs'

export type SpringWords = SpringCatalogue

addWords({ en: { spring: enSprings }, 'pt-BR': { spring: ptBRSprings }, es: { spring: esSprings } })
