"""Numbers as people read them: a real minus sign, and powers of ten with raised digits."""

SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def number_text(value: float, digits: int = 6) -> str:
    """`−1.2×10⁻⁷`: a number to so many digits.

    Examples
    --------
    >>> from libration._number_text import number_text
    >>> print(number_text(-0.25), number_text(1e6), number_text(1.25e-7, 2))
    −0.25 10⁶ 1.2×10⁻⁷
    """
    mantissa, e, exponent = f"{value:.{digits}g}".partition("e")
    if not e:
        return mantissa.replace("-", "−")
    power = f"10{str(int(exponent)).translate(SUPERSCRIPTS)}"
    front = {"1": "", "-1": "−"}.get(mantissa, mantissa.replace("-", "−") + "×")
    return front + power
