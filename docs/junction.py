"""A Josephson junction as a driven pendulum: its current-voltage curve with Shapiro's steps, and how wide they are.

theta'' + alpha theta' + sin theta = i + a cos(W t): the phase difference theta, in units of the critical current and of the plasma
frequency; alpha = 1/sqrt(beta_c). The voltage is the mean of theta', and its steps stand at n W. Pictures: docs/pictures.py.
Source: Stewart, Appl. Phys. Lett. 12 (1968) 277; McCumber, J. Appl. Phys. 39 (1968) 3113; Shapiro, Phys. Rev. Lett. 11 (1963) 80.
"""

import math

import numpy as np

from libration import DampedPendulum, Friction, Torque

# Of locked(): periods of the drive between two looks, and the largest number of looks.
PERIODS, LOOKS = 20, 60


def junction(current, start=(0.0, 0.0), *, alpha, drive, frequency):
    """The junction under a current, from an angle and a velocity."""
    torque = Torque(constant=current, amplitude=drive, frequency=frequency)
    return DampedPendulum(*start, friction=Friction(linear=alpha / 2), torque=torque)


def voltages(currents, *, alpha, drive, frequency, settle=15, average=60):
    """The mean of theta' over the drive's frequency at each current, each from where the one before it has come to."""
    period, state, found = math.tau / frequency, (0.0, 0.0), []
    for current in currents:
        pendulum = junction(current, state, alpha=alpha, drive=drive, frequency=frequency)
        theta, velocity = pendulum.motion([settle * period, (settle + average) * period])
        found.append((theta[1] - theta[0]) / (math.tau * average))
        state = math.remainder(theta[1], math.tau), velocity[1]
    return np.array(found)


def swing(*, alpha, drive, frequency):
    """How far the drive swings the angle to both sides where the junction hardly pulls: the argument of the Bessel functions."""
    return drive / (frequency * math.hypot(frequency, alpha))


def drive_of(swing, *, alpha, frequency):
    """The drive of a swing."""
    return swing * frequency * math.hypot(frequency, alpha)


def locked(current, n, *, alpha, drive, frequency):
    """Whether theta turns n times in each period of the drive, once it has settled."""
    period = math.tau / frequency
    pendulum = junction(current, (0.0, n * frequency), alpha=alpha, drive=drive, frequency=frequency)
    before = None
    for look in range(1, LOOKS + 1):
        cycles = look * PERIODS
        # Where the angle is at this phase of the drive, n turns a period apart.
        place = pendulum.theta(cycles * period) - math.tau * n * cycles
        if before is not None and abs(place - before) < 1e-4:
            return True
        if look == 2:
            first = place
        if look > 2 and abs(place - first) > math.tau:
            return False
        before = place
    return False


def step_width(n, *, alpha, drive, frequency, expected, halvings=9):
    """The range of currents of step n, by halving on both sides of its middle, alpha n W; 0 where that is not on the step."""
    middle, given = alpha * n * frequency, {"alpha": alpha, "drive": drive, "frequency": frequency}
    if not locked(middle, n, **given):
        return 0.0
    edges = []
    for side in (1, -1) if n else (1,):
        low, high = 0.0, expected / 2 + 0.25
        for _ in range(halvings):
            try_at = (low + high) / 2
            if locked(middle + side * try_at, n, **given):
                low = try_at
            else:
                high = try_at
        edges.append((low + high) / 2)
    return sum(edges) if n else 2 * edges[0]


def draw_curve(axes, quiet, colors):
    """The current-voltage curve with a drive and without one, and the places of the steps."""
    given = {"alpha": 2.5, "frequency": 0.4}
    currents = np.linspace(0.0, 4.2, 421)
    still = voltages(currents, drive=0.0, **given)
    driven = voltages(currents, drive=2.2, **given)
    for n in range(5):
        axes.axhline(n, color=colors["steps"], lw=0.9, ls=colors["dashes"], zorder=1.5)
        place = {"xytext": (4, 0), "textcoords": "offset points", "va": "center", "annotation_clip": False}
        axes.annotate(f"n = {n}", (4.2, n), color=colors["steps"], fontsize=9, **place)
    axes.plot(currents, still, color=colors["still"], lw=1.3, label="constant current alone")
    axes.plot(currents, driven, color=colors["driven"], lw=1.8, label="with the drive 2.2 cos(0.4 t)")
    axes.plot([], [], color=colors["steps"], lw=0.9, ls=colors["dashes"], label="n times the drive's frequency")
    axes.set(xlim=(0, 4.2), ylim=(-0.15, 4.6))
    axes.set_xlabel("constant current over the critical one, i")
    axes.set_ylabel("voltage, mean of θ̇ over the drive's frequency")
    axes.set_title("I–V curve, α = 2.5", loc="left", fontsize=11)
    quiet(axes)
    axes.legend(loc="lower right", fontsize=9, framealpha=0.9)


def draw_widths(axes, quiet, colors, bessel):
    """The widths of the first steps over the drive, beside Bessel's functions."""
    given = {"alpha": 3.0, "frequency": 3.0}
    fine, coarse = np.linspace(0.0, 5.2, 400), np.arange(0.5, 5.2, 0.5)
    for n, (color, mark) in enumerate(zip(colors["orders"], "os^", strict=True)):
        expected = 2 * np.abs(bessel(n, coarse))
        drives = drive_of(coarse, **given)
        widths = [step_width(n, drive=a, expected=w, **given) for a, w in zip(drives, expected, strict=True)]
        axes.plot(fine, 2 * np.abs(bessel(n, fine)), color=color, lw=1.2)
        axes.plot(coarse, widths, mark, ms=5, color=color, label=f"n = {n}")
    axes.plot([], [], color="#555555", lw=1.2, label="2 |Jₙ(b)|")
    axes.set(xlim=(0, 5.2), ylim=(0, 2.05))
    axes.set_xlabel("swing of the drive, b = a / (Ω √(Ω² + α²))")
    axes.set_ylabel("width of the step in i")
    axes.set_title("Widths of the steps, α = Ω = 3", loc="left", fontsize=11)
    quiet(axes)
    axes.legend(loc="upper right", fontsize=9, framealpha=0.9)
