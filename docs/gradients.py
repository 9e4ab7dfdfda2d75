"""Time of a value and of a gradient by JAX, beside those of the NumPy functions: the table of docs/gradients.md.

    PYTHONPATH=python python docs/gradients.py

Nanoseconds a state, the least of several calls on 8,192 states in one run, and the seconds that the first call takes.
"""

import time
from functools import partial

import jax
import jax.numpy as jnp
import numpy as np

import libration
from libration.jax import motion

COUNT = 8192


def least(function, *given):
    """The seconds of the first call, and the least of the next twenty."""
    times = []
    for _ in range(21):
        begun = time.perf_counter()
        jax.block_until_ready(function(*given))
        times.append(time.perf_counter() - begun)
    return times[0], min(times[1:])


def value_and_gradient(digits):
    of = partial(motion, digits=digits)
    return jax.jit(jax.vmap(jax.value_and_grad(lambda *given: of(*given)[0], argnums=(1, 2, 3))))


def row(name, value, gradient):
    print(
        f"| {name} | {value[1] / COUNT * 1e9:.0f} | {gradient[1] / COUNT * 1e9:.0f} | {value[0]:.1f} | {gradient[0]:.1f} |"
    )


if __name__ == "__main__":
    jax.config.update("jax_enable_x64", True)
    rng = np.random.default_rng(1)
    given = [rng.uniform(*ends, COUNT) for ends in ((0, 100), (-3, 3), (-3, 3), (0.5, 2))]
    print("| | value, ns | with gradient, ns | first call, s | with gradient, s |\n|---|---:|---:|---:|---:|")
    for digits in ("full", "short"):
        for dtype in (jnp.float64, jnp.float32):
            passed = [jnp.asarray(each, dtype) for each in given]
            times = least(partial(motion, digits=digits), *passed), least(value_and_gradient(digits), *passed)
            row(f'`"{digits}"`, {jnp.dtype(dtype)}', *times)
    row("NumPy: `motion`, `sensitivities`", least(libration.motion, *given), least(libration.sensitivities, *given))
