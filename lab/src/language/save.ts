// The words of the menus "Save" and of the film, in all languages: they come with what makes the files.

import { enSave, type SaveCatalogue } from './en-save'
import { esSave } from './es-save'
import { addWords } from './index'
import { ptBRSave } from './pt-BR-save'

export type SaveWords = SaveCatalogue

addWords({ en: { save: enSave }, 'pt-BR': { save: ptBRSave }, es: { save: esSave } })
