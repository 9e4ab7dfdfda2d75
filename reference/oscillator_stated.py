"""Figures of oscillators known from elsewhere that the generators must give. Called by a check.

A coefficient is a decimal where it is a text, and a double where it is a number.
"""

from fractions import Fraction

import mpmath as mp
from exact import mpf, real
from general_oscillator import OrbitStates, ScaledOrbit
from oscillator_action import coefficient, periodic

# start, coefficients, then what is known: moments of time with u and u', period, lowest u, action, amplitudes
FIGURES = [
    (
        ("1", "0", {"p": "1", "r": "0.5", "q": "0.2"}),
        {
            "u": ("1", "0.3000267885806011754"),
            "velocity": ("1", "-1.1547746788548712086"),
            "period": "6.2629784656884236426",
            "low": "-1.4019802617689049498",
        },
    ),
    (
        ("1", "0", {"p": "1", "q": "1"}),
        {
            "action": "0.63692176913058357215",
            "amplitude_1": "0.98171061628166613084",
            "amplitude_3": "0.017960677962689629434",
        },
    ),
    (("0.5", "0", {"p": "1", "q": 0.1}), {"period": "6.225139992418638458"}),
    (("1", "0", {"p": "1", "q": 0.1}), {"period": "6.060656736957466768"}),
    (("2", "0", {"p": "1", "q": 0.1}), {"period": "5.51685188810429422"}),
]


def found(name, whole):
    """The value of this name, in the units of the figures."""
    orbit, unit, second = whole.orbit, whole.u_unit, whole.t_unit
    if name in ("u", "velocity"):
        time = whole.times[0]
        u, v = OrbitStates(orbit, [time], [], 2, 200).states[time][0]
        return u * unit if name == "u" else v * unit / second
    if name == "period":
        return orbit.period(120) * second
    if name == "low":
        return orbit.bounds(120)[0] * unit
    if name == "action":
        return orbit.action(120) * unit**2 / second
    return coefficient(periodic(whole, "")[0].values(), int(name.removeprefix("amplitude_"))) * unit


def wrong():
    """The figures that the generators do not give to half a unit of the last digit, with what they give."""
    faults = []
    with mp.workprec(400):
        for (u0, velocity0, force), known in FIGURES:
            start = Fraction(u0), Fraction(velocity0)
            coefficients = {letter: Fraction(x) for letter, x in force.items()}
            for name, text in known.items():
                time, digits = text if isinstance(text, tuple) else ("0", text)
                value = found(name, ScaledOrbit(start, coefficients, [Fraction(time)]))
                last = len(digits.split(".")[1])
                if abs(value - real(Fraction(digits))) > mpf(10) ** -last * 0.5001:
                    faults.append((name, digits, mp.nstr(value, 25)))
    return faults
