"""The words of the pictures in English, Portuguese of Brazil and Spanish, and numbers with the decimal sign of each."""

from __future__ import annotations

import functools
from dataclasses import dataclass
from typing import Any, ClassVar

from .._languages import LANGUAGES, known_language
from .._number_text import number_text

# English: Portuguese, Spanish. Names of formulas and symbols are the same in all.
CATALOGUE = {
    "exact": ("exata", "exacta"),
    "linear": ("linear", "lineal"),
    "instants": ("instantes", "instantes"),
    "turning angle": ("ângulo máximo", "ángulo máximo"),
    "this motion": ("este movimento", "este movimiento"),
    "other energies": ("outras energias", "otras energías"),
    "separatrix": ("separatriz", "separatriz"),
    "without friction": ("sem atrito", "sin fricción"),
    "envelope in the mean": ("envoltória em média", "envolvente en promedio"),
    "held by dry friction": ("parado pelo atrito seco", "detenido por la fricción seca"),
    "energy per unit inertia [rad²/s²]": (
        "energia por unidade de inércia [rad²/s²]",
        "energía por unidad de inercia [rad²/s²]",
    ),
    "enlarged": ("ampliado", "ampliado"),
    "{axis}, the first {shown} of {all} s": (
        "{axis}, os primeiros {shown} de {all} s",
        "{axis}, los primeros {shown} de {all} s",
    ),
    "{axis}, {shown} of {all} s": ("{axis}, {shown} de {all} s", "{axis}, {shown} de {all} s"),
    "{axis}, the first {shown} of {all} periods": (
        "{axis}, os primeiros {shown} de {all} períodos",
        "{axis}, los primeros {shown} de {all} periodos",
    ),
    "θ wrapped to one turn [rad]": ("θ reduzido a uma volta [rad]", "θ reducido a una vuelta [rad]"),
    "{start}: separatrix, the top is approached and never reached": (
        "{start}: separatriz, tende ao topo e nunca o alcança",
        "{start}: separatriz, tiende a la posición superior y nunca la alcanza",
    ),
    "{start}: rotation, one turn in {period} s": (
        "{start}: rotação, uma volta em {period} s",
        "{start}: rotación, una vuelta en {period} s",
    ),
    "{start}: rest, without a force": ("{start}: repouso, sem força", "{start}: reposo, sin fuerza"),
    "{start}: rest, small swings would take {period} s": (
        "{start}: repouso, pequenas oscilações levariam {period} s",
        "{start}: reposo, las oscilaciones pequeñas durarían {period} s",
    ),
    "{start}: libration, period {period} s, turning angle {angle}": (
        "{start}: libração, período {period} s, ângulo máximo {angle}",
        "{start}: libración, periodo {period} s, ángulo máximo {angle}",
    ),
    "{angle} from π": ("{angle} a partir de π", "{angle} a partir de π"),
    "{start}: libration, T = {period} s": ("{start}: libração, T = {period} s", "{start}: libración, T = {period} s"),
    "{start}: rotation, T = {period} s": ("{start}: rotação, T = {period} s", "{start}: rotación, T = {period} s"),
    "error [% of θmax]": ("erro [% de θmax]", "error [% de θmax]"),
    "error [rad]": ("erro [rad]", "error [rad]"),
    "|error| [% of θmax]": ("|erro| [% de θmax]", "|error| [% de θmax]"),
    "|error| [rad]": ("|erro| [rad]", "|error| [rad]"),
    "{axis}; hatched: undefined": ("{axis}; hachurado: sem valor", "{axis}; rayado: sin valor"),
    "Period of a pendulum against its turning angle": (
        "Período de um pêndulo em função do ângulo máximo",
        "Periodo de un péndulo en función del ángulo máximo",
    ),
    "turning angle θmax [degrees]": ("ângulo máximo θmax [graus]", "ángulo máximo θmax [grados]"),
    "turning angle θmax [degrees]; broad: the range that its author states": (
        "ângulo máximo θmax [graus]; largo: o intervalo que o autor indica",
        "ángulo máximo θmax [grados]; ancho: el intervalo que indica el autor",
    ),
    "T/T₀, exact and every formula": ("T/T₀, exata e todas as fórmulas", "T/T₀, exacta y todas las fórmulas"),
    "powers of the angle": ("potências do ângulo", "potencias del ángulo"),
    "sine and cosine of the angle": ("seno e cosseno do ângulo", "seno y coseno del ángulo"),
    "logarithms": ("logaritmos", "logaritmos"),
    "arithmetic-geometric mean": ("média aritmético-geométrica", "media aritmético-geométrica"),
    "rational in m": ("racionais em m", "racionales en m"),
    "other formulas": ("outras fórmulas", "otras fórmulas"),
    "|relative error|": ("|erro relativo|", "|error relativo|"),
    "escape": ("escape", "escape"),
    "u(t)": ("u(t)", "u(t)"),
    "{start}: {regime}, period {period} s": (
        "{start}: {regime}, período {period} s",
        "{start}: {regime}, periodo {period} s",
    ),
    "{start}: {regime} at t = {ends}": ("{start}: {regime} em t = {ends}", "{start}: {regime} en t = {ends}"),
    "{first} s and {second} s": ("{first} s e {second} s", "{first} s y {second} s"),
    "rest": ("repouso", "reposo"),
    "libration": ("libração", "libración"),
    "well": ("oscilação em um poço", "oscilación en un pozo"),
    "homoclinic": ("homoclínica", "homoclínica"),
    "heteroclinic": ("heteroclínica", "heteroclínica"),
    "measured": ("medido", "medido"),
    "fitted": ("ajustado", "ajustado"),
    "degrees": ("graus", "grados"),
    "angle [degrees]": ("ângulo [graus]", "ángulo [grados]"),
    "angular velocity [rad/s]": ("velocidade angular [rad/s]", "velocidad angular [rad/s]"),
    "acceleration [m/s²]": ("aceleração [m/s²]", "aceleración [m/s²]"),
    "period [s]": ("período [s]", "periodo [s]"),
    "residual [{unit}]": ("resíduo [{unit}]", "residuo [{unit}]"),
    "together": ("em conjunto", "en conjunto"),
    "record": ("registro", "registro"),
    "slope 4π²/g": ("inclinação 4π²/g", "pendiente 4π²/g"),
    "length ℓ [m]": ("comprimento ℓ [m]", "longitud ℓ [m]"),
    "Not a result: a verdict speaks against it": (
        "Não é um resultado: um veredito o contradiz",
        "No es un resultado: un veredicto lo contradice",
    ),
}


@dataclass(frozen=True)
class Language:
    """The language of a picture: its words and its decimal sign.

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
    >>> from libration.plot._language import Language
    >>> spanish = Language("es")
    >>> spanish.word("exact"), spanish.number(-0.5)
    ('exacta', '−0,5')
    """

    name: str
    catalogue: ClassVar[dict[str, tuple[str, str]]] = CATALOGUE

    def __post_init__(self) -> None:
        known = known_language(self.name)
        if known is None:
            raise ValueError(f"lang = {self.name!r}: must be en, pt-BR or es")
        object.__setattr__(self, "name", known)

    @property
    def comma(self) -> bool:
        """Whether the decimal sign is a comma."""
        return self.name != "en"

    def word(self, text: str, **parts: str) -> str:
        """An English text of the catalogue in this language, with its parts put in."""
        if self.comma:
            text = self.catalogue[text][LANGUAGES.index(self.name) - 1]
        return text.format(**parts) if parts else text

    def number(self, value: float, digits: int = 6) -> str:
        """A number with a real minus sign and the decimal sign of the language."""
        return self.decimal(number_text(value, digits))

    def decimal(self, text: str) -> str:
        """A number as text with the decimal sign of the language."""
        return text.replace(".", ",") if self.comma else text

    def ticks(self, *axes: Any) -> None:
        """Give the numbers on linear axes the decimal sign of the language."""
        if not self.comma:
            return
        from matplotlib.ticker import ScalarFormatter

        for each in axes:
            for axis in (each.xaxis, each.yaxis):
                if type(axis.get_major_formatter()) is ScalarFormatter:
                    axis.set_major_formatter(comma_formatter())


ENGLISH = Language("en")


@functools.cache
def comma_kind() -> Any:
    """The formatter of ticks with a decimal comma; made when matplotlib is there."""
    from matplotlib.ticker import ScalarFormatter

    def tick(self: Any, x: float, pos: Any = None) -> str:
        return str(ScalarFormatter.__call__(self, x, pos)).replace(".", ",")

    def offset(self: Any) -> str:
        return str(ScalarFormatter.get_offset(self)).replace(".", ",")

    return type("CommaFormatter", (ScalarFormatter,), {"__call__": tick, "get_offset": offset})


def comma_formatter() -> Any:
    """A formatter of its own for an axis."""
    return comma_kind()()
