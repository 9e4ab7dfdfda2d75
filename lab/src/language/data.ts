// The words of the view Data, in all languages: they come with the view.

import { type AbsentCatalogue, absentWords as absent } from './data-absent'
import { type DataCatalogue, enData } from './en-data'
import { esData } from './es-data'
import { addWords } from './index'
import { ptBRData } from './pt-BR-data'

export type DataWords = AbsentCatalogue & DataCatalogue

addWords({
  en: { data: { ...absent.en, ...enData } },
  'pt-BR': { data: { ...absent['pt-BR'], ...ptBRData } },
  es: { data: { ...absent.es, ...esData } },
})
