"""The words of the texts and the pages of a fit in English, Portuguese of Brazil and Spanish.

Terms of uncertainty are those of the International Vocabulary of Metrology (VIM) in each language.
"""

from dataclasses import dataclass
from typing import ClassVar

from ..plot._language import Language
from ._sentences import in_language

# English: Portuguese, Spanish.
CATALOGUE = {
    "Pendulum fit: {name}": ("Ajuste de pêndulo: {name}", "Ajuste de péndulo: {name}"),
    "{count} records together": ("{count} registros em conjunto", "{count} registros en conjunto"),
    "To quote:": ("Para citar:", "Para citar:"),
    "Result": ("Resultado", "Resultado"),
    "Verdicts": ("Vereditos", "Veredictos"),
    "DO NOT QUOTE": ("NÃO CITAR", "NO CITAR"),
    "warning": ("aviso", "aviso"),
    "note": ("nota", "nota"),
    "Data with the fitted curve, and residuals": (
        "Dados com a curva ajustada, e resíduos",
        "Datos con la curva ajustada, y residuos",
    ),
    "Data with the fitted curve; residuals below": (
        "Dados com a curva ajustada; resíduos abaixo",
        "Datos con la curva ajustada; residuos abajo",
    ),
    "Period against swing": ("Período em função da amplitude", "Periodo en función de la amplitud"),
    "Each dot is one period of the record; the curve is the exact law at the fitted omega0.": (
        "Cada ponto é um período do registro; a curva é a lei exata com o omega0 ajustado.",
        "Cada punto es un periodo del registro; la curva es la ley exacta con el omega0 ajustado.",
    ),
    "Budget of uncertainty": ("Balanço de incertezas", "Balance de incertidumbres"),
    "source": ("fonte", "fuente"),
    "u in {unit}": ("u em {unit}", "u en {unit}"),
    "of the variance": ("da variância", "de la varianza"),
    "{name}, combined": ("{name}, combinada", "{name}, combinada"),
    "{name}, expanded (k = 2)": ("{name}, expandida (k = 2)", "{name}, expandida (k = 2)"),
    "Monte Carlo, 95 %": ("Monte Carlo, 95 %", "Monte Carlo, 95 %"),
    "{low} to {high} {unit}": ("{low} a {high} {unit}", "{low} a {high} {unit}"),
    "If the residuals were independent, the fit's part would be {u} {unit}; it is not taken so.": (
        "Se os resíduos fossem independentes, a parte do ajuste seria {u} {unit}; ela não é tomada assim.",
        "Si los residuos fueran independientes, la parte del ajuste sería {u} {unit}; no se toma así.",
    ),
    "The length was given without an uncertainty and is taken as exact.": (
        "O comprimento foi dado sem incerteza e é tomado como exato.",
        "La longitud se dio sin incertidumbre y se toma como exacta.",
    ),
    "The gravity was given without an uncertainty and is taken as exact.": (
        "A gravidade foi dada sem incerteza e é tomada como exata.",
        "La gravedad se dio sin incertidumbre y se toma como exacta.",
    ),
    "Corrections": ("Correções", "Correcciones"),
    "effect": ("efeito", "efecto"),
    "change of the period": ("variação do período", "cambio del periodo"),
    "corrected": ("corrigido", "corregido"),
    "yes": ("sim", "sí"),
    "no": ("não", "no"),
    "no: neither g nor the length is quoted": (
        "não: nem g nem o comprimento é citado",
        "no: no se cita ni g ni la longitud",
    ),
    "bob size": ("tamanho da massa", "tamaño de la masa"),
    "wire mass": ("massa do fio", "masa del hilo"),
    "buoyancy": ("empuxo", "empuje"),
    "added mass": ("massa adicionada", "masa añadida"),
    "Friction models": ("Modelos de atrito", "Modelos de fricción"),
    "friction": ("atrito", "fricción"),
    "rms residual": ("resíduo rms", "residuo rms"),
    "omega0 in rad/s": ("omega0 em rad/s", "omega0 en rad/s"),
    "What was read": ("O que foi lido", "Lo que se leyó"),
    "Fitted: {window}.": ("Ajustado: {window}.", "Ajustado: {window}."),
    "What was left out": ("O que foi deixado de fora", "Lo que se dejó fuera"),
    "nothing": ("nada", "nada"),
    "Made by libration {version}. Uncertainties are standard ones, k = 1 (JCGM 100:2008).": (
        "Feito com libration {version}. As incertezas são incertezas-padrão, k = 1 (JCGM 100:2008).",
        "Hecho con libration {version}. Las incertidumbres son típicas, k = 1 (JCGM 100:2008).",
    ),
    # The plain lines.
    "file": ("arquivo", "archivo"),
    "understood": ("entendido", "entendido"),
    "dropped": ("deixado de fora", "dejado fuera"),
    "window": ("janela", "ventana"),
    "with": ("com", "con"),
    "rms": ("rms", "rms"),
    "tried": ("tentados", "probados"),
    " <- chosen": (" <- escolhido", " <- elegida"),
    " (held at 0: {terms})": (" (mantido em 0: {terms})", " (mantenido en 0: {terms})"),
    "{change} of the period, corrected: {made}": (
        "{change} do período, corrigido: {made}",
        "{change} del periodo, corregido: {made}",
    ),
    "u of {name}": ("u de {name}", "u de {name}"),
    "{u} {unit}, of which": ("{u} {unit}, dos quais", "{u} {unit}, de los cuales"),
    "({u} {unit}, if the residuals were independent; they are not taken so)": (
        "({u} {unit}, se os resíduos fossem independentes; não são tomados assim)",
        "({u} {unit}, si los residuos fueran independientes; no se toman así)",
    ),
    "to quote": ("para citar", "para citar"),
    # The result.
    "omega0": ("omega0", "omega0"),
    "g": ("g", "g"),
    "length": ("comprimento", "longitud"),
    "{value} (given)": ("{value} (valor dado)", "{value} (valor dado)"),
    "model": ("modelo", "modelo"),
    "linear friction": ("atrito linear", "fricción lineal"),
    "quadratic friction": ("atrito quadrático", "fricción cuadrática"),
    "dry friction": ("atrito seco", "fricción seca"),
    "Equation: {equation} = 0": ("Equação: {equation} = 0", "Ecuación: {equation} = 0"),
    "presliding angle": ("ângulo de pré-deslizamento", "ángulo de predeslizamiento"),
    "rest at": ("repouso em", "reposo en"),
    "sensor at": ("sensor a", "sensor a"),
    "{value} m from the pivot": ("{value} m do pivô", "{value} m del pivote"),
    "scale of angle": ("escala do ângulo", "escala del ángulo"),
    "none": ("nenhum", "ninguna"),
    "linear": ("linear", "lineal"),
    "quadratic": ("quadrático", "cuadrática"),
    "dry": ("seco", "seca"),
    "presliding": ("pré-deslizamento", "predeslizamiento"),
    "no friction": ("sem atrito", "sin fricción"),
    "{terms} friction": ("atrito {terms}", "fricción {terms}"),
    "{first} and {last}": ("{first} e {last}", "{first} y {last}"),
    "the exact period of each swing": ("o período exato de cada oscilação", "el periodo exacto de cada oscilación"),
    # Sources of a budget.
    "fit": ("ajuste", "ajuste"),
    "gravity": ("gravidade", "gravedad"),
    "scale and clock": ("escala e relógio", "escala y reloj"),
    "corrections": ("correções", "correcciones"),
    "lengths": ("comprimentos", "longitudes"),
    "first period": ("primeiro período", "primer periodo"),
    "second period": ("segundo período", "segundo periodo"),
    "first distance": ("primeira distância", "primera distancia"),
    "second distance": ("segunda distância", "segunda distancia"),
    "distance between": ("distância entre os pivôs", "distancia entre los pivotes"),
    # The window and what was left out.
    "all {count} periods{swing}": ("todos os {count} períodos{swing}", "los {count} periodos{swing}"),
    "; the largest swing is {swing} deg": ("; a maior amplitude é {swing} deg", "; la amplitud mayor es {swing} deg"),
    "{first} s to {last} s, {reason}: {count} samples{swing}": (
        "{first} s a {last} s, {reason}: {count} amostras{swing}",
        "{first} s a {last} s, {reason}: {count} muestras{swing}",
    ),
    "as stated": ("como indicado", "como se indicó"),
    "from the release to the stop": ("da soltura à parada", "desde la suelta hasta la parada"),
    "all rows": ("todas as linhas", "todas las filas"),
    "{count} row: {reason} (row {rows})": (
        "{count} linha: {reason} (linha {rows})",
        "{count} fila: {reason} (fila {rows})",
    ),
    "{count} rows: {reason} (rows {rows})": (
        "{count} linhas: {reason} (linhas {rows})",
        "{count} filas: {reason} (filas {rows})",
    ),
    # The sentence to quote.
    "nothing: {verdict}": ("nada: {verdict}", "nada: {verdict}"),
    "{quantity} = {value} {unit} (standard uncertainty, k = 1; {expanded} {unit} at k = 2), {how}.": (
        "{quantity} = {value} {unit} (incerteza-padrão, k = 1; {expanded} {unit} com k = 2), {how}.",
        "{quantity} = {value} {unit} (incertidumbre típica, k = 1; {expanded} {unit} con k = 2), {how}.",
    ),
    "from {count} samples{swings}, fitted by {equation}": (
        "de {count} amostras{swings}, ajustadas com {equation}",
        "de {count} muestras{swings}, ajustadas por {equation}",
    ),
    "from {count} periods{swings}, fitted by {equation}": (
        "de {count} períodos{swings}, ajustados com {equation}",
        "de {count} periodos{swings}, ajustados por {equation}",
    ),
    " of swings up to {swing} deg": (" de oscilações de até {swing} deg", " de oscilaciones de hasta {swing} deg"),
    "the pendulum equation with {friction}": (
        "a equação do pêndulo com {friction}",
        "la ecuación del péndulo con {friction}",
    ),
    "the pendulum equation without friction": (
        "a equação do pêndulo sem atrito",
        "la ecuación del péndulo sin fricción",
    ),
    # Records together.
    "fitted by {equation}": ("ajustados com {equation}", "ajustados por {equation}"),
    "swing": ("amplitude", "amplitud"),
    "pivot": ("pivô", "pivote"),
    "runs of one pendulum": ("medições de um mesmo pêndulo", "mediciones de un mismo péndulo"),
    "one g at several lengths": ("um mesmo g com vários comprimentos", "una misma g con varias longitudes"),
    "a reversible pendulum": ("um pêndulo reversível", "un péndulo reversible"),
    "agreement": ("concordância", "concordancia"),
    "chi squared {chi} for 1 degree of freedom": (
        "qui-quadrado {chi} para 1 grau de liberdade",
        "ji cuadrado {chi} para 1 grado de libertad",
    ),
    "chi squared {chi} for {count} degrees of freedom": (
        "qui-quadrado {chi} para {count} graus de liberdade",
        "ji cuadrado {chi} para {count} grados de libertad",
    ),
    "missing in each length": ("falta em cada comprimento", "falta en cada longitud"),
    "What the records share": ("O que os registros compartilham", "Lo que comparten los registros"),
    "from {count} records of one pendulum": (
        "de {count} registros de um mesmo pêndulo",
        "de {count} registros de un mismo péndulo",
    ),
    "from {count} lengths": ("de {count} comprimentos", "de {count} longitudes"),
    "from {count} lengths with a common error of them": (
        "de {count} comprimentos com um erro em comum",
        "de {count} longitudes con un error en común",
    ),
    "from the periods about both pivots of a reversible pendulum": (
        "dos períodos em torno dos dois pivôs de um pêndulo reversível",
        "de los periodos alrededor de los dos pivotes de un péndulo reversible",
    ),
}


@dataclass(frozen=True)
class Words(Language):
    """The language of a text: its words, its decimal sign, and the sentences of the core.

    Parameters
    ----------
    name : str
        `en`, `pt-BR` or `es`, in any letters; `pt` too.

    Raises
    ------
    ValueError
        For another name.

    Examples
    --------
    >>> from libration.measurement._words import Words
    >>> Words("es").word("Verdicts"), Words("pt").told("the record holds 1.2 periods: friction and rest are hardly determined")
    ('Veredictos', 'o registro contém 1,2 períodos: o atrito e o repouso são mal determinados')
    """

    catalogue: ClassVar = Language.catalogue | CATALOGUE

    def told(self, sentence: str) -> str:
        """A sentence of the core in this language."""
        return in_language(sentence, self.name) if self.comma else sentence


ENGLISH = Words("en")
