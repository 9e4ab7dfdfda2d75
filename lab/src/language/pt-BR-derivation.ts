import { enDerivation } from './en-derivation'
export const ptBRDerivation = enDerivation
