// Português do Brasil, da vista Atrito. Machine-assisted. Marks as in en.ts.

import type { FrictionCatalogue } from './en-friction'

export const ptBRFriction: FrictionCatalogue = {
  values: {
    linear: { label: 'Atrito linear', symbol: '_γ_' },
    quadratic: { label: 'Quadrático', symbol: '_β_' },
    dry: { label: 'Seco', symbol: '_μ_' },
    torque: { label: 'Torque constante/mL²', symbol: '_τ_{0}' },
    drive: { label: 'Torque oscilante/mL²', symbol: '_τ_{1}' },
    driveFrequency: { label: 'Frequência', symbol: '_Ω_' },
    until: { label: 'Segundos mostrados', symbol: '' },
  },
  equation: "_θ''_ + 2_γ_ _θ'_ + _β_|_θ'_| _θ'_ + _μ_ sgn _θ'_ + _ω_{0}² sin _θ_ = _τ_{0} + _τ_{1} cos _Ωt_",
  loading: 'Carregando o atrito …',
  failed: 'O atrito não pôde ser carregado.',
  again: 'Tentar de novo',

  examples: 'Exemplos',
  presets: {
    weak: 'Pêndulo de laboratório, pouco amortecido',
    dry: 'Atrito seco',
    quadratic: 'Forte atrito quadrático',
    over: 'Lançado por cima do topo',
    one: 'Forçado, período um',
    two: 'Forçado, período dois',
    chaos: 'Forçado, caótico',
    josephson: 'Rotação constante, como uma junção Josephson',
  },

  computing: 'O movimento *está sendo calculado*: é um movimento rápido.',
  endHere: 'Parar aqui',
  reached: 'Calculado até {time}.',
  exact: 'Sem atrito nem torque este é o *pêndulo exato* do laboratório.',
  still: 'Ele *fica* onde está.',
  stops: 'Ele *para em {angle}* depois de *{time}*: o atrito seco o segura.',
  halves: 'Ele *perde metade da energia em {time}*.',
  keeps: 'Depois de {time} ainda tem *{percent}* da sua energia.',
  turnsOnce: 'Ele *passa uma vez pelo topo*, depois oscila.',
  turns: 'Ele *passa {count} vezes pelo topo*, depois oscila.',
  turnsStill: 'Ele *passa {count} vezes pelo topo* em {time}, e continua a girar.',
  rotates: 'O torque o faz *girar sem parar*, em média a *{velocity}*.',
  settles: 'O torque o mantém de lado: depois de {time} está em *{angle}*.',
  repeats: 'Forçado, ele passa a *repetir-se a cada período* da força, {period}.',
  repeatsMany: 'Forçado, ele passa a *repetir-se a cada {count} períodos* da força.',
  chaotic:
    'Forçado, ele *não se repete*: depois de {count} períodos da força não se encontra ciclo de até {longest} deles.',
  driving: 'Forçado: {count} de {most} períodos estão calculados.',
  tooFast: 'Forçado, ele fica *rápido demais* para ser seguido: {count} de {most} períodos estão calculados.',

  angle: 'Ângulo',
  angleUnit: 'azul: pontos de retorno; pontos vermelhos: previsão pela média; tracejado: sem atrito',
  angleUnitDriven: '_θ_; tracejado: sem atrito nem torque',
  energy: 'Energia',
  energyUnit: '% da energia no topo; tracejado: sem atrito',
  half: '½',
  phase: 'Retrato de fase',
  phaseUnit: "_θ'_, rad/s",
  section: 'Seção de Poincaré',
  sectionUnit: 'uma vez por período',
  progress: 'Pontos da seção',
  points: '{count} de {most} pontos',
  held: 'Hachurado: o atrito seco o segura.',

  facts: {
    half: 'Metade da energia após',
    rest: 'Em repouso desde',
    restAngle: 'em repouso em',
    turns: 'voltas inteiras no fim',
    swings: 'pontos de retorno',
    end: 'energia no fim',
    quality: 'qualidade _Q_ = _ω_{0}/2_γ_',
    qualityLinear: '_Q_ só do atrito linear',
    repeats: 'repete-se após',
    one: 'um período da força',
    periods: '{count} períodos da força',
    none: '–',
  },

  captionAngle: 'O ângulo de 0 a {to}: entre {least} e {most}, com {count} pontos de retorno.',
  captionEnergy: 'A energia vai de {first} a {last} da energia no topo.',
  captionPhase:
    'A velocidade em função do ângulo dentro de uma volta, do início até {to}, com a separatriz do pêndulo sem atrito.',
  captionSection:
    '{count} pontos de ângulo e velocidade, um para cada período da força. De um movimento que se repete desenha-se só o ciclo.',
  dampedColumn: 'com atrito',
  freeColumn: 'sem',
}
