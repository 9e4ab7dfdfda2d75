// The words of the views that follow the Lab and of the dialogs: a part of the page that comes with them.

import { enLater } from './en-later'
import { esLater } from './es-later'
import { addWords } from './index'
import { ptBRLater } from './pt-BR-later'

addWords({ en: enLater, 'pt-BR': ptBRLater, es: esLater })
