"""The signatures of the elliptic functions as type checkers see them: numbers give numbers, arrays arrays, labels stay.

Each is a protocol with a decorator that declares a function to have it. At run time there is only the function, whose
refusals are explained.
"""

# A number fits where an array does: of several signatures the first that fits is meant.
# mypy: disable-error-code="overload-overlap"

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, Generic, Protocol, TypedDict, TypeVar, overload

import numpy as np

from .._arrays import Complex, Floats, Labelled, Mask, NDArray, Real, Scalar
from .._messages import explained

if TYPE_CHECKING:
    from typing import Unpack

Value = TypeVar("Value")


class ByOne(TypedDict, Generic[Value], total=False):
    """Exactly one of the parameter, its complement, the modulus and the nome."""

    m: Value | None
    mc: Value | None
    k: Value | None
    q: Value | None


if TYPE_CHECKING:

    class OfParameter(Protocol):
        """A function of the parameter alone."""

        @overload
        def __call__(
            self,
            *,
            out: None = None,
            where: bool = True,
            **given: Unpack[ByOne[Scalar]],
        ) -> np.float64: ...
        @overload
        def __call__(
            self,
            *,
            out: Floats | None = None,
            where: Mask = True,
            **given: Unpack[ByOne[Real]],
        ) -> Floats: ...
        @overload
        def __call__(
            self,
            *,
            out: Labelled | None = None,
            where: Mask = True,
            **given: Unpack[ByOne[Real | Labelled]],
        ) -> Labelled: ...

    class OfU(Protocol):
        """A function of an argument u and the parameter."""

        @overload
        def __call__(
            self,
            u: Scalar,
            *,
            out: None = None,
            where: bool = True,
            **given: Unpack[ByOne[Scalar]],
        ) -> np.float64: ...
        @overload
        def __call__(
            self,
            u: Real,
            *,
            out: Floats | None = None,
            where: Mask = True,
            **given: Unpack[ByOne[Real]],
        ) -> Floats: ...
        @overload
        def __call__(
            self,
            u: Real | Labelled,
            *,
            out: Labelled | None = None,
            where: Mask = True,
            **given: Unpack[ByOne[Real | Labelled]],
        ) -> Labelled: ...

    class OfAnyU(Protocol):
        """A function of a real or complex argument u and the parameter."""

        @overload
        def __call__(
            self,
            u: Scalar,
            *,
            out: None = None,
            where: bool = True,
            **given: Unpack[ByOne[Scalar]],
        ) -> np.float64: ...
        @overload
        def __call__(
            self,
            u: Real,
            *,
            out: Floats | None = None,
            where: Mask = True,
            **given: Unpack[ByOne[Real]],
        ) -> Floats: ...
        @overload
        def __call__(
            self,
            u: complex | np.complexfloating[Any, Any],
            *,
            out: None = None,
            where: bool = True,
            **given: Unpack[ByOne[Scalar]],
        ) -> np.complex128: ...
        @overload
        def __call__(
            self,
            u: Complex,
            *,
            out: NDArray[np.complex128] | None = None,
            where: Mask = True,
            **given: Unpack[ByOne[Real]],
        ) -> NDArray[np.complex128]: ...
        @overload
        def __call__(
            self,
            u: Real | Labelled,
            *,
            out: Labelled | None = None,
            where: Mask = True,
            **given: Unpack[ByOne[Real | Labelled]],
        ) -> Labelled: ...

    class OfX(Protocol):
        """A function of a value x and the parameter."""

        @overload
        def __call__(
            self,
            x: Scalar,
            *,
            out: None = None,
            where: bool = True,
            **given: Unpack[ByOne[Scalar]],
        ) -> np.float64: ...
        @overload
        def __call__(
            self,
            x: Real,
            *,
            out: Floats | None = None,
            where: Mask = True,
            **given: Unpack[ByOne[Real]],
        ) -> Floats: ...
        @overload
        def __call__(
            self,
            x: Real | Labelled,
            *,
            out: Labelled | None = None,
            where: Mask = True,
            **given: Unpack[ByOne[Real | Labelled]],
        ) -> Labelled: ...

    class OfPhi(Protocol):
        """A function of an amplitude phi and the parameter."""

        @overload
        def __call__(
            self,
            phi: Scalar,
            *,
            out: None = None,
            where: bool = True,
            **given: Unpack[ByOne[Scalar]],
        ) -> np.float64: ...
        @overload
        def __call__(
            self,
            phi: Real,
            *,
            out: Floats | None = None,
            where: Mask = True,
            **given: Unpack[ByOne[Real]],
        ) -> Floats: ...
        @overload
        def __call__(
            self,
            phi: Real | Labelled,
            *,
            out: Labelled | None = None,
            where: Mask = True,
            **given: Unpack[ByOne[Real | Labelled]],
        ) -> Labelled: ...

    class OfN(Protocol):
        """A function of a characteristic n and the parameter."""

        @overload
        def __call__(
            self,
            n: Scalar,
            *,
            out: None = None,
            where: bool = True,
            **given: Unpack[ByOne[Scalar]],
        ) -> np.float64: ...
        @overload
        def __call__(
            self,
            n: Real,
            *,
            out: Floats | None = None,
            where: Mask = True,
            **given: Unpack[ByOne[Real]],
        ) -> Floats: ...
        @overload
        def __call__(
            self,
            n: Real | Labelled,
            *,
            out: Labelled | None = None,
            where: Mask = True,
            **given: Unpack[ByOne[Real | Labelled]],
        ) -> Labelled: ...

    class OfNAndPhi(Protocol):
        """A function of a characteristic n and an amplitude phi and the parameter."""

        @overload
        def __call__(
            self,
            n: Scalar,
            phi: Scalar,
            *,
            out: None = None,
            where: bool = True,
            **given: Unpack[ByOne[Scalar]],
        ) -> np.float64: ...
        @overload
        def __call__(
            self,
            n: Real,
            phi: Real,
            *,
            out: Floats | None = None,
            where: Mask = True,
            **given: Unpack[ByOne[Real]],
        ) -> Floats: ...
        @overload
        def __call__(
            self,
            n: Real | Labelled,
            phi: Real | Labelled,
            *,
            out: Labelled | None = None,
            where: Mask = True,
            **given: Unpack[ByOne[Real | Labelled]],
        ) -> Labelled: ...

    class OfZ(Protocol):
        """A theta function of z and the nome, or what makes it."""

        @overload
        def __call__(
            self,
            z: Scalar,
            *,
            out: None = None,
            where: bool = True,
            **given: Unpack[ByOne[Scalar]],
        ) -> np.float64: ...
        @overload
        def __call__(
            self,
            z: Real,
            *,
            out: Floats | None = None,
            where: Mask = True,
            **given: Unpack[ByOne[Real]],
        ) -> Floats: ...
        @overload
        def __call__(
            self,
            z: Real | Labelled,
            *,
            out: Labelled | None = None,
            where: Mask = True,
            **given: Unpack[ByOne[Real | Labelled]],
        ) -> Labelled: ...

    class OfNome(Protocol):
        """Two numbers of the nome alone."""

        @overload
        def __call__(self, q: Scalar, *, out: None = None, where: bool = True) -> tuple[np.float64, np.float64]: ...
        @overload
        def __call__(
            self, q: Real, *, out: tuple[Floats, Floats] | None = None, where: Mask = True
        ) -> tuple[Floats, Floats]: ...
        @overload
        def __call__(
            self, q: Labelled, *, out: tuple[Labelled, Labelled] | None = None, where: Mask = True
        ) -> tuple[Labelled, Labelled]: ...


def of_nome(function: Callable[..., Any]) -> OfNome:
    """Declare a function of the nome alone."""
    return explained(function)


def of_parameter(function: Callable[..., Any]) -> OfParameter:
    """Declare a function of the parameter alone."""
    return explained(function)


def of_u(function: Callable[..., Any]) -> OfU:
    """Declare a function of an argument u and the parameter."""
    return explained(function)


def of_any_u(function: Callable[..., Any]) -> OfAnyU:
    """Declare a function of a real or complex argument u and the parameter."""
    return explained(function)


def of_x(function: Callable[..., Any]) -> OfX:
    """Declare a function of a value x and the parameter."""
    return explained(function)


def of_phi(function: Callable[..., Any]) -> OfPhi:
    """Declare a function of an amplitude phi and the parameter."""
    return explained(function)


def of_n(function: Callable[..., Any]) -> OfN:
    """Declare a function of a characteristic n and the parameter."""
    return explained(function)


def of_n_and_phi(function: Callable[..., Any]) -> OfNAndPhi:
    """Declare a function of a characteristic n and an amplitude phi and the parameter."""
    return explained(function)


def of_z(function: Callable[..., Any]) -> OfZ:
    """Declare a theta function of z."""
    return explained(function)
