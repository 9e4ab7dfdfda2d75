// The words of the menus "Save" and of the film, in all languages: they come with what makes the files.

import { enSave } from './en-save'
import { esSave } from './es-save'
import { addWords } from './index'
import { ptBRSave } from './pt-BR-save'

addWords({ en: { save: enSave }, 'pt-BR': { save: ptBRSave }, es: { save: esSave } })
