import { enDerivation } from './en-derivation'
export const esDerivation = enDerivation
