// The words of the view Springs, in all languages: they come with the view.

import { enSprings } from './en-springs'
import { esSprings } from './es-springs'
import { addWords } from './index'
import { ptBRSprings } from './pt-BR-springs'

addWords({ en: { spring: enSprings }, 'pt-BR': { spring: ptBRSprings }, es: { spring: esSprings } })
