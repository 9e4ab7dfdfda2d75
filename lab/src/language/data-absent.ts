// Of the words of the view Data those that the offline file needs, which has no fit.

export const absentWords = {
  en: {
    notHere:
      'The offline file has no fit, so that it stays small. The page that a server gives has one: the same, at its address or by the command libration lab.',
    sentenceEmpty: 'From a file of measurements to *_g_ with its uncertainty*.',
  },
  'pt-BR': {
    notHere:
      'O arquivo sem rede não contém o ajuste, para ficar pequeno. A página dada por um servidor o contém: no seu endereço, ou pelo comando libration lab.',
    sentenceEmpty: 'De um arquivo de medições a *_g_ com a sua incerteza*.',
  },
  es: {
    notHere:
      'El archivo sin red no contiene el ajuste, para ser pequeño. La página que da un servidor lo contiene: en su dirección, o con la orden libration lab.',
    sentenceEmpty: 'De un archivo de mediciones a *_g_ con su incertidumbre*.',
  },
}

export type AbsentCatalogue = (typeof absentWords)['en']
