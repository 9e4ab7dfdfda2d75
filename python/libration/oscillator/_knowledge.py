"""What nonlinear springs know besides their motion: action, frequency, phase, Fourier series and derivatives.

Source: as for `Duffing` and `CubicQuintic`.
"""

from __future__ import annotations

from typing import Any, ClassVar, NamedTuple

import numpy as np

from .._arrays import Floats
from .._dispatch import apply, tensor, unindexed
from .._labels import Result
from .._messages import explained
from ._oscillator import Oscillator

PHASE = Result("phase", "rad", "phase")
SENSITIVITIES = Result("sensitivities", None, "derivatives of the state by start and coefficients")


class OscillatorFourier(NamedTuple):
    """The mean of u, the amplitudes of cos(j phase) in it, and those of sin(j phase) in the velocity, j = 1, 2, ...

    Examples
    --------
    >>> import libration
    >>> libration.Duffing(1.0, p=1.0, q=1.0).fourier(3)._fields
    ('mean', 'u', 'velocity')
    """

    mean: float
    u: Floats
    velocity: Floats


class OscillatorKnowledge(Oscillator):
    """A nonlinear spring with its action, frequency, phase, Fourier series and derivatives."""

    __slots__ = ()

    _phase: ClassVar[np.ufunc]
    _sensitivities: ClassVar[np.ufunc]

    @property
    def action(self) -> float:
        """Action per unit mass: the closed integral of the velocity over u, over 2 pi.

        0 at rest; of a separatrix there and back; nan for a motion that does not stay. Error promised: 4 ulp, plus 2**-100 of
        its condition. Source: Parseval's sum of the Fourier series; with a fifth power the trapezoidal rule.
        """
        return self._oscillator.action

    @property
    def frequency(self) -> float:
        """Mean angular frequency in rad/s, 2 pi over the period; 0 on a separatrix, nan for a motion that does not stay.

        Error promised: 4 ulp, plus 2**-100 of its condition. Source: 2 pi over `period`.
        """
        return self._oscillator.frequency

    @property
    def distortion(self) -> float:
        """Harmonic distortion: the norm of the harmonics of u from the second on, over the first.

        0 at rest, nan where the motion does not repeat. Error promised: 4 ulp, plus 2**-100 of its condition; with a fifth power
        4 ulp, plus 2**-96. Source: Parseval's sum of the Fourier series.
        """
        return self._oscillator.distortion

    @explained
    def phase(self, t: Any) -> Any:
        """Phase at the times `t`, which grows evenly: ``phase(0) + frequency * t``.

        Parameters
        ----------
        t : scalar or array
            Time in s, of any shape and sign.

        Returns
        -------
        float64 or array of the shape of `t`
            In rad: 0 at the highest displacement, in (-pi, pi] at t = 0; nan where the motion does not repeat.

        Notes
        -----
        Error promised: 4 ulp of the larger of the phase and pi. Source: DLMF 22.19(i).

        Examples
        --------
        >>> import libration
        >>> f"{libration.Duffing(0.0, 1.0, p=1.0, q=1.0).phase(0.0):.6f}"
        '-1.570796'
        """
        return apply(self._phase, t, *self._operands, results=(PHASE,))

    @explained
    def fourier(self, n: int) -> OscillatorFourier:
        """Mean, and first `n` amplitudes of displacement and velocity in the phase.

        u = mean + sum of u[j-1] cos(j phase), and the velocity is the sum of velocity[j-1] sin(j phase).

        Parameters
        ----------
        n : int
            How many, from 1 to 1000000; to 1000 for `CubicQuintic`.

        Returns
        -------
        OscillatorFourier
            ``mean``, ``u`` and ``velocity``; nan where the motion does not repeat.

        Raises
        ------
        ValueError
            For another `n`.

        Notes
        -----
        Error promised: 4 ulp of each amplitude, plus 2**-100 of its condition; for `CubicQuintic` 4 ulp, plus 2**-96 of the largest
        displacement. Source: residues of an elliptic function of order two, DLMF 22.11; with a fifth power the trapezoidal rule.

        Examples
        --------
        >>> import libration
        >>> libration.Duffing(1.0, p=1.0, q=1.0).fourier(3).u.round(6)
        array([0.981711, 0.      , 0.017961])
        """
        return OscillatorFourier(*self._oscillator.fourier(n))

    @explained
    def sensitivities(self, t: Any) -> Any:
        """Derivatives of displacement and velocity by the start and the coefficients, at the times `t`.

        ``[..., i, j]`` is the derivative of (u, velocity)[i] by (u0, velocity0, p, q, r, c)[j]; for `CubicQuintic` by
        (u0, velocity0, p, q, s)[j].

        Parameters
        ----------
        t : scalar or array
            Time in s, of any shape and sign; NaN beyond an escape and for times that are not finite.

        Returns
        -------
        array of shape ``t.shape + (2, 6)``, for `CubicQuintic` ``t.shape + (2, 5)``
            Dask and xarray arrays give their like; xarray's new dimensions are `of` and `by`.

        Notes
        -----
        Error promised, in each row: 1e-12 of the largest change, while a disturbance grows by less than 1e10 on the way; next to a
        separatrix fewer digits are left. Source: the variational equations by Taylor series.

        Examples
        --------
        >>> import libration
        >>> libration.Duffing(1.0, p=1.0, q=0.0).sensitivities(1.0).round(6)[0, :3]
        array([ 0.540302,  0.841471, -0.420735])
        """
        by = ("u0", "velocity0", *self._names)
        results = 2 * len(by) * (SENSITIVITIES,)
        found = apply(self._sensitivities, unindexed(t), *self._operands, results=results)
        return tensor(found, {"of": ("u", "velocity"), "by": by})
