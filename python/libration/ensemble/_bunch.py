"""Bunches: states of many particles of a known distribution, by particle, so that a part of a bunch is that part of the whole.

Each particle takes two uniform numbers of its own counter and an inverse cumulative function; nothing is ever drawn again. Matched
bunches are functions of the action, with phases spread evenly, by `libration.from_action_phase`. Bunches that are not have the
ellipses of small swings, and smear. Sources stand with the distributions (_density.py, _canonical.py, _uniform.py).
"""

import math

import numpy as np

from .._arrays import Floats
from .._messages import explained
from .._scalars import count, real, shown
from ..pendulum import action as action_of_state
from ..pendulum import from_action_phase
from ._canonical import special, thermal
from ._density import EDGE, SHAPES, largest_rms, ratio_of, scale_of
from ._uniform import uniforms

# What says how wide a bunch is, by its distribution.
WIDTHS = {
    "gaussian": ("sigma_theta", "action"),
    "waterbag": ("sigma_theta", "action", "energy_ratio"),
    "parabolic": ("sigma_theta", "action", "energy_ratio"),
    "thermal": ("temperature",),
    "microcanonical": ("action", "energy_ratio"),
}
# Scale over omega0 of a bunch of small swings whose rms angle is 1.
SMALL = {"gaussian": 1.0, "waterbag": 2.0, "parabolic": 3.0}
# Particles at a time: their columns stay in the cache.
BLOCK = 2**13


@explained
def bunch(
    n: int,
    *,
    distribution: str,
    seed: int,
    sigma_theta: float | None = None,
    action: float | None = None,
    temperature: float | None = None,
    energy_ratio: float | None = None,
    omega0: float = 1.0,
    matched: bool = True,
    rotations: bool = False,
    quiet: bool = False,
    first: int = 0,
) -> tuple[Floats, Floats]:
    """States of `n` particles of a distribution: ``(theta, velocity)``.

    A matched bunch is a function of the action, so it stays as it is. All of its particles are in libration unless
    `rotations` or `energy_ratio` say otherwise. By `distribution`, the density over phase space, and what gives its width:

    - ``"gaussian"``: exp(-J/J0) up to the separatrix; `sigma_theta`, its rms angle, or `action`, J0.
    - ``"waterbag"``: constant up to J1; `sigma_theta`, or the edge as `action`, J1, or as `energy_ratio`.
    - ``"parabolic"``: 1 - J/J1; the same.
    - ``"thermal"``: exp(-H/T), H = velocity**2/2 + omega0**2 (1 - cos theta), up to the separatrix, or everywhere
      with ``rotations=True``, which is the canonical ensemble; `temperature`, T.
    - ``"microcanonical"``: all on one orbit; `action`, or `energy_ratio`, which may be above 1: rotations, both ways.

    Parameters
    ----------
    n : int
        How many particles, not negative.
    distribution : str
        Its name.
    seed : int
        From 0 to 2**64 - 1. Another seed is another bunch.
    sigma_theta : scalar, optional
        Rms angle in rad, positive; of a matched bunch below sqrt(pi**2 - 8) = 1.367, where the bucket is full, and to 1.037
        for a parabolic one.
    action : scalar, optional
        In rad**2/s, positive; an edge or an orbit up to the separatrix's, 8 omega0/pi.
    temperature : scalar, optional
        In rad**2/s**2, positive: that of theta alone, kT over the moment of inertia.
    energy_ratio : scalar, optional
        Over that at the top; an edge in (0, 1], an orbit positive and not 1.
    omega0 : scalar, default 1.0
        Angular frequency of small swings in rad/s, positive.
    matched : bool, default True
        False for the distribution of small swings, whose density depends on theta**2 + (velocity/omega0)**2: it smears.
    rotations : bool, default False
        Whether a thermal bunch has rotations too.
    quiet : bool, default False
        A quiet start: actions and phases spread evenly, by a recurrence, in place of random.
    first : int, default 0
        The number of the first particle, not negative: particles `first` to ``first + n - 1`` of the bunch.

    Returns
    -------
    pair of ndarray
        Angles in rad, within [-pi, pi] if matched, and angular velocities in rad/s, of shape ``(n,)``.

    Raises
    ------
    ValueError
        In one line: the argument, its value and what is allowed.
    ImportError
        For a thermal bunch without SciPy.

    Notes
    -----
    A particle depends on the arguments and its number, not on `n` and `first`: chunks joined are the whole, bit for bit. Philox
    4x64 has one counter for each particle. Source: Salmon et al., SC11 (2011); Lee, Accelerator Physics (2019), section 3.V.

    Examples
    --------
    >>> from libration import ensemble
    >>> theta, velocity = ensemble.bunch(100_000, distribution="gaussian", sigma_theta=0.8, seed=1)
    >>> print(f"{theta.std():.2f} {velocity.std():.2f}")
    0.80 0.67
    >>> part, _ = ensemble.bunch(3, distribution="gaussian", sigma_theta=0.8, seed=1, first=500)
    >>> bool((part == theta[500:503]).all())
    True
    """
    total, start, key = count("n", n), count("first", first), _seed(seed)
    for name, value in (("n", total), ("first", start)):
        if value < 0:
            raise ValueError(f"{name} = {value}: must not be negative")
    flags = {"matched": matched, "rotations": rotations, "quiet": quiet}
    for name, flag in flags.items():
        if not isinstance(flag, bool | np.bool):
            raise ValueError(f"{name} = {shown(flag)}: must be True or False")
    if not isinstance(distribution, str) or distribution not in WIDTHS:
        raise ValueError(f"distribution = {shown(distribution)}: must be one of {', '.join(WIDTHS)}")
    frequency = positive("omega0", omega0)
    widths = {
        "sigma_theta": sigma_theta,
        "action": action,
        "temperature": temperature,
        "energy_ratio": energy_ratio,
    }
    name, width = _width(distribution, widths)
    if rotations and distribution != "thermal":
        raise ValueError(f"rotations = True: must be False for {distribution}; thermal takes it")
    if not matched and distribution not in SHAPES:
        raise ValueError(f"matched = False: must be True for {distribution}, a function of the energy")
    if distribution == "thermal":
        scale = _known_temperature(width, frequency)
        special()
    else:
        scale = _scale(distribution, name, width, frequency, bool(matched))
        if not 0.0 < scale < math.inf:
            raise ValueError(f"{name} = {width!r}: must give an action within the doubles, not {scale!r}")
    try:
        theta, velocity = np.empty(total), np.empty(total)
    except (MemoryError, ValueError):
        raise ValueError(f"n = {total}: must fit into memory, 16 bytes a particle") from None
    for begin in range(0, total, BLOCK):
        block = slice(begin, min(begin + BLOCK, total))
        u = uniforms(key, start + begin, block.stop - begin, bool(quiet))
        if distribution == "thermal":
            theta[block], velocity[block] = thermal(scale, frequency, bool(rotations), u)
        elif distribution == "microcanonical":
            theta[block], velocity[block] = _on_an_orbit(scale, name == "energy_ratio" and width > 1.0, frequency, u)
        elif matched:
            actions = scale * ratio_of(distribution, u[0], EDGE * frequency / scale)
            phases = math.tau * (u[1] - 0.5)
            from_action_phase(actions, phases, frequency, out=(theta[block], velocity[block]))
        else:
            radius = np.sqrt(2.0 * (scale / frequency) * ratio_of(distribution, u[0], math.inf))
            phases = math.tau * (u[1] - 0.5)
            theta[block], velocity[block] = radius * np.sin(phases), frequency * radius * np.cos(phases)
    return theta, velocity


def positive(name: str, value: object) -> float:
    """One finite number above 0."""
    number = real(name, value)
    if not 0.0 < number < math.inf:
        raise ValueError(f"{name} = {number!r}: must be positive and finite")
    return number


def _seed(seed: object) -> int:
    whole = seed if isinstance(seed, int) and not isinstance(seed, bool) else count("seed", seed)
    if not 0 <= whole < 2**64:
        raise ValueError(f"seed = {shown(whole)}: must be from 0 to 2**64 - 1")
    return whole


def _width(distribution: str, widths: dict[str, float | None]) -> tuple[str, float]:
    """The one width that is given."""
    given = [name for name, value in widths.items() if value is not None]
    taken = WIDTHS[distribution]
    wanted = f"{distribution} takes {'one of ' if len(taken) > 1 else ''}{', '.join(f'{each}=' for each in taken)}"
    for name in given:
        if name not in taken:
            raise ValueError(f"{name} = {shown(widths[name])}: {wanted}")
    if len(given) != 1:
        raise ValueError(f"{' and '.join(given) or 'no width'} given: {wanted}")
    return given[0], positive(given[0], widths[given[0]])


def _scale(distribution: str, name: str, width: float, omega0: float, matched: bool) -> float:
    """The action that a distribution is measured in."""
    if not matched:
        if name == "energy_ratio":
            raise ValueError(
                f"energy_ratio = {width!r}: a bunch that is not matched takes one of sigma_theta=, action="
            )
        return width if name == "action" else SMALL[distribution] * (width * width) * omega0
    if name == "sigma_theta":
        last = largest_rms(distribution)
        if not (width < last if distribution == "gaussian" else width <= last):
            bound = "below" if distribution == "gaussian" else "to"
            raise ValueError(
                f"sigma_theta = {width!r}: must be positive and {bound} {last:.6f}, a full bucket, if matched"
            )
        return scale_of(distribution, width) * omega0
    if name == "action":
        if distribution != "gaussian" and width > EDGE * omega0:
            raise ValueError(f"action = {width!r}: must be positive, to that of the separatrix, 8 omega0/pi")
        return width
    if distribution != "microcanonical" and width > 1.0:
        raise ValueError(f"energy_ratio = {width!r}: must be in (0, 1]")
    if distribution == "microcanonical" and width == 1.0:
        raise ValueError("energy_ratio = 1.0: must not be 1; the separatrix has no phase")
    return float(action_of_state(0.0, 2.0 * omega0 * math.sqrt(width), omega0))


def _known_temperature(temperature: float, omega0: float) -> float:
    if not 1e-150 < omega0 / math.sqrt(temperature) < 1e150:
        raise ValueError(f"temperature = {temperature!r}: must be within 1e300 of omega0**2")
    return temperature


def _on_an_orbit(action: float, rotation: bool, omega0: float, u: Floats) -> tuple[Floats, Floats]:
    """States of one action, half of them each way where it is that of rotations."""
    direction = np.where(u[0] < 0.5, 1.0, -1.0) if rotation else 0.0
    theta, velocity = from_action_phase(action, math.tau * (u[1] - 0.5), omega0, direction=direction)
    return theta, velocity
