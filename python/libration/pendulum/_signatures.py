"""How the functions of arrays of states look to type checkers, and what is said in all of them of the states.

A state is an angle and a velocity, or an angle and an energy; the angle may count from the top; the frequency is given as
for `Pendulum`. The text stands in each docstring in the place of its mark.
"""

# A number fits where an array does: of several signatures the first that fits is meant.
# mypy: disable-error-code="overload-overlap"

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, Generic, Protocol, TypedDict, TypeVar, overload

import numpy as np

from .._arrays import Floats, Indexed, Labelled, Mask, NDArray, Real, Scalar, Stacked
from .._messages import explained

if TYPE_CHECKING:
    from typing import Unpack

Value = TypeVar("Value")

_FREQUENCY = """omega0, omega2, length : scalar or array, at most one of them
        Angular frequency of small swings in rad/s, finite and >= 0 (1.0 if none is given); its square in 1/s**2, of any sign;
        or the length in m, finite and > 0.
    gravity : scalar or array, optional
        In m/s**2, finite; only with `length`, where it means 9.80665 if not given."""
_ENERGY = """energy_ratio, energy_ratio_c, energy : scalar or array, at most one of them, instead of a velocity
        kappa**2, its complement 1 - kappa**2, or the energy per unit inertia in rad**2/s**2, as for `Pendulum.from_energy`. The
        angle is then the bottom if none is given.
    direction : scalar or array, default 1.0
        1 upwards or -1 downwards, beside an energy."""
TEXTS = {
    "<frequency>": _FREQUENCY,
    "<state>": f"""theta : scalar or array
        Angle in rad, finite.
    velocity : scalar or array, default 0.0
        Angular velocity in rad/s, finite.
    theta_from_top : scalar or array, optional
        Angle less pi in rad, instead of `theta`: it keeps its digits next to the top.
    {_ENERGY}
    {_FREQUENCY}""",
    "<start>": f"""theta0 : scalar or array
        Initial angle in rad, finite.
    velocity0 : scalar or array, default 0.0
        Initial angular velocity in rad/s, finite.
    theta0_from_top : scalar or array, optional
        Initial angle less pi in rad, instead of `theta0`: it keeps its digits next to the top.
    {_ENERGY}
    {_FREQUENCY}""",
}


class OtherFrequency(TypedDict, Generic[Value], total=False):
    """The frequency otherwise than by omega0."""

    omega2: Value | None
    length: Value | None
    gravity: Value | None


class OtherEnergy(OtherFrequency[Value], Generic[Value], total=False):
    """An energy in the place of a velocity."""

    energy_ratio: Value | None
    energy_ratio_c: Value | None
    energy: Value | None
    direction: Value


class OtherState(OtherEnergy[Value], Generic[Value], total=False):
    """A state otherwise than by angle and velocity."""

    theta_from_top: Value | None


class OtherStart(OtherEnergy[Value], Generic[Value], total=False):
    """An initial state otherwise than by angle and velocity."""

    theta0_from_top: Value | None


class AfterStart(OtherStart[Value], Generic[Value], total=False):
    """The same from a time on."""

    after: Value


if TYPE_CHECKING:

    class OfState(Protocol):
        """A number of each state."""

        @overload
        def __call__(
            self,
            theta: Scalar | None = None,
            velocity: Scalar | None = None,
            omega0: Scalar | None = None,
            *,
            out: None = None,
            where: bool = True,
            **other: Unpack[OtherState[Scalar]],
        ) -> np.float64: ...
        @overload
        def __call__(
            self,
            theta: Real | None = None,
            velocity: Real | None = None,
            omega0: Real | None = None,
            *,
            out: Floats | None = None,
            where: Mask = True,
            **other: Unpack[OtherState[Real]],
        ) -> Floats: ...
        @overload
        def __call__(
            self,
            theta: Real | Labelled | None = None,
            velocity: Real | Labelled | None = None,
            omega0: Real | Labelled | None = None,
            *,
            out: Labelled | None = None,
            where: Mask = True,
            **other: Unpack[OtherState[Real | Labelled]],
        ) -> Labelled: ...

    class RegimeOfState(Protocol):
        """A word for each state."""

        @overload
        def __call__(
            self,
            theta: Scalar | None = None,
            velocity: Scalar | None = None,
            omega0: Scalar | None = None,
            **other: Unpack[OtherState[Scalar]],
        ) -> np.str_: ...
        @overload
        def __call__(
            self,
            theta: Real | None = None,
            velocity: Real | None = None,
            omega0: Real | None = None,
            **other: Unpack[OtherState[Real]],
        ) -> NDArray[np.str_]: ...
        @overload
        def __call__(
            self,
            theta: Real | Labelled | None = None,
            velocity: Real | Labelled | None = None,
            omega0: Real | Labelled | None = None,
            **other: Unpack[OtherState[Real | Labelled]],
        ) -> Labelled: ...

    class OfTime(Protocol):
        """A number of each time and initial state."""

        @overload
        def __call__(
            self,
            t: Scalar,
            theta0: Scalar | None = None,
            velocity0: Scalar | None = None,
            omega0: Scalar | None = None,
            *,
            out: None = None,
            where: bool = True,
            **other: Unpack[OtherStart[Scalar]],
        ) -> np.float64: ...
        @overload
        def __call__(
            self,
            t: Real,
            theta0: Real | None = None,
            velocity0: Real | None = None,
            omega0: Real | None = None,
            *,
            out: Floats | None = None,
            where: Mask = True,
            **other: Unpack[OtherStart[Real]],
        ) -> Floats: ...
        @overload
        def __call__(
            self,
            t: Real | Labelled,
            theta0: Real | Labelled | None = None,
            velocity0: Real | Labelled | None = None,
            omega0: Real | Labelled | None = None,
            *,
            out: Labelled | None = None,
            where: Mask = True,
            **other: Unpack[OtherStart[Real | Labelled]],
        ) -> Labelled: ...

    class OfAngle(Protocol):
        """A number of each angle and initial state, from a time on."""

        @overload
        def __call__(
            self,
            theta: Scalar,
            theta0: Scalar | None = None,
            velocity0: Scalar | None = None,
            omega0: Scalar | None = None,
            *,
            out: None = None,
            where: bool = True,
            **other: Unpack[AfterStart[Scalar]],
        ) -> np.float64: ...
        @overload
        def __call__(
            self,
            theta: Real,
            theta0: Real | None = None,
            velocity0: Real | None = None,
            omega0: Real | None = None,
            *,
            out: Floats | None = None,
            where: Mask = True,
            **other: Unpack[AfterStart[Real]],
        ) -> Floats: ...
        @overload
        def __call__(
            self,
            theta: Real | Labelled,
            theta0: Real | Labelled | None = None,
            velocity0: Real | Labelled | None = None,
            omega0: Real | Labelled | None = None,
            *,
            out: Labelled | None = None,
            where: Mask = True,
            **other: Unpack[AfterStart[Real | Labelled]],
        ) -> Labelled: ...

    class MotionOfTime(Protocol):
        """Angle and velocity of each time and initial state."""

        @overload
        def __call__(
            self,
            t: Scalar,
            theta0: Scalar | None = None,
            velocity0: Scalar | None = None,
            omega0: Scalar | None = None,
            *,
            out: None = None,
            where: bool = True,
            **other: Unpack[OtherStart[Scalar]],
        ) -> tuple[np.float64, np.float64]: ...
        @overload
        def __call__(
            self,
            t: Real,
            theta0: Real | None = None,
            velocity0: Real | None = None,
            omega0: Real | None = None,
            *,
            out: tuple[Floats, Floats] | None = None,
            where: Mask = True,
            **other: Unpack[OtherStart[Real]],
        ) -> tuple[Floats, Floats]: ...
        @overload
        def __call__(
            self,
            t: Real | Labelled,
            theta0: Real | Labelled | None = None,
            velocity0: Real | Labelled | None = None,
            omega0: Real | Labelled | None = None,
            *,
            out: tuple[Labelled, Labelled] | None = None,
            where: Mask = True,
            **other: Unpack[OtherStart[Real | Labelled]],
        ) -> tuple[Labelled, Labelled]: ...

    class TurnsOfTime(Protocol):
        """Whole turns and the rest of each time and initial state."""

        @overload
        def __call__(
            self,
            t: Scalar,
            theta0: Scalar | None = None,
            velocity0: Scalar | None = None,
            omega0: Scalar | None = None,
            **other: Unpack[OtherStart[Scalar]],
        ) -> tuple[np.int64, np.float64]: ...
        @overload
        def __call__(
            self,
            t: Real,
            theta0: Real | None = None,
            velocity0: Real | None = None,
            omega0: Real | None = None,
            **other: Unpack[OtherStart[Real]],
        ) -> tuple[NDArray[np.int64], Floats]: ...
        @overload
        def __call__(
            self,
            t: Real | Labelled,
            theta0: Real | Labelled | None = None,
            velocity0: Real | Labelled | None = None,
            omega0: Real | Labelled | None = None,
            **other: Unpack[OtherStart[Real | Labelled]],
        ) -> tuple[Labelled, Labelled]: ...

    class MatricesOfTime(Protocol):
        """A matrix of each time and initial state."""

        @overload
        def __call__(
            self,
            t: Real,
            theta0: Real | None = None,
            velocity0: Real | None = None,
            omega0: Real | None = None,
            **other: Unpack[OtherStart[Real]],
        ) -> Floats: ...
        @overload
        def __call__(
            self,
            t: Real | Stacked,
            theta0: Real | Stacked | None = None,
            velocity0: Real | Stacked | None = None,
            omega0: Real | Stacked | None = None,
            **other: Unpack[OtherStart[Real | Stacked]],
        ) -> Stacked: ...
        @overload
        def __call__(
            self,
            t: Real | Indexed,
            theta0: Real | Indexed | None = None,
            velocity0: Real | Indexed | None = None,
            omega0: Real | Indexed | None = None,
            **other: Unpack[OtherStart[Real | Indexed]],
        ) -> Floats: ...


def told(function: Callable[..., Any]) -> Any:
    """A function whose docstring has the texts in the places of their marks, and whose refusals are explained."""
    text = function.__doc__ or ""
    for mark, words in TEXTS.items():
        text = text.replace(mark, words)
    function.__doc__ = text
    return explained(function)


def of_state(function: Callable[..., Any]) -> OfState:
    """Declare a function of a state."""
    return told(function)  # type: ignore[no-any-return]


def of_time(function: Callable[..., Any]) -> OfTime:
    """Declare a function of a time and an initial state."""
    return told(function)  # type: ignore[no-any-return]


def of_angle(function: Callable[..., Any]) -> OfAngle:
    """Declare a function of an angle, an initial state and a time from which on is looked."""
    return told(function)  # type: ignore[no-any-return]
