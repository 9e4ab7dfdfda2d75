// Español, de la vista Deducción. Marcas como en en.ts.

import type { DerivationCatalogue } from './en-derivation'

export const esDerivation: DerivationCatalogue = {
  sentence: 'De la *fuerza* a _θ_(_t_), con sus números. Paso *{step}* de {count}: *{title}*.',
  entry: 'Escrito para',
  entries: { novice: 'Principiantes', lima: 'Lectores de Lima', salas: 'Lectores de Salas' },
  steps: 'Pasos',
  stepName: 'Paso {step}: {title}',
  back: 'Paso anterior',
  next: 'Paso siguiente',
  digits: '{count} cifras coinciden',
  before: 'antes de',
  after: 'después de',
  formula: 'Fórmula',
  not: {
    rest: 'Este péndulo está en reposo.',
    libration: 'Para oscilaciones, no para este movimiento.',
    rotation: 'Para vueltas completas, no para este movimiento.',
    separatrix: 'Para la separatriz, no para este movimiento.',
    moving: 'Este péndulo está en reposo.',
    both: 'Para oscilaciones y vueltas, no para este movimiento.',
    value: 'Sin valor aquí: _u_ es infinito en 180°.',
    arcsine: 'Sin valor aquí: los términos hacen el seno mayor que 1.',
    small: 'Sin números aquí: son menores de lo que el ordenador puede guardar.',
  },
  erratum: 'Errata',
  printed: 'como está impreso',
  corrected: 'corregido',
  truth: 'el movimiento',
  noReal: 'sin valor real',
  noArcsine: 'sin valor real: el arco seno de {argument}',
  notThis: 'La línea no trata de este movimiento: sin número.',
  errata: {
    'salas-9': 'Los puntos, que indican velocidad, están en las letras equivocadas.',
    'salas-10': '_u_{0} y su velocidad están intercambiadas en toda la línea.',
    'salas-25': '_K_/_ω_{0} es un cuarto del periodo. Para vueltas, _m_ > 1, no tiene valor real.',
    'salas-26': 'El factor delante de la fracción la hace un cuarto del periodo.',
    'salas-27': 'El factor delante de la fracción la hace un cuarto del periodo.',
    'salas-28': 'El factor delante de la fracción la hace un cuarto del periodo.',
    'lima-16': 'El sn de Jacobi se ha vuelto un seno. El tiempo cuenta desde el retorno a la derecha.',
    'horsley-3':
      'La raíz de _k_ pertenece al numerador, y sn se ha vuelto un seno. Aquí _k_ es sin²(_θ_{0}/2), _γ_{0} = _κ_/√_k_, _F_{0} la integral del inicio, _H_ el signo de la velocidad. Para _θ_{0} < 0 la línea corregida lleva el otro signo.',
  },
  kind: {
    rest: 'Aquí _κ_² = *{m}*: el péndulo está *en reposo*, y se queda.',
    libration: 'Aquí _κ_² = *{m}*, por debajo de 1: el péndulo *oscila*, hasta *{angle}*.',
    separatrix: 'Aquí _κ_² = *1*: está *en la separatriz*, sube a la cima y nunca llega.',
    rotation: 'Aquí _κ_² = *{m}*, por encima de 1: el péndulo *da vueltas*.',
  },
  forces: {
    name: 'Las fuerzas sobre la masa',
    weight: 'peso _mg_',
    along: '_mg_ sin _θ_',
    across: '_mg_ cos _θ_',
    rod: 'varilla',
    caption:
      'Por cada kilogramo de su péndulo ahora: peso {weight}; del peso, a lo largo del arco {along}, de la varilla {across}; la varilla tira con {pull}.',
  },
  circle: {
    name: 'El círculo de la energía',
    caption:
      "El punto tiene la anchura _θ'_/(2_ω_{0}) = {x} y la altura sin(_θ_/2) = {s}. Se queda a la distancia _κ_ = {kappa}. De trazos: la separatriz, _κ_ = 1: llega justo a la cima.",
    angle: 'Su ángulo es _φ_ = {phi}.',
  },
  coefficients: {
    name: 'Coeficientes de la serie de sn',
    order: '_n_',
    value: '_b_{2n−1}',
    sum: '_k_ por los primeros términos, en el punto de retorno',
  },
  errors: {
    name: 'Mayores errores en un periodo',
    formula: 'fórmula',
    error: 'mayor error, % de _θ_{max}',
    noValue: 'sin valor en una parte de él',
    refused: 'no para este movimiento',
    fourier: 'Lima (22), con _N_ = {n}',
  },

  lessons: {
    novice: {
      force: {
        title: 'La fuerza a lo largo del arco',
        text: [
          'Una masa cuelga de una varilla rígida de longitud _L_ que no pesa nada. _θ_ es su ángulo desde el punto más bajo. Dos fuerzas actúan sobre ella: su peso y la varilla.',
          'La varilla tira en perpendicular al arco, y por eso no puede cambiar la velocidad a lo largo de él. Del peso, la parte _mg_ sin _θ_ apunta a lo largo del arco, de vuelta al punto más bajo. El arco es _Lθ_. La ley de Newton a lo largo de él, por cada kilogramo:',
          'La masa estaba en ambos lados y ha desaparecido. Divida por _L_. Del péndulo queda un solo número, la frecuencia de sus pequeñas oscilaciones:',
          'El signo menos dice que la fuerza apunta de vuelta. El seno es lo que lo hace difícil; el paso 8 prescinde de él.',
        ],
      },
      energy: {
        title: 'De la aceleración a la velocidad',
        text: [
          'La aceleración depende del ángulo, y el ángulo es lo que buscamos. Un truco ayuda: multiplique ambos lados por la velocidad.',
          "Ahora ambos lados son derivadas que conocemos: a la izquierda la de _θ'_²/2, a la derecha la de _ω_{0}² cos _θ_. Así que una suma no cambia nunca. Es la energía, contada desde el punto más bajo; ahora es la que era al inicio:",
          'Con la mitad del ángulo, 1 − cos _θ_ se vuelve un cuadrado:',
        ],
      },
      kind: {
        title: 'Tres tipos de movimiento',
        text: [
          'Divida la energía por la que hace falta para estar en la cima, 2_ω_{0}². Llame al cociente _κ_². El inicio dice cuánto vale, y se conserva:',
          "_θ'_{top} es la velocidad con la que, desde donde empieza, apenas llegaría a la cima.",
        ],
      },
      substitution: {
        title: 'Un ángulo que da la vuelta',
        text: [
          "La última suma es un círculo: su punto tiene la altura sin(_θ_/2) y la anchura _θ'_/(2_ω_{0}), y _κ_ es el radio. Para una oscilación llame al radio _k_, y al ángulo del punto _φ_. Donde _θ_ se vuelve atrás, _φ_ sigue:",
          '¿Con qué rapidez gira? Derive la primera línea y ponga en ella la segunda. El coseno de _φ_ se cancela, y cos(_θ_/2) = √(1 − _k_² sin²_φ_):',
          'Si el péndulo da vueltas, _θ_ mismo sigue siempre. Entonces su mitad es _φ_, con el signo de la vuelta, y _k_ es 1/_κ_:',
        ],
      },
      integral: {
        title: 'El tiempo como integral',
        text: [
          'Cada pequeño paso de _φ_ lleva un tiempo: el paso dividido por la rapidez. Todos juntos son el tiempo desde el inicio, donde _φ_ era _φ_{0}. Esta integral no es una función elemental. Tiene un nombre, la *integral elíptica de primera especie*, _F_:',
          'Del punto más bajo al punto de retorno _φ_ crece en un ángulo recto. Eso lleva un cuarto del periodo:',
          'Nadie tiene que hacer la integral. Gauss la halló por medias. Comience con 1 y √(1−_k_²); tome su media aritmética y su media geométrica, luego las de estas, hasta que ambas sean un solo número, _M_. Entonces:',
          'En una vuelta _φ_ recorre dos ángulos rectos:',
        ],
      },
      inversion: {
        title: 'La función que la deshace',
        text: [
          'La integral da el tiempo hasta un ángulo. Queremos el ángulo en un tiempo. Así que léala al revés, como el seno deshace el arco seno: con _u_ = _F_(_φ_), el seno, el coseno y la raíz se vuelven funciones de _u_:',
          'Hay una figura de ellas, la elipse de la vista Funciones. Su punto tiene la anchura _x_. La cuerda del punto más bajo a la masa es 2_L_ sin(_θ_/2). Es esa anchura, por 2_Lk_:',
          'Para pequeñas oscilaciones la elipse es un círculo, la cuerda es el arco, y sn es el seno.',
        ],
      },
      solution: {
        title: 'El movimiento, desde cualquier inicio',
        text: [
          'El péndulo no tiene que soltarse desde el reposo. El lugar de su círculo donde empieza es el primer argumento, _u_{0} = _F_(_φ_{0}):',
          'Desde ahí _u_ crece en _ω_{0} cada segundo. Deshaga la sustitución del paso 4:',
          'En una vuelta _k_ es 1/_κ_, y el ángulo es am, la inversa de la propia _F_. Cuenta sus vueltas; un arco seno las plegaría:',
          'Entre los dos, en _κ_ = 1, la integral es elemental:',
        ],
      },
      small: {
        title: 'El límite de las pequeñas oscilaciones',
        text: [
          'Cuando _k_ va a 0, la raíz en la integral va a 1. Entonces _F_(_φ_) es _φ_, y lo que la deshace es el seno:',
          'Lo que queda es el movimiento de las primeras clases:',
          'En este tiempo el ángulo exacto es *{exact}*, y este es *{linear}*.',
        ],
      },
      dropped: {
        title: 'Lo que dejan fuera las aproximaciones',
        text: [
          'El movimiento lineal tiene el periodo _T_{0} en cualquier oscilación. El verdadero es 2_K_/π veces más largo. Como serie en el ángulo máximo empieza con dos términos que todos usan; el resto se deja fuera:',
          'Difieren en *{seriesError}* de la razón verdadera. Otra idea conserva el coseno y le da el periodo verdadero; _t_{m} es cuando se volvió por última vez a la derecha:',
          'Cuánto yerran las fórmulas, como máximo, en un periodo de su péndulo:',
          'De dónde vienen las dos últimas está escrito para los lectores de Lima y de Salas.',
        ],
      },
    },
    lima: {
      motion: {
        title: 'Ecuación y energía',
        text: [
          'Una masa puntual en una varilla rígida sin masa, sin fricción. Una integración da la velocidad:',
          'Lima suelta desde el reposo, de modo que _k_ = sin(_θ_{0}/2). Aquí vale cualquier oscilación: _k_ pertenece a su ángulo máximo.',
        ],
      },
      integral: {
        title: 'La integral propia',
        text: [
          'La sustitución hace de la integral impropia una propia. _k_ es el *módulo*; muchos programas piden en su lugar el parámetro _m_ = _k_².',
          'Un cuarto del periodo es la integral completa:',
        ],
      },
      inversion: {
        title: 'La inversión de Abel y Jacobi',
        text: [
          'Las funciones de Jacobi deshacen la integral, _u_ = _F_(_φ_). Sus derivadas siguen de d_u_/d_φ_ = 1/dn:',
          'Con _z_ = sin(_θ_/2)/_k_ la ecuación del movimiento tiene la misma forma:',
          'Así que _z_ es sn de un argumento que corre con _ω_{0}. El factor libre _C_ de (15) no lo es: con _k_ fijo solo _C_ = 0 y ±1 resuelven (14). Las constantes libres son _k_ y la fase.',
        ],
      },
      solution: {
        title: 'El movimiento exacto',
        text: [
          'Soltado desde el reposo, la fase es _K_; desde cualquier inicio es _u_{0} = _F_(_φ_{0}):',
          'cn da a la velocidad su signo, que la raíz de (5) deja abierto.',
        ],
      },
      harmonic: {
        title: 'Un coseno con el periodo exacto',
        text: [
          'La primera aproximación conserva el periodo y abandona la forma. _t_{m} es cuando se volvió por última vez a la derecha, 0 en Lima:',
          'Su mayor error en un periodo de su péndulo es *{harmonicError}* del ángulo máximo.',
        ],
      },
      series: {
        title: 'La serie de Fourier',
        text: [
          'sn es impar y tiene el periodo 4_K_, luego es una suma de senos. El artículo hace la integral de los coeficientes en el plano complejo; aquí está junto a su valor, para el primero:',
          'Cuatro términos, puestos en el arco seno:',
          'Donde los términos hacen el seno mayor que 1 no hay ángulo: un número impar de ellos lo hace en los puntos de retorno, un número par dentro de la oscilación. La serie del propio _θ_ no necesita arco seno; el Lab la dibuja.',
        ],
      },
      errors: {
        title: 'Lo que dejan fuera los términos',
        text: [
          'En los puntos de retorno todos los senos son ±1, y la suma entera es conocida:',
          'Ningún número finito de términos la da, y por eso el movimiento no empieza del todo donde se soltó. Cuánto yerran las fórmulas, como máximo, en un periodo de su péndulo:',
          'El artículo dice que esto es siempre en _t_ = 0 y _T_. Para un número par de términos y grandes oscilaciones es en el interior.',
        ],
      },
    },
    salas: {
      motion: {
        title: 'Cualquier inicio',
        text: [
          "Se dan un ángulo y una velocidad, _φ_{0} y su derivada en Salas, _θ_{0} y _θ'_{0} aquí. Su _m_ en (23) es la razón de energía _κ_²:",
        ],
      },
      duffing: {
        title: 'El péndulo como resorte',
        text: [
          'La tangente de la mitad del ángulo, _u_ = tan(_θ_/2), se mueve como una masa en un resorte de fuerza cúbica: la ecuación de Duffing. A la izquierda está lo que la regla de la cadena hace del movimiento del propio péndulo:',
          'El resorte tiene una energía propia:',
        ],
      },
      coefficients: {
        title: 'Las dos constantes del resorte',
        text: [
          'La ecuación del péndulo vale donde los factores de _u_ y _u_³ se anulan:',
          'Resueltas para _p_ y _q_. Por la energía son más simples, y tienen valor también en 180°:',
          'En la separatriz _q_ es 0: allí el resorte es lineal.',
        ],
      },
      cosine: {
        title: 'La solución es un cn',
        text: [
          'El artículo prueba nueve de las doce funciones de Jacobi. Para una oscilación cn tiene constantes reales: _c_{1} es la tangente de la mitad del ángulo máximo. Entonces su rapidez es _ω_{0}, y su parámetro otra vez _m_:',
          'La fase es _c_{2} = _a_ − _K_, con _a_ = _F_(_φ_{0}):',
          'Cerca de la cima _u_ es grande. El movimiento no lo es: la tangente tiene allí su polo.',
        ],
      },
      start: {
        title: 'Una fórmula para todo inicio',
        text: [
          'El teorema de adición de cn quita la fase. Lo que queda contiene el inicio tal como se da, para oscilaciones y para vueltas; _z_ es _ω_{0}_t_, el parámetro es _m_:',
          'El arco tangente conoce una sola vuelta, y por eso se pierden vueltas enteras; aquí se devuelven. Fórmulas que las cuentan:',
          'En el camino, en (14), (15), (17) y (18), factores y signos se pierden en la impresión. Las erratas de este proyecto los enumeran.',
        ],
      },
      period: {
        title: 'El periodo',
        text: [
          'Una oscilación lleva cuatro veces la integral completa. Para una vuelta el parámetro es mayor que 1, y su inverso toma su lugar:',
          'Tres cocientes hacen las veces de 2_K_/π, los aproximantes de Padé en _m_. Son correctos; el factor delante de ellos no:',
          'En _m_ = 1 el periodo es infinito, y estos no lo son. Para su péndulo (28) difiere en *{salasError}* de la razón exacta.',
        ],
      },
      trigonometric: {
        title: 'Sin funciones elípticas',
        text: [
          'El seno se vuelve un polinomio de grado 5, y su movimiento un coseno sobre una raíz. El ángulo máximo basta para _ν_ y _λ_. El tiempo cuenta desde el último retorno:',
          'Cuánto yerran las fórmulas, como máximo, en un periodo de su péndulo:',
        ],
      },
    },
  },
}
