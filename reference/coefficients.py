"""Near-minimax coefficients of kernels in core, with their errors: prints them as they stand in the source.

    python reference/coefficients.py

Complete integrals: in y = mc and L = -ln y, K = P + L Q, E = 1 + y (P + L Q), B = (E - mc K)/m = P + y L Q, and
(1 - m B)/mc = P + L Q with polynomials P, Q. They are fitted on nodes that crowd next to y = 0, by least squares of relative
errors with Lawson's reweighting. Form: Cody, Math. Comp. 19 (1965) 105. Logarithm, arctangent, R_C: Chebyshev interpolation.
Series of R_F and R_J in E2, E3, E4, E5: DLMF 19.19.7 in rational numbers, with 1/(2 N + 1) and 3/(2 N + 3). Nome: reversion
of lambda = theta2(q^4)/(2 theta3(q^4)), DLMF 19.5.5.
"""

from collections.abc import Callable
from fractions import Fraction
from math import factorial, prod

from mpmath import atan, atanh, chebyfit, cos, ellipe, ellipk, log, matrix, mp, mpf, pi, qr_solve, sqrt

mp.dps = 60
NODES = 80


def integrals(y: mpf) -> dict[str, tuple[mpf, mpf, mpf, mpf]]:
    """Of each integral: factors of P and Q, what they sum to, the value that the error is relative to."""
    m, log_y = 1 - y, -log(y)
    k, e = ellipk(m), ellipe(m)
    b = (e - y * k) / m
    g = (1 - m * b) / y
    return {"K": (1, log_y, k, k), "E": (y, y * log_y, e - 1, e), "B": (1, y * log_y, b, b), "G": (1, log_y, g, g)}


def fitted(name: str, terms: int, sweeps: int = 9) -> tuple[mpf, list[mpf], list[mpf]]:
    """Largest relative error on the nodes, P and Q."""
    nodes = [((1 - cos(pi * (2 * i + 1) / (2 * NODES))) / 2) ** 2 for i in range(NODES)]
    rows, sums = [], []
    for y in nodes:
        of_p, of_q, total, size = integrals(y)[name]
        rows.append([f * y**j / size for f in (of_p, of_q) for j in range(terms)])
        sums.append(total / size)
    weights = [mpf(1)] * NODES
    best = None
    for _ in range(sweeps):
        roots = [sqrt(weight) for weight in weights]
        system = matrix([[entry * root for entry in row] for row, root in zip(rows, roots, strict=True)])
        solution = list(qr_solve(system, matrix([s * root for s, root in zip(sums, roots, strict=True)]))[0])
        errors = [
            abs(sum(x * entry for x, entry in zip(solution, row, strict=True)) - total)
            for row, total in zip(rows, sums, strict=True)
        ]
        if best is None or max(errors) < best[0]:
            best = (max(errors), solution[:terms], solution[terms:])
        weights = [weight * error for weight, error in zip(weights, errors, strict=True)]
        mean = sum(weights) / NODES
        weights = [weight / mean + mpf(10) ** -12 for weight in weights]
    return best


def artanh_rest(lead: int) -> Callable[[mpf], mpf]:
    """2 artanh s less its first terms, over the power of s that follows, in s^2."""

    def rest(square: mpf) -> mpf:
        if square < mpf(10) ** -9:
            return sum(mpf(2) / (2 * (lead + i) + 1) * square**i for i in range(7))
        s = sqrt(square)
        return (2 * atanh(s) - sum(2 * s ** (2 * i + 1) / (2 * i + 1) for i in range(lead))) / s ** (2 * lead + 1)

    return rest


def printed(name: str, error: mpf, coefficients: list[mpf]) -> None:
    """One array as it stands in the source."""
    print(f"{name}: error {mp.nstr(error, 3)} = 2^{mp.nstr(log(error, 2), 4)}")
    print("    " + ", ".join(repr(float(c)) for c in coefficients) + ",")


def symmetric(kind: int, powers: tuple[int, ...]) -> Fraction:
    """Factor of E2^a E3^b E4^c E5^d, of R_F (`kind` 1) or R_J (3)."""
    degree = sum(place * power for place, power in enumerate(powers, 2))
    count = sum(powers)
    rising = prod((Fraction(1, 2) + i for i in range(count)), start=Fraction(1))
    below = prod(factorial(power) for power in powers)
    return (-1) ** (count + degree) * rising / below * Fraction(kind, 2 * degree + kind)


def print_symmetric(name: str, kind: int, degree: int) -> None:
    """The factors of the powers of E2, a line for each product of powers of E3, E4, E5."""
    beyond = range(1 if kind == 1 else degree // 4 + 1)
    for c, d, b in ((c, d, b) for c in beyond for d in beyond for b in range(degree // 3 + 1)):
        rest = degree - 3 * b - 4 * c - 5 * d
        if rest >= 0:
            factors = [symmetric(kind, (a, b, c, d)) for a in range(rest // 2 + 1)]
            print(f"{name}: E3^{b} E4^{c} E5^{d}")
            print("    " + ", ".join(repr(float(factor)) for factor in factors) + ",")


def product(a: list[int], b: list[int]) -> list[int]:
    """Of two power series of the same length."""
    return [sum(a[i] * b[n - i] for i in range(n + 1)) for n in range(len(a))]


def nome_series(terms: int) -> list[int]:
    """The h of q = lambda h(lambda^4), term by term: lambda = q g(q^4), so that h(l) g(l h(l)^4) = 1."""
    top = [int(any(n == k * (k + 1) for k in range(terms))) for n in range(terms)]
    bottom = [int(n == 0) + 2 * int(any(n == k * k for k in range(1, terms))) for n in range(terms)]
    g: list[int] = []
    for n in range(terms):
        g.append(top[n] - sum(bottom[i] * g[n - i] for i in range(1, n + 1)))
    h = [1] + [0] * (terms - 1)
    for n in range(1, terms):
        inner = [0, *product(product(h, h), product(h, h))[:-1]]
        value, power = [0] * terms, [1] + [0] * (terms - 1)
        for factor in g:
            value = [x + factor * y for x, y in zip(value, power, strict=True)]
            power = product(power, inner)
        h[n] = -product(h, value)[n]
    return h


def arctangent_rest(square: mpf) -> mpf:
    """(atan r - r)/r^3 in r^2."""
    if square < mpf(10) ** -9:
        return -mpf(1) / 3 + square / 5 - square * square / 7
    r = sqrt(square)
    return (atan(r) - r) / r**3


def rc_rest(e: mpf) -> mpf:
    """(R_C(1, 1 + e) - 1)/e."""
    if abs(e) < mpf(10) ** -9:
        return sum((-1) ** i * e ** (i - 1) / mpf(2 * i + 1) for i in range(1, 7))
    root = sqrt(abs(e))
    return ((atan(root) if e > 0 else atanh(root)) / root - 1) / e


def main() -> None:
    """Print every array."""
    print_symmetric("R_F", 1, 13)
    print_symmetric("R_J", 3, 11)
    print("NOME:", nome_series(13)[1:])
    near = mpf("0.172")
    coefficients, error = chebyfit(rc_rest, [-near, near], 15, error=True)
    printed("R_C", error * near, coefficients[::-1])
    last = mpf("0.111")
    coefficients, error = chebyfit(arctangent_rest, [0, last], 10, error=True)
    printed("ARCTANGENT of a short step", error * last, coefficients[::-1])
    for name, terms in (("K", 11), ("E", 10), ("B", 12), ("G", 11)):
        error, p, q = fitted(name, terms)
        printed(f"{name}: P", error, p)
        printed(f"{name}: Q", error, q)
    last = ((sqrt(2) - 1) / (sqrt(2) + 1) * mpf("1.0001")) ** 2
    for name, lead, terms in (("ARTANH", 1, 8), ("LONG_ARTANH", 9, 8)):
        coefficients, error = chebyfit(artanh_rest(lead), [0, last], terms, error=True)
        printed(name, error * last**lead / 2, coefficients[::-1])


if __name__ == "__main__":
    main()
