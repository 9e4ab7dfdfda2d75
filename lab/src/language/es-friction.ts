// Español, de la vista Fricción. Machine-assisted. Marks as in en.ts.

import type { FrictionCatalogue } from './en-friction'

export const esFriction: FrictionCatalogue = {
  values: {
    linear: { label: 'Fricción lineal', symbol: '_γ_' },
    quadratic: { label: 'Cuadrática', symbol: '_β_' },
    dry: { label: 'Seca', symbol: '_μ_' },
    torque: { label: 'Par constante/mL²', symbol: '_τ_{0}' },
    drive: { label: 'Par oscilante/mL²', symbol: '_τ_{1}' },
    driveFrequency: { label: 'Frecuencia', symbol: '_Ω_' },
    until: { label: 'Segundos mostrados', symbol: '' },
  },
  equation: "_θ''_ + 2_γ_ _θ'_ + _β_|_θ'_| _θ'_ + _μ_ sgn _θ'_ + _ω_{0}² sin _θ_ = _τ_{0} + _τ_{1} cos _Ωt_",
  loading: 'Cargando la fricción …',
  failed: 'No se pudo cargar la fricción.',
  again: 'Intentar de nuevo',

  examples: 'Ejemplos',
  presets: {
    weak: 'Péndulo de laboratorio, poco amortiguado',
    dry: 'Fricción seca',
    quadratic: 'Fuerte fricción cuadrática',
    over: 'Lanzado por encima de la cima',
    one: 'Forzado, periodo uno',
    two: 'Forzado, periodo dos',
    chaos: 'Forzado, caótico',
    josephson: 'Rotación constante, como una unión Josephson',
  },

  computing: 'El movimiento *se está calculando*: es un movimiento rápido.',
  endHere: 'Terminar aquí',
  reached: 'Calculado hasta {time}.',
  exact: 'Sin fricción ni par este es el *péndulo exacto* del laboratorio.',
  still: '*Se queda* donde está.',
  stops: '*Se detiene en {angle}* después de *{time}*: la fricción seca lo retiene.',
  halves: '*Pierde la mitad de su energía en {time}*.',
  keeps: 'Después de {time} todavía tiene *{percent}* de su energía.',
  turnsOnce: '*Pasa una vez por la cima*, después oscila.',
  turns: '*Pasa {count} veces por la cima*, después oscila.',
  turnsStill: '*Pasa {count} veces por la cima* en {time}, y sigue girando.',
  rotates: 'El par lo hace *girar sin parar*, en promedio a *{velocity}*.',
  settles: 'El par lo mantiene de lado: después de {time} está en *{angle}*.',
  repeats: 'Forzado, llega a *repetirse en cada periodo* de la fuerza, {period}.',
  repeatsMany: 'Forzado, llega a *repetirse cada {count} periodos* de la fuerza.',
  chaotic:
    'Forzado, *no se repite*: tras {count} periodos de la fuerza no se halla un ciclo de hasta {longest} de ellos.',
  driving: 'Forzado: {count} de {most} periodos están calculados.',
  tooFast: 'Forzado, se vuelve *demasiado rápido* para seguirlo: {count} de {most} periodos están calculados.',

  angle: 'Ángulo',
  angleUnit: 'azul: puntos de retorno; puntos rojos: predicción por promedio; de trazos: sin fricción',
  angleUnitDriven: '_θ_; de trazos: sin fricción ni par',
  energy: 'Energía',
  energyUnit: '% de la energía en la cima; de trazos: sin fricción',
  half: '½',
  phase: 'Retrato de fases',
  phaseUnit: "_θ'_, rad/s",
  section: 'Sección de Poincaré',
  sectionUnit: 'una vez por periodo',
  progress: 'Puntos de la sección',
  points: '{count} de {most} puntos',
  held: 'Rayado: la fricción seca lo retiene.',

  facts: {
    half: 'Mitad de la energía tras',
    rest: 'En reposo desde',
    restAngle: 'en reposo en',
    turns: 'vueltas enteras al final',
    swings: 'puntos de retorno',
    end: 'energía al final',
    quality: 'calidad _Q_ = _ω_{0}/2_γ_',
    qualityLinear: '_Q_ solo de la fricción lineal',
    repeats: 'se repite tras',
    one: 'un periodo de la fuerza',
    periods: '{count} periodos de la fuerza',
    none: '–',
  },

  captionAngle: 'El ángulo de 0 a {to}: entre {least} y {most}, con {count} puntos de retorno.',
  captionEnergy: 'La energía va de {first} a {last} de la energía en la cima.',
  captionPhase:
    'La velocidad en función del ángulo dentro de una vuelta, del inicio a {to}, con la separatriz del péndulo sin fricción.',
  captionSection:
    '{count} puntos de ángulo y velocidad, uno por cada periodo de la fuerza. De un movimiento que se repite solo se dibuja el ciclo.',
  dampedColumn: 'con fricción',
  freeColumn: 'sin',
}
