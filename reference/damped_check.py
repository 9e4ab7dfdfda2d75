"""Checks damped.csv and damped_slopes.csv by another method; called by check.py.

The second route is Gauss's collocation with 20 stages (order 40): implicit, with sine and cosine of the angle taken where they
are needed, no series. A turn is the step after which the velocity vanishes, found by secants; presliding follows the angle in
closed form, 1 - z side = u exp(-side (theta - theta_turn)/presliding). Derivatives are one-sided differences of that.
"""

import functools

import damped
import damped_inputs
import exact
import mpmath as mp
from table import counted, fail, mutated

FILES = ("damped.csv", "damped_slopes.csv")
STAGES = 20
DIGITS = 45
# Rows up to this time are computed anew, and how many.
LONGEST, SAMPLE = 4, 10


@functools.cache
def collocation():
    """Nodes in [0, 1], the integrals of Lagrange's polynomials up to each node, and up to 1."""
    roots = mp.polyroots(mp.taylor(lambda x: mp.legendre(STAGES, x), 0, STAGES)[::-1], maxsteps=200, extraprec=400)
    nodes = sorted((1 + mp.re(root)) / 2 for root in roots)
    integrals, weights = [[] for _ in nodes], []
    for node in nodes:
        polynomial = [mp.mpf(1)]
        for other in nodes:
            if other != node:
                scale = 1 / (node - other)
                shifted = [mp.mpf(0), *polynomial]
                low = [-other * c for c in polynomial] + [mp.mpf(0)]
                polynomial = [(a + b) * scale for a, b in zip(shifted, low, strict=True)]
        antiderivative = [mp.mpf(0)] + [c / (k + 1) for k, c in enumerate(polynomial)]
        for i, end in enumerate(nodes):
            integrals[i].append(mp.polyval(antiderivative[::-1], end))
        weights.append(mp.polyval(antiderivative[::-1], 1))
    return nodes, integrals, weights


def torque(row, kind, t, piece):
    """The torque at t; samples by the polynomial of this piece."""
    value = row["constant"] + row["amplitude"] * mp.cos(row["frequency"] * t + row["phase"])
    if not kind:
        return value
    times, values = damped_inputs.SAMPLE_TIMES, damped_inputs.SAMPLE_VALUES
    x = (t - exact.real(times[piece])) / exact.real(times[piece + 1] - times[piece])
    y0, y1 = exact.real(values[piece]), exact.real(values[piece + 1])
    if kind == "steps":
        return value + y0
    if kind == "lines":
        return value + (1 - x) * y0 + x * y1
    # The samples are equidistant: Catmull and Rom's slopes.
    before, after = exact.real(values[piece - 1]), exact.real(values[piece + 2])
    d0, d1 = (y1 - before) / 2, (after - y0) / 2
    return (
        value + (1 + 2 * x) * (1 - x) ** 2 * y0 + x * (1 - x) ** 2 * d0 + x**2 * (3 - 2 * x) * y1 + x**2 * (x - 1) * d1
    )


class Collocated:
    """One motion from the inputs of a row, as mpf."""

    def __init__(self, row, kind):
        self.row, self.kind = row, kind
        self.t, self.theta, self.v = mp.mpf(0), row["theta0"], row["velocity0"]
        self.side = mp.sign(self.v)
        self.turned, self.slip = self.theta, mp.mpf(0 if self.v else 1)
        self.held = False
        if not self.v:
            self.start_from_rest()

    def pull(self):
        return torque(self.row, self.kind, self.t, self.piece()) - self.row["omega2"] * mp.sin(self.theta)

    def piece(self):
        return max(i for i, t in enumerate(damped_inputs.SAMPLE_TIMES) if t <= self.t) if self.kind else 0

    def start_from_rest(self):
        pull = self.pull()
        self.held = bool(self.row["dry"]) and not self.row["presliding"] and abs(pull) <= self.row["dry"]
        self.side = mp.sign(pull)

    def acceleration(self, t, theta, v, piece):
        row, side = self.row, self.side
        z = side
        if row["presliding"]:
            z = side * (1 - self.slip * mp.exp(-side * (theta - self.turned) / row["presliding"]))
        friction = 2 * row["linear"] * v + side * row["quadratic"] * v * v + row["dry"] * z
        return torque(row, self.kind, t, piece) - friction - row["omega2"] * mp.sin(theta)

    def after(self, h):
        """(theta, v) a step later: the stages by repeated substitution."""
        nodes, integrals, weights = collocation()
        piece = self.piece()
        a = [self.acceleration(self.t, self.theta, self.v, piece)] * STAGES
        for _ in range(200):
            v = [self.v + h * mp.fdot(integrals[i], a) for i in range(STAGES)]
            theta = [self.theta + h * mp.fdot(integrals[i], v) for i in range(STAGES)]
            new = [self.acceleration(self.t + h * nodes[i], theta[i], v[i], piece) for i in range(STAGES)]
            change = max(abs(x - y) for x, y in zip(a, new, strict=True))
            a = new
            if change < mp.mpf(10) ** (8 - DIGITS):
                break
        v = [self.v + h * mp.fdot(integrals[i], a) for i in range(STAGES)]
        return self.theta + h * mp.fdot(weights, v), self.v + h * mp.fdot(weights, a)

    def advance(self, stop):
        row = self.row
        h = min(stop - self.t, mp.mpf("0.25"))
        if self.kind:
            h = min(h, exact.real(damped_inputs.SAMPLE_TIMES[self.piece() + 1]) - self.t)
        if self.held:
            return self.hold(stop)
        # Fast motion and short presliding take shorter steps.
        size = max(abs(self.v), mp.sqrt(abs(row["omega2"])), 1)
        if row["presliding"] and self.slip:
            size = max(size, 2 * abs(self.v) / row["presliding"], 2 * mp.sqrt(1 / row["presliding"]))
        h = min(h, mp.mpf("0.4") / size)
        theta, v = self.after(h)
        if v * self.side < 0:
            low, high, x = mp.mpf(0), h, h * self.v / (self.v - v)
            for _ in range(60):
                theta, v = self.after(x)
                if abs(v) < mp.mpf(10) ** (12 - DIGITS):
                    break
                low, high = (x, high) if v * self.side > 0 else (low, x)
                x -= v / self.acceleration(self.t + x, theta, v, self.piece())
                if not low < x < high:
                    x = (low + high) / 2
            self.t, self.theta, self.v = self.t + x, theta, mp.mpf(0)
            left = (
                self.slip * mp.exp(-self.side * (theta - self.turned) / row["presliding"]) if row["presliding"] else 0
            )
            side = self.side
            self.start_from_rest()
            if not self.held:
                self.side, self.turned, self.slip = -side, theta, 2 - left
            return None
        last = self.t + h
        self.t, self.theta, self.v = (stop if abs(stop - last) < mp.mpf(10) ** (3 - DIGITS) else last), theta, v
        return None

    def hold(self, stop):
        """At rest: only where nothing changes, or until a root of the pull on a smooth torque."""
        if not self.row["amplitude"] and not self.kind:
            self.t = stop
            return
        begun, h = self.t, mp.mpf(1) / 64

        def excess(t):
            self.t = t
            return abs(self.pull()) - self.row["dry"]

        while begun < stop:
            end = min(stop, begun + h)
            if excess(end - mp.mpf(10) ** -20) > 0:
                self.t = end if self.kind else mp.findroot(excess, (begun, end), solver="anderson", tol=1e-60)
                self.held, self.v = False, mp.mpf(0)
                self.side = mp.sign(self.pull())
                return
            begun = end
        self.t = stop
        if excess(stop) > 0:
            self.start_from_rest()


def motion(row, kind, stop):
    now = Collocated(row, kind)
    while now.t < stop:
        now.advance(stop)
    return now.theta, now.v


def inputs_of(row):
    return {name: mp.mpf(float.fromhex(row[name])) for name in damped_inputs.INPUTS}


def wrong(row):
    """What the second route contradicts."""
    with mp.workdps(DIGITS):
        found = motion(inputs_of(row), row["samples"], mp.mpf(float.fromhex(row["t"])))
        scales = [mp.mpf(row["scale_theta"]), mp.mpf(row["scale_velocity"])]
        return differences(row, found, scales)


def differences(row, found, scales):
    bad = []
    for name, value, scale in zip(("theta", "velocity"), found, scales, strict=True):
        written = mp.mpf(float.fromhex(row[f"{name}_hi"])) + mp.mpf(float.fromhex(row[f"{name}_lo"]))
        if abs(value - written) > scale * mp.mpf(10) ** -31:
            bad.append(name)
    return bad


def slopes_wrong(row, names):
    """Derivatives by these inputs against one-sided differences of the second route."""
    bad = []
    with mp.workdps(DIGITS):
        kind, stop = row["samples"], mp.mpf(float.fromhex(row["t"]))
        inputs = inputs_of(row)
        base = motion(inputs, kind, stop)
        for name in names:
            h = mp.mpf(10) ** -16
            if name == "velocity0" and not inputs[name]:
                h *= Collocated(inputs, kind).side
            near = motion({**inputs, name: inputs[name] + h}, kind, stop)
            far = motion({**inputs, name: inputs[name] + 2 * h}, kind, stop)
            for value, b, n, f in zip(("theta", "velocity"), base, near, far, strict=True):
                text = row[f"d{value}_d{name}"]
                slope = (4 * n - f - 3 * b) / (2 * h)
                if text == "nan" or abs(mp.mpf(text) - slope) > mp.mpf(10) ** -12 * (1 + abs(slope)):
                    bad.append(f"d{value}_d{name}")
    return bad


def smooth(row):
    """Rows that are quick: early, earlier with presliding; and whose samples do not also release a pendulum that is held."""
    longest = 1 if float.fromhex(row["presliding"]) else LONGEST
    return not (row["samples"] and float.fromhex(row["dry"])) and float.fromhex(row["t"]) <= longest


def check(name, every, rng):
    rows = exact.read(exact.VECTORS / name)
    header = damped.HEADER if name == "damped.csv" else damped.SLOPES_HEADER
    if list(rows[0]) != header:
        fail(name, "columns differ from the generator's")
    if counted(name, rows) not in (exact.ROOM / "README.md").read_text():
        fail("README.md lacks the line", counted(name, rows))
    all_cases = list(damped_inputs.cases())
    lengths = [(number, i) for number, case in enumerate(all_cases) for i in range(len(case[3]))]
    if name == "damped.csv" and [row["id"] for row in rows] != [f"damped-{a:03d}-{b}" for a, b in lengths]:
        fail(name, "rows are not the cases of the generator")
    near = [row for row in rows if smooth(row)]
    sample = near if every else rng.sample(near, min(len(near), SAMPLE if name == "damped.csv" else 3))
    for row in sample:
        number, i = map(int, row["id"].split("-")[1:])
        _, inputs, kind, times, _ = all_cases[number]
        given = [*damped.texts(inputs), kind, float(times[i]).hex()]
        if [row[column] for column in [*damped_inputs.INPUTS, "samples", "t"]] != given:
            fail(name, "is not what its generator draws:", row)
        if name == "damped.csv":
            if found := wrong(row):
                fail(name, "collocation contradicts", found, row)
            continue
        known = [
            by
            for by in damped_inputs.INPUTS
            if row[f"dtheta_d{by}"] != "nan" and (by != "velocity0" or row[f"dtheta_d{by}"] != "0")
        ]
        if found := slopes_wrong(row, known if every else rng.sample(known, 2)):
            fail(name, "collocation contradicts", found, row)
    moving = next(row for row in sample if row["stratum"] not in ("stops", "released"))
    if name == "damped.csv":
        with mp.workdps(DIGITS):
            found = motion(inputs_of(moving), moving["samples"], mp.mpf(float.fromhex(moving["t"])))
            scales = [abs(value) for value in found]
            for column, row in mutated({key: moving[key] for key in moving if not key.startswith("cond")}):
                if not differences(row, found, [min(s, mp.mpf(1)) for s in scales]):
                    fail(name, "a mutated", column, "passes")
    return f"{len(rows)} rows, {len(sample)} computed by collocation"
