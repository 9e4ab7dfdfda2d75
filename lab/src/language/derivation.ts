// The words of the view Derivation, in all languages: they come with the view.

import { enDerivation } from './en-derivation'
import { esDerivation } from './es-derivation'
import { addWords } from './index'
import { ptBRDerivation } from './pt-BR-derivation'

addWords({
  en: { derivation: enDerivation },
  'pt-BR': { derivation: ptBRDerivation },
  es: { derivation: esDerivation },
})
