"""Motion, step and period of pendulums as functions of PyTorch: what may be passed."""

from typing import Any

import numpy as np
import torch  # type: ignore[import-not-found, unused-ignore]

from . import _operators as operators


def motion(t: Any, theta0: Any, velocity0: Any = 0.0, omega0: Any = 1.0) -> tuple[torch.Tensor, torch.Tensor]:
    """Angle and angular velocity of pendulums at the times `t`, with exact first and second derivatives.

    `libration.motion` as a function of PyTorch: ``backward``, ``torch.func.grad``, ``vmap``, ``jacrev`` and ``hessian`` take
    it, by any of the four arguments.

    Parameters
    ----------
    t : float or tensor
        Time in s. More than 2**53 half periods give NaN.
    theta0 : float or tensor
        Initial angle in rad.
    velocity0 : float or tensor, default 0.0
        Initial angular velocity in rad/s.
    omega0 : float or tensor, default 1.0
        Angular frequency of small swings in rad/s, positive.

    Returns
    -------
    pair of torch.Tensor of the broadcast shape
        Angle in rad, continuous through whole turns, and angular velocity in rad/s, in float64 on the CPU. A bad element gives
        NaN there and nowhere else.

    Raises
    ------
    TypeError
        For tensors of another type, or on another device.
    NotImplementedError
        For a third derivative.

    Notes
    -----
    Error promised: 8 ulp of the largest angle and velocity, the bits of `libration.motion` for states that are arrays. First
    derivatives: 1e-12 of the largest change, those of `libration.sensitivities`. Second ones: those of
    `Pendulum.second_sensitivities`, NaN outside of its domain, abs(1 - kappa**2) >= 1e-6 and 1e-10 <= kappa**2 <= 1e16.
    Source: DLMF 22.19(i), 22.13(i).

    Examples
    --------
    >>> import torch  # type: ignore[import-not-found, unused-ignore]
    >>> from libration.torch import motion
    >>> omega0 = torch.tensor(1.0, dtype=torch.float64, requires_grad=True)
    >>> theta, velocity = motion(2.0, 1.0, 0.0, omega0)
    >>> theta.backward()
    >>> print(f"{theta:.4f} {velocity:.4f} {omega0.grad:.4f}")
    -0.3062 -0.9090 -1.8181
    """
    found: tuple[torch.Tensor, torch.Tensor] = operators.motion(
        *_given(t=t, theta0=theta0, velocity0=velocity0, omega0=omega0)
    )
    return found


def advance(theta: Any, velocity: Any, dt: Any, omega0: Any = 1.0) -> tuple[torch.Tensor, torch.Tensor]:
    """State of pendulums a time `dt` later, ``(theta, velocity)``, with exact first and second derivatives.

    `libration.advance` as a function of PyTorch: the exact flow, for layers of a network.

    Parameters
    ----------
    theta : float or tensor
        Angle in rad.
    velocity : float or tensor
        Angular velocity in rad/s.
    dt : float or tensor
        Time to go in s, of any sign, as for `motion`.
    omega0 : float or tensor, default 1.0
        Angular frequency of small swings in rad/s, positive.

    Returns
    -------
    pair of torch.Tensor of the broadcast shape
        Angle in rad and angular velocity in rad/s. A bad element gives NaN there and nowhere else.

    Raises
    ------
    TypeError, NotImplementedError
        As for `motion`.

    Notes
    -----
    Error promised: that of `motion`. Source: DLMF 22.8(i), 22.19(i).

    Examples
    --------
    >>> from libration.torch import advance
    >>> theta, velocity = advance(1.0, 0.0, 2.0)
    >>> print(f"{theta:.4f} {velocity:.4f}")
    -0.3062 -0.9090
    """
    found: tuple[torch.Tensor, torch.Tensor] = operators.advance(
        *_given(dt=dt, theta=theta, velocity=velocity, omega0=omega0)
    )
    return found


def period(theta: Any, velocity: Any = 0.0, omega0: Any = 1.0) -> torch.Tensor:
    """Period of pendulums in the states (theta, velocity), with exact first derivatives.

    `libration.period` as a function of PyTorch: 2 pi/omega0 at rest, infinite on the separatrix, the time of one turn in
    rotation.

    Parameters
    ----------
    theta : float or tensor
        Angle in rad.
    velocity : float or tensor, default 0.0
        Angular velocity in rad/s.
    omega0 : float or tensor, default 1.0
        Angular frequency of small swings in rad/s, positive.

    Returns
    -------
    torch.Tensor of the broadcast shape
        Period in s. A bad element gives NaN there and nowhere else.

    Raises
    ------
    TypeError
        As for `motion`.
    NotImplementedError
        For a second derivative.

    Notes
    -----
    Error promised: that of `libration.period`. Source: DLMF 19.8.5, 22.19(i).

    Examples
    --------
    >>> from libration.torch import period
    >>> print(f"{period(3.0):.4f}")
    16.1555
    """
    found: torch.Tensor = operators.period(*_given(theta=theta, velocity=velocity, omega0=omega0))
    return found


def _given(**given: Any) -> tuple[torch.Tensor, ...]:
    """Tensors of float64 on the CPU, of one shape."""
    tensors = []
    for name, value in given.items():
        if not isinstance(value, torch.Tensor):
            if isinstance(value, complex):
                raise TypeError(f"{name} must be real, not complex")
            if not isinstance(value, int | float | np.ndarray | np.generic | list | tuple):
                raise TypeError(f"{name} must be a number or a tensor, not {value!r}")
            value = torch.as_tensor(value, dtype=torch.float64)
        if value.dtype != torch.float64:
            raise TypeError(f"{name} is {value.dtype}: the core computes in torch.float64, pass {name}.double()")
        if value.device.type != "cpu":
            raise TypeError(f"{name} is on {value.device}: the core runs on CPUs, pass {name}.cpu()")
        tensors.append(value)
    return tuple(torch.broadcast_tensors(*tensors))
