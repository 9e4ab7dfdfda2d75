// Português, da vista Dedução. Marcas como em en.ts.

import type { DerivationCatalogue } from './en-derivation'

export const ptBRDerivation: DerivationCatalogue = {
  sentence: 'Da *força* a _θ_(_t_), com os seus números. Passo *{step}* de {count}: *{title}*.',
  entry: 'Escrito para',
  entries: { novice: 'Iniciantes', lima: 'Leitores de Lima', salas: 'Leitores de Salas' },
  steps: 'Passos',
  stepName: 'Passo {step}: {title}',
  back: 'Passo anterior',
  next: 'Passo seguinte',
  digits: '{count} dígitos coincidem',
  before: 'antes de',
  after: 'depois de',
  formula: 'Fórmula',
  not: {
    rest: 'Este pêndulo está em repouso.',
    libration: 'Para oscilações, não para este movimento.',
    rotation: 'Para voltas completas, não para este movimento.',
    separatrix: 'Para a separatriz, não para este movimento.',
    moving: 'Este pêndulo está em repouso.',
    both: 'Para oscilações e voltas, não para este movimento.',
    value: 'Sem valor aqui: _u_ é infinito em 180°.',
    arcsine: 'Sem valor aqui: os termos tornam o seno maior que 1.',
    small: 'Sem números aqui: são menores do que o computador pode guardar.',
  },
  erratum: 'Errata',
  printed: 'como impresso',
  corrected: 'corrigido',
  truth: 'o movimento',
  noReal: 'sem valor real',
  noArcsine: 'sem valor real: o arco seno de {argument}',
  notThis: 'A linha não trata deste movimento: sem número.',
  errata: {
    'salas-9': 'Os pontos, que indicam velocidade, estão nas letras erradas.',
    'salas-10': '_u_{0} e a sua velocidade estão trocados em toda a linha.',
    'salas-25': '_K_/_ω_{0} é um quarto do período. Para voltas, _m_ > 1, não tem valor real.',
    'salas-26': 'O fator antes da fração faz dela um quarto do período.',
    'salas-27': 'O fator antes da fração faz dela um quarto do período.',
    'salas-28': 'O fator antes da fração faz dela um quarto do período.',
    'lima-16': 'O sn de Jacobi virou um seno. O tempo conta desde o retorno à direita.',
    'horsley-3':
      'A raiz de _k_ pertence ao numerador, e sn virou um seno. Aqui _k_ é sin²(_θ_{0}/2), _γ_{0} = _κ_/√_k_, _F_{0} a integral do início, _H_ o sinal da velocidade. Para _θ_{0} < 0 a linha corrigida leva o outro sinal.',
  },
  kind: {
    rest: 'Aqui _κ_² = *{m}*: o pêndulo está *em repouso*, e fica.',
    libration: 'Aqui _κ_² = *{m}*, abaixo de 1: o pêndulo *oscila*, até *{angle}*.',
    separatrix: 'Aqui _κ_² = *1*: está *na separatriz*, sobe ao topo e nunca chega.',
    rotation: 'Aqui _κ_² = *{m}*, acima de 1: o pêndulo *dá voltas*.',
  },
  forces: {
    name: 'As forças sobre a massa',
    weight: 'peso _mg_',
    along: '_mg_ sin _θ_',
    across: '_mg_ cos _θ_',
    rod: 'haste',
    caption:
      'Para cada quilograma do seu pêndulo agora: peso {weight}; do peso, ao longo do arco {along}, da haste {across}; a haste puxa com {pull}.',
  },
  circle: {
    name: 'O círculo da energia',
    caption:
      "O ponto tem a largura _θ'_/(2_ω_{0}) = {x} e a altura sin(_θ_/2) = {s}. Fica à distância _κ_ = {kappa}. Tracejada: a separatriz, _κ_ = 1: chega justo ao topo.",
    angle: 'O seu ângulo é _φ_ = {phi}.',
  },
  coefficients: {
    name: 'Coeficientes da série de sn',
    order: '_n_',
    value: '_b_{2n−1}',
    sum: '_k_ vezes os primeiros termos, no ponto de retorno',
  },
  errors: {
    name: 'Maiores erros em um período',
    formula: 'fórmula',
    error: 'maior erro, % de _θ_{max}',
    noValue: 'sem valor em uma parte dele',
    refused: 'não para este movimento',
    fourier: 'Lima (22), com _N_ = {n}',
  },

  lessons: {
    novice: {
      force: {
        title: 'A força ao longo do arco',
        text: [
          'Uma massa pende de uma haste rígida de comprimento _L_ que não pesa nada. _θ_ é o seu ângulo a partir do ponto mais baixo. Duas forças agem sobre ela: o peso e a haste.',
          'A haste puxa perpendicularmente ao arco e por isso não muda a velocidade ao longo dele. Do peso, a parte _mg_ sin _θ_ aponta ao longo do arco, de volta ao ponto mais baixo. O arco é _Lθ_. A lei de Newton ao longo dele, para cada quilograma:',
          'A massa estava nos dois lados e desapareceu. Divida por _L_. Do pêndulo resta um só número, a frequência das pequenas oscilações:',
          'O sinal de menos diz que a força aponta de volta. O seno é o que torna tudo difícil; o passo 8 o dispensa.',
        ],
      },
      energy: {
        title: 'Da aceleração à velocidade',
        text: [
          'A aceleração depende do ângulo, e o ângulo é o que procuramos. Um truque ajuda: multiplique os dois lados pela velocidade.',
          "Agora os dois lados são derivadas que conhecemos: à esquerda a de _θ'_²/2, à direita a de _ω_{0}² cos _θ_. Então uma soma nunca muda. É a energia, contada a partir do ponto mais baixo; agora ela é o que era no início:",
          'Com a metade do ângulo, 1 − cos _θ_ torna-se um quadrado:',
        ],
      },
      kind: {
        title: 'Três tipos de movimento',
        text: [
          'Divida a energia pela que é preciso para ficar no topo, 2_ω_{0}². Chame o quociente de _κ_². O início diz quanto ele vale, e ele fica:',
          "_θ'_{top} é a velocidade com que, de onde começa, apenas chegaria ao topo.",
        ],
      },
      substitution: {
        title: 'Um ângulo que dá a volta',
        text: [
          "A última soma é um círculo: o seu ponto tem a altura sin(_θ_/2) e a largura _θ'_/(2_ω_{0}), e _κ_ é o raio. Para uma oscilação chame o raio de _k_, e o ângulo do ponto de _φ_. Onde _θ_ volta atrás, _φ_ segue:",
          'Com que rapidez ele gira? Derive a primeira linha e ponha nela a segunda. O cosseno de _φ_ se cancela, e cos(_θ_/2) = √(1 − _k_² sin²_φ_):',
          'Se o pêndulo dá voltas, o próprio _θ_ segue sempre. Então a metade dele é _φ_, com o sinal da volta, e _k_ é 1/_κ_:',
        ],
      },
      integral: {
        title: 'O tempo como integral',
        text: [
          'Cada pequeno passo de _φ_ leva um tempo: o passo dividido pela rapidez. Todos juntos são o tempo desde o início, onde _φ_ era _φ_{0}. Esta integral não é função elementar. Ela tem um nome, a *integral elíptica de primeira espécie*, _F_:',
          'Do ponto mais baixo ao ponto de retorno _φ_ cresce de um ângulo reto. Isso leva um quarto do período:',
          'Ninguém precisa fazer a integral. Gauss a achou por médias. Comece com 1 e √(1−_k_²); tome a média aritmética e a geométrica deles, depois as destas, até que ambas sejam um só número, _M_. Então:',
          'Em uma volta _φ_ percorre dois ângulos retos:',
        ],
      },
      inversion: {
        title: 'A função que a desfaz',
        text: [
          'A integral dá o tempo até um ângulo. Queremos o ângulo em um tempo. Então leia ao contrário, como o seno desfaz o arco seno: com _u_ = _F_(_φ_), o seno, o cosseno e a raiz tornam-se funções de _u_:',
          'Há uma figura delas, a elipse da vista Funções. O seu ponto tem a largura _x_. A corda do ponto mais baixo à massa é 2_L_ sin(_θ_/2). Ela é essa largura, vezes 2_Lk_:',
          'Para pequenas oscilações a elipse é um círculo, a corda é o arco, e sn é o seno.',
        ],
      },
      solution: {
        title: 'O movimento, de qualquer início',
        text: [
          'O pêndulo não precisa ser solto do repouso. O lugar onde começa no seu círculo é o primeiro argumento, _u_{0} = _F_(_φ_{0}):',
          'Daí em diante _u_ cresce de _ω_{0} a cada segundo. Desfaça a substituição do passo 4:',
          'Em uma volta _k_ é 1/_κ_, e o ângulo é am, a inversa da própria _F_. Ele conta as suas voltas; um arco seno as dobraria de volta:',
          'Entre os dois, em _κ_ = 1, a integral é elementar:',
        ],
      },
      small: {
        title: 'O limite das pequenas oscilações',
        text: [
          'Quando _k_ vai a 0, a raiz na integral vai a 1. Então _F_(_φ_) é _φ_, e o que a desfaz é o seno:',
          'O que resta é o movimento das primeiras aulas:',
          'Neste tempo o ângulo exato é *{exact}*, e este é *{linear}*.',
        ],
      },
      dropped: {
        title: 'O que as aproximações deixam de fora',
        text: [
          'O movimento linear tem o período _T_{0} em qualquer oscilação. O verdadeiro é 2_K_/π vezes mais longo. Como série no ângulo máximo, ele começa com dois termos que todos usam; o resto fica de fora:',
          'Eles diferem em *{seriesError}* da razão verdadeira. Outra ideia mantém o cosseno e lhe dá o período verdadeiro; _t_{m} é quando voltou pela última vez à direita:',
          'Quanto as fórmulas erram, no máximo, em um período do seu pêndulo:',
          'De onde vêm as duas últimas está escrito para os leitores de Lima e de Salas.',
        ],
      },
    },
    lima: {
      motion: {
        title: 'Equação e energia',
        text: [
          'Uma massa pontual em uma haste rígida sem massa, sem atrito. Uma integração dá a velocidade:',
          'Lima solta do repouso, de modo que _k_ = sin(_θ_{0}/2). Aqui qualquer oscilação serve: _k_ pertence ao seu ângulo máximo.',
        ],
      },
      integral: {
        title: 'A integral própria',
        text: [
          'A substituição faz da integral imprópria uma própria. _k_ é o *módulo*; muitos programas pedem em seu lugar o parâmetro _m_ = _k_².',
          'Um quarto do período é a integral completa:',
        ],
      },
      inversion: {
        title: 'A inversão de Abel e Jacobi',
        text: [
          'As funções de Jacobi desfazem a integral, _u_ = _F_(_φ_). As suas derivadas seguem de d_u_/d_φ_ = 1/dn:',
          'Com _z_ = sin(_θ_/2)/_k_ a equação do movimento tem a mesma forma:',
          'Então _z_ é sn de um argumento que corre com _ω_{0}. O fator livre _C_ de (15) não o é: com _k_ fixo só _C_ = 0 e ±1 resolvem (14). As constantes livres são _k_ e a fase.',
        ],
      },
      solution: {
        title: 'O movimento exato',
        text: [
          'Solto do repouso, a fase é _K_; de qualquer início ela é _u_{0} = _F_(_φ_{0}):',
          'cn dá à velocidade o seu sinal, que a raiz de (5) deixa em aberto.',
        ],
      },
      harmonic: {
        title: 'Um cosseno com o período exato',
        text: [
          'A primeira aproximação mantém o período e abandona a forma. _t_{m} é quando voltou pela última vez à direita, 0 em Lima:',
          'O seu maior erro em um período do seu pêndulo é *{harmonicError}* do ângulo máximo.',
        ],
      },
      series: {
        title: 'A série de Fourier',
        text: [
          'sn é ímpar e tem o período 4_K_, logo é uma soma de senos. O artigo faz a integral dos coeficientes no plano complexo; aqui ela está ao lado do seu valor, para o primeiro:',
          'Quatro termos, postos no arco seno:',
          'Onde os termos tornam o seno maior que 1 não há ângulo: um número ímpar deles o faz nos pontos de retorno, um número par dentro da oscilação. A série do próprio _θ_ não precisa de arco seno; o Lab a desenha.',
        ],
      },
      errors: {
        title: 'O que os termos deixam de fora',
        text: [
          'Nos pontos de retorno todos os senos são ±1, e a soma inteira é conhecida:',
          'Nenhum número finito de termos a dá, e por isso o movimento não começa bem onde foi solto. Quanto as fórmulas erram, no máximo, em um período do seu pêndulo:',
          'O artigo diz que isso é sempre em _t_ = 0 e _T_. Para um número par de termos e grandes oscilações é no interior.',
        ],
      },
    },
    salas: {
      motion: {
        title: 'Qualquer início',
        text: [
          "Dados são um ângulo e uma velocidade, _φ_{0} e a sua derivada em Salas, _θ_{0} e _θ'_{0} aqui. O seu _m_ em (23) é a razão de energia _κ_²:",
        ],
      },
      duffing: {
        title: 'O pêndulo como mola',
        text: [
          'A tangente da metade do ângulo, _u_ = tan(_θ_/2), move-se como uma massa em uma mola de força cúbica: a equação de Duffing. À esquerda está o que a regra da cadeia faz do movimento do próprio pêndulo:',
          'A mola tem uma energia própria:',
        ],
      },
      coefficients: {
        title: 'As duas constantes da mola',
        text: [
          'A equação do pêndulo vale onde os fatores de _u_ e _u_³ se anulam:',
          'Resolvidas para _p_ e _q_. Pela energia elas são mais simples, e têm valor também em 180°:',
          'Na separatriz _q_ é 0: ali a mola é linear.',
        ],
      },
      cosine: {
        title: 'A solução é um cn',
        text: [
          'O artigo experimenta nove das doze funções de Jacobi. Para uma oscilação cn tem constantes reais: _c_{1} é a tangente da metade do ângulo máximo. Então a sua rapidez é _ω_{0}, e o seu parâmetro é outra vez _m_:',
          'A fase é _c_{2} = _a_ − _K_, com _a_ = _F_(_φ_{0}):',
          'Perto do topo _u_ é grande. O movimento não é: a tangente tem ali o seu polo.',
        ],
      },
      start: {
        title: 'Uma fórmula para todo início',
        text: [
          'O teorema da adição de cn elimina a fase. O que resta contém o início tal como é dado, para oscilações e para voltas; _z_ é _ω_{0}_t_, o parâmetro é _m_:',
          'O arco tangente conhece uma só volta, e por isso voltas inteiras se perdem; aqui elas são devolvidas. Fórmulas que as contam:',
          'No caminho, em (14), (15), (17) e (18), fatores e sinais se perderam na impressão. A errata deste projeto os lista.',
        ],
      },
      period: {
        title: 'O período',
        text: [
          'Uma oscilação leva quatro vezes a integral completa. Para uma volta o parâmetro é maior que 1, e o seu inverso toma o lugar:',
          'Três quocientes fazem as vezes de 2_K_/π, os aproximantes de Padé em _m_. Eles estão certos; o fator antes deles não:',
          'Em _m_ = 1 o período é infinito, e estes não são. Para o seu pêndulo (28) difere em *{salasError}* da razão exata.',
        ],
      },
      trigonometric: {
        title: 'Sem funções elípticas',
        text: [
          'O seno torna-se um polinômio de grau 5, e o seu movimento um cosseno sobre uma raiz. Só o ângulo máximo dá _ν_ e _λ_. O tempo conta desde o último retorno:',
          'Quanto as fórmulas erram, no máximo, em um período do seu pêndulo:',
        ],
      },
    },
  },
}
