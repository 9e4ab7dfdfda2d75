// The words of the view Data, in all languages.

import { type AbsentCatalogue, dataWords as absent } from './data-absent'
import { type DataCatalogue, enData } from './en-data'
import { esData } from './es-data'
import { ptBRData } from './pt-BR-data'

export type DataWords = AbsentCatalogue & DataCatalogue

export const dataWords: Readonly<Record<keyof typeof absent, DataWords>> = {
  en: { ...absent.en, ...enData },
  'pt-BR': { ...absent['pt-BR'], ...ptBRData },
  es: { ...absent.es, ...esData },
}
