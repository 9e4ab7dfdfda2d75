"""The core's functions as operators of PyTorch: elementwise, of float64 on CPUs, with derivatives that are operators again.

The derivatives of a motion are `sensitivities`, and theirs `second_sensitivities`, which has none. Those by the time are
velocity and acceleration. A derivative that is registered with an operator is refused by ``torch.func``, so that they
stand in classes of their own. Source: DLMF 19.8.5, 19.25(i), 22.13(i).
"""

from collections.abc import Callable
from typing import Any

import numpy as np
import torch  # type: ignore[import-not-found, unused-ignore]

from .. import _core, elliptic
from ..pendulum import energy_ratio, energy_ratio_c

OF_TIME = "t theta0 velocity0 omega0"
OF_STATE = "theta velocity omega0"


def operator(name: str, given: str, count: int, function: Callable[..., Any]) -> Any:
    """An operator of tensors of one shape, from a function of arrays that gives `count` of them."""
    names = given.split()
    results = ", ".join(count * ["Tensor"])
    schema = f"({', '.join(f'Tensor {each}' for each in names)}) -> {results if count == 1 else f'({results})'}"

    def columns(*tensors: Any) -> Any:
        found = function(*(tensor.numpy() for tensor in tensors))
        made = tuple(torch.from_numpy(np.asarray(each)) for each in (found if count > 1 else (found,)))
        return made if count > 1 else made[0]

    def shapes(*tensors: Any) -> Any:
        made = tuple(torch.empty(tensors[0].shape, dtype=torch.float64) for _ in range(count))
        return made if count > 1 else made[0]

    made = torch.library.custom_op(f"libration::{name}", columns, mutates_args=(), schema=schema)
    made.register_fake(shapes)

    @made.register_vmap  # type: ignore[untyped-decorator, unused-ignore]
    def rows(info: Any, axes: tuple[int | None, ...], *tensors: Any) -> Any:
        moved = (
            tensor.expand(info.batch_size, *tensor.shape) if axis is None else tensor.movedim(axis, 0)
            for tensor, axis in zip(tensors, axes, strict=True)
        )
        return made(*moved), 0 if count == 1 else count * (0,)

    # As torch.compile knows it.
    return getattr(torch.ops.libration, name).default


def derived(made: Any, keep: Callable[..., Any], back: Callable[..., Any]) -> Any:
    """An operator with what it keeps of a call, and the products with its derivatives."""

    class Derived(torch.autograd.Function):  # type: ignore[misc, unused-ignore]
        generate_vmap_rule = True

        @staticmethod
        def forward(*given: Any) -> Any:
            return made(*given)

        setup_context = staticmethod(keep)
        backward = staticmethod(back)

    return Derived.apply


def _second_sensitivities(t: Any, theta0: Any, velocity0: Any, omega0: Any) -> Any:
    return _core.orbit_second_sensitivities(t, theta0, velocity0, 1.0, 0.0, *_core.factors(omega0))


def _period_slopes(theta: Any, velocity: Any, omega0: Any) -> Any:
    """By dK/dm = B/(2 mc), B = K - R_D(0, mc, 1)/3, without a difference that cancels; a rotation has the parameter 1/m."""
    m, mc = energy_ratio(theta, velocity, omega0), energy_ratio_c(theta, velocity, omega0)
    with np.errstate(all="ignore"):
        rotation = mc < 0
        turning = np.where(rotation, m, 1.0)
        complement = np.where(rotation, -mc / turning, mc)
        k = elliptic.complete_k(mc=complement)
        b = k - elliptic.carlson_rd(0.0, complement, 1.0) / 3
        by_m = np.where(rotation, -(k - b / mc) / turning**1.5, 2 * b / mc) / omega0
        by_velocity = by_m * velocity / (2 * omega0 * omega0)
        by_omega0 = -(_core.period(theta, velocity, omega0) + velocity * by_velocity) / omega0
        return by_m * np.sin(theta) / 2, by_velocity, by_omega0


MOTION = operator("motion", OF_TIME, 2, _core.state_motion)
ADVANCE = operator("advance", OF_TIME, 2, lambda t, theta, velocity, omega0: _core.advance(theta, velocity, t, omega0))
SENSITIVITIES = operator("sensitivities", OF_TIME, 6, _core.state_sensitivities)
SECOND_SENSITIVITIES = operator("second_sensitivities", OF_TIME, 12, _second_sensitivities)
PERIOD = operator("period", OF_STATE, 1, _core.period)
PERIOD_SLOPES = operator("period_slopes", OF_STATE, 3, _period_slopes)


def _keep_all(ctx: Any, inputs: Any, output: Any) -> None:
    ctx.save_for_backward(*inputs, *output)


def _keep_inputs(ctx: Any, inputs: Any, output: Any) -> None:
    ctx.save_for_backward(*inputs)


def _motion_back(ctx: Any, of_theta: Any, of_velocity: Any) -> Any:
    t, theta0, velocity0, omega0, theta, velocity = ctx.saved_tensors
    by_time = of_theta * velocity - of_velocity * omega0 * omega0 * torch.sin(theta)
    if not any(ctx.needs_input_grad[1:]):
        return by_time, None, None, None
    slopes = sensitivities(t, theta0, velocity0, omega0)
    return by_time, *(of_theta * slopes[i] + of_velocity * slopes[3 + i] for i in range(3))


def _sensitivities_back(ctx: Any, *of: Any) -> Any:
    t, theta0, velocity0, omega0, *slopes = ctx.saved_tensors
    theta, _ = motion(t, theta0, velocity0, omega0)
    stiffness = omega0 * omega0 * torch.cos(theta)
    by_time = sum(of[i] * slopes[3 + i] - of[3 + i] * stiffness * slopes[i] for i in range(3))
    by_time = by_time - 2 * of[5] * omega0 * torch.sin(theta)
    second = second_sensitivities(t, theta0, velocity0, omega0)
    # Where each element of a symmetric matrix stands among its six different ones.
    places = ((0, 1, 2), (1, 3, 4), (2, 4, 5))
    by_start = (sum(of[i] * second[row[i]] + of[3 + i] * second[6 + row[i]] for i in range(3)) for row in places)
    return by_time, *by_start


def _period_back(ctx: Any, of: Any) -> Any:
    return tuple(of * slope for slope in period_slopes(*ctx.saved_tensors))


def _no_more(ctx: Any, *_: Any) -> Any:
    raise NotImplementedError(
        "libration.torch has first and second derivatives of motions and first ones of periods: libration.jax has all"
    )


motion = derived(MOTION, _keep_all, _motion_back)
advance = derived(ADVANCE, _keep_all, _motion_back)
sensitivities = derived(SENSITIVITIES, _keep_all, _sensitivities_back)
second_sensitivities = derived(SECOND_SENSITIVITIES, _keep_inputs, _no_more)
period = derived(PERIOD, _keep_inputs, _period_back)
period_slopes = derived(PERIOD_SLOPES, _keep_inputs, _no_more)
