"""The exact Fourier series of a motion in its phase, and how far from harmonic it is."""

# A number fits where an array does: of several signatures the first that fits is meant.
# mypy: disable-error-code="overload-overlap"

from __future__ import annotations

from typing import Any, NamedTuple, overload

import numpy as np

from .. import _core
from .._arrays import Floats, Labelled, Mask, Real, Scalar
from .._dispatch import apply
from .._messages import explained
from ._results import DISTORTION


class Fourier(NamedTuple):
    """Amplitudes of the harmonics j = 1, 2, ...: of sin(j phase) in theta, of cos(j phase) in the velocity.

    Examples
    --------
    >>> import libration
    >>> libration.Pendulum(1.0).fourier(3)._fields
    ('theta', 'velocity')
    """

    theta: Floats
    velocity: Floats


@overload
def harmonic_distortion(theta_max: Scalar, *, out: None = None, where: bool = True) -> np.float64: ...
@overload
def harmonic_distortion(theta_max: Real, *, out: Floats | None = None, where: Mask = True) -> Floats: ...
@overload
def harmonic_distortion(theta_max: Real | Labelled, *, out: Labelled | None = None, where: Mask = True) -> Labelled: ...
@explained
def harmonic_distortion(theta_max: Any, *, out: Any = None, where: Any = True) -> Any:
    """Loss of harmonicity of a swing: the norm of the higher harmonics of its angle, over the first.

    What `Pendulum.distortion` is for a swing as wide as `theta_max`: theta_max**2/192 when small, sqrt(pi**2/8 - 1) = 0.48 in
    the limit of pi, approached only with the logarithm of the distance.

    Parameters
    ----------
    theta_max : scalar or array
        Turning angle in rad, from 0 to pi; else NaN.
    out : ndarray, optional
        Where to put the result.
    where : array of bool, optional
        Where to compute. Other elements keep what `out` holds; without `out` they are NaN.

    Returns
    -------
    float64 or array of the shape of `theta_max`

    Notes
    -----
    Error promised: 4 ulp, plus 2**-100 of its condition. Source: DLMF 22.11.1, integrated; Lima 2019 describes the loss.

    Examples
    --------
    >>> import numpy as np
    >>> import libration
    >>> libration.harmonic_distortion(np.radians([30.0, 90.0, 170.0])).round(6)
    array([0.001451, 0.015031, 0.116256])
    """
    return apply(_core.harmonic_distortion, theta_max, results=(DISTORTION,), out=out, where=where)
