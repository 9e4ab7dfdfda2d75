"""Time of a value and of a gradient by JAX and PyTorch, beside those of the NumPy functions: the tables of docs/gradients.md.

    PYTHONPATH=python python docs/gradients.py

Processor time, of all threads together, which hardly depends on what else the machine does: nanoseconds a state, the least
of several calls, and seconds of the first call. PyTorch has a row where it is installed.
"""

import time
from functools import partial
from importlib.util import find_spec

import jax
import jax.numpy as jnp
import numpy as np

import libration
from libration.jax import motion

COUNT = 8192
ENDS = (0, 100), (-3, 3), (-3, 3), (0.5, 2)
HEAD = "| | value, ns | with gradient, ns | first call, s | with gradient, s |\n|---|---:|---:|---:|---:|"


def times(calls, clock=time.process_time):
    """The seconds of each of some calls."""
    found = []
    for call in calls:
        begun = clock()
        jax.block_until_ready(call())
        found.append(clock() - begun)
    return found


def first_and_least(function, *given):
    """The seconds of the first call, and the least of the next twenty."""
    first, *others = times([partial(function, *given)] * 21)
    return first, min(others)


def value_and_gradient(digits):
    of = partial(motion, digits=digits)
    return jax.jit(jax.vmap(jax.value_and_grad(lambda *given: of(*given)[0], argnums=(1, 2, 3))))


def by_torch(given):
    import torch

    from libration.torch import motion

    t, *start = (torch.tensor(each) for each in given)

    def gradient():
        following = [each.clone().requires_grad_() for each in start]
        theta, _ = motion(t, *following)
        theta.sum().backward()
        return [each.grad.numpy() for each in following]

    return first_and_least(lambda: motion(t, *start)[0].numpy()), first_and_least(gradient)


def row(name, value, gradient):
    print(
        f"| {name} | {value[1] / COUNT * 1e9:.0f} | {gradient[1] / COUNT * 1e9:.0f} | {value[0]:.1f} | {gradient[0]:.1f} |"
    )


if __name__ == "__main__":
    jax.config.update("jax_enable_x64", True)
    rng = np.random.default_rng(1)
    given = [rng.uniform(*ends, COUNT) for ends in ENDS]
    print(HEAD)
    for digits, dtypes in {"core": "d", "full": "df", "short": "df"}.items():
        for dtype in map(np.dtype, dtypes):
            passed = [jnp.asarray(each, dtype) for each in given]
            calls = partial(motion, digits=digits), value_and_gradient(digits)
            row(f'`"{digits}"`, {dtype}', *(first_and_least(call, *passed) for call in calls))
    if find_spec("torch"):
        row("`libration.torch`", *by_torch(given))
    by_numpy = libration.motion, libration.sensitivities
    row("NumPy: `motion`, `sensitivities`", *(first_and_least(function, *given) for function in by_numpy))

    # By turns, so that what else the machine does meets both.
    given = [rng.uniform(*ends, 10**6) for ends in ENDS]
    passed = [jnp.asarray(each) for each in given]
    both = [partial(motion, *passed, digits="core"), partial(libration.motion, *given)]
    for name, clock in (("processor", time.process_time), ("wall", time.perf_counter)):
        found = times(41 * both, clock)[2:]
        core, numpy = min(found[::2]), min(found[1::2])
        print(
            f"{name} time of 1,000,000 states: core {core * 1e3:.1f} ms, NumPy {numpy * 1e3:.1f} ms, {core / numpy:.2f}"
        )
