// The words of the view Data, in all languages: they come with the view.

import { absentWords as absent } from './data-absent'
import { enData } from './en-data'
import { esData } from './es-data'
import { addWords } from './index'
import { ptBRData } from './pt-BR-data'

addWords({
  en: { data: { ...absent.en, ...enData } },
  'pt-BR': { data: { ...absent['pt-BR'], ...ptBRData } },
  es: { data: { ...absent.es, ...esData } },
})
