// The words of the view Hand-outs, in all languages: they come with the view.

import { enHandouts } from './en-handouts'
import { esHandouts } from './es-handouts'
import { addWords } from './index'
import { ptBRHandouts } from './pt-BR-handouts'

addWords({ en: { handouts: enHandouts }, 'pt-BR': { handouts: ptBRHandouts }, es: { handouts: esHandouts } })
