"""Motions in PyTorch: the core's bits, its derivatives, transformations, and what is refused."""

import math

import numpy as np
import pytest
import torch
from inputs import period_slopes, rows, states_of_periods

import libration
from libration.torch import _operators, advance, motion, period


def tensors(given):
    return [torch.tensor(each) for each in given]


def states(count):
    rng = np.random.default_rng(3)
    return [rng.uniform(*ends, count) for ends in ((-40, 40), (-7, 7), (-4, 4), (0.5, 2))]


def same(found, expected):
    return all(np.array_equal(*pair, equal_nan=True) for pair in zip(found, expected, strict=True))


def test_values_have_the_cores_bits():
    given = rows(np.float64).T
    t, theta, velocity, omega0 = tensors(given)
    assert len(t) > 1600
    assert same(motion(t, theta, velocity, omega0), libration.motion(*given))
    assert not same(motion(t.nextafter(t + 1), theta, velocity, omega0), libration.motion(*given))
    found = advance(theta, velocity, t, omega0)
    assert same(found, libration.advance(*given[1:3], given[0], given[3]))
    assert same([period(theta, velocity, omega0)], [libration.period(*given[1:])])


def test_shapes_and_vmap():
    given = states(60)
    expected = libration.motion(*given)
    table = [each.reshape(12, 5) for each in tensors(given)]
    assert same([each.ravel() for each in motion(*table)], expected)
    for axis in (0, 1):
        found = torch.vmap(torch.vmap(motion), axis, axis)(*table)
        assert same([each.ravel() for each in found], expected)
    found = torch.vmap(lambda t: motion(t, 1.0))(table[0][0])
    assert same(found, libration.motion(given[0][:5], np.array([1.0])))
    assert motion(2.0, 1.0)[0].shape == () and motion(torch.ones(0, dtype=torch.float64), 1.0)[0].shape == (0,)


def test_derivatives_are_the_cores_next_to_the_separatrix_too():
    given = rows(np.float64)
    expected = libration.sensitivities(*given.T)
    given, expected = given[finite := np.isfinite(expected).all((1, 2))], expected[finite]
    assert (np.abs(libration.energy_ratio_c(*given.T[1:])) < 1e-6).sum() > 100
    slopes = torch.vmap(torch.func.jacrev(lambda *each: torch.stack(motion(*each)), argnums=(0, 1, 2, 3)))
    by_t, *by_start = (each.numpy() for each in slopes(*tensors(given.T)))
    assert np.array_equal(np.stack(by_start, -1), expected)
    theta, velocity = libration.motion(*given.T)
    force = -(given[:, 3] ** 2) * np.sin(theta)
    assert np.array_equal(by_t[:, 0], velocity)
    assert (np.abs(by_t[:, 1] - force) <= 1e-15 * given[:, 3] ** 2).all()


def test_second_derivatives():
    given = states(64)
    hessian = torch.vmap(torch.func.jacrev(torch.func.jacrev(lambda start, t: torch.stack(motion(t, *start)))))
    found = hessian(torch.tensor(np.stack(given[1:], -1)), torch.tensor(given[0])).numpy()
    for t, theta0, velocity0, omega0, matrices in zip(*given, found, strict=True):
        expected = libration.Pendulum(theta0, velocity0, omega0=omega0).second_sensitivities(t)
        assert np.array_equal(matrices, expected) and not np.array_equal(matrices, 2 * expected)


def test_derivatives_by_differences_and_by_hand():
    given = [each.requires_grad_() for each in tensors(states(4))]
    for function, arguments in ((motion, given), (advance, [given[1], given[2], given[0], given[3]])):
        assert torch.autograd.gradcheck(function, arguments, eps=1e-6, atol=1e-6, rtol=1e-6)
        assert torch.autograd.gradgradcheck(function, arguments, eps=1e-6, atol=1e-4, rtol=1e-4)
    theta, _ = motion(2.0, 1.0, 0.0, omega0 := torch.tensor(1.0, dtype=torch.float64, requires_grad=True))
    theta.backward()
    assert omega0.grad == libration.sensitivities(2.0, np.array([1.0]))[0, 0, 2]


def test_periods_have_derivatives_next_to_the_separatrix_too():
    given = states_of_periods()
    expected = np.array([period_slopes(*state) for state in zip(*given, strict=True)]).T
    slopes = torch.vmap(torch.func.grad(period, argnums=(0, 1, 2)))
    found, spoiled = (np.stack(slopes(*tensors([given[0] * factor, *given[1:]]))) for factor in (1, 1 + 1e-9))
    weights, complement = np.abs(expected).max(0), np.abs(libration.energy_ratio_c(*given))
    assert (complement < 1e-6).sum() >= 3
    assert (np.abs(found - expected) / weights).max() < 1e-14 < (np.abs(spoiled - expected) / weights).max()


def test_operators_are_what_pytorch_asks_of_them():
    given = tensors(states(5))
    for name in ("MOTION", "ADVANCE", "SENSITIVITIES", "SECOND_SENSITIVITIES", "PERIOD", "PERIOD_SLOPES"):
        torch.library.opcheck(getattr(_operators, name), tuple(given[1:] if "PERIOD" in name else given))


def test_compiled():
    given = [each.requires_grad_() for each in tensors(states(9))]
    compiled = torch.compile(lambda *each: motion(*each)[0].sum(), fullgraph=True, backend="aot_eager")
    found = torch.autograd.grad(compiled(*given), given)
    expected = torch.autograd.grad(motion(*given)[0].sum(), given)
    assert same(found, expected)


def test_bad_elements_are_nan_and_nothing_else_is():
    inf, nan = math.inf, math.nan
    given = torch.tensor([[1, 1, 0, 1], [inf, 1, 0, 1], [1, inf, 0, 1], [1, 1, nan, 1], [1, 1, 0, -1]]).double()
    assert torch.isfinite(torch.stack(motion(*given.T))).tolist() == [[True] + [False] * 4] * 2


def test_bad_arguments_are_one_line():
    with pytest.raises(TypeError, match=r"^t is torch.float32: the core computes in torch.float64, pass t.double\(\)$"):
        motion(torch.ones(3), 1.0)
    with pytest.raises(TypeError, match=r"^dt is on meta: the core runs on CPUs, pass dt.cpu\(\)$"):
        advance(1.0, 0.0, torch.ones(3, dtype=torch.float64, device="meta"))
    with pytest.raises(TypeError, match=r"^velocity must be real, not complex$"):
        period(1.0, 2j)
    with pytest.raises(TypeError, match=r"^theta must be a number or a tensor, not 'a'$"):
        period("a")


def test_what_has_no_derivative_is_one_line():
    def third(omega0):
        return torch.func.grad(torch.func.grad(lambda omega0: motion(2.0, 1.0, 0.0, omega0)[0]))(omega0)

    one = torch.tensor(1.0, dtype=torch.float64)
    line = (
        "^libration.torch has first and second derivatives of motions and first ones of periods: libration.jax has all$"
    )
    assert math.isfinite(third(one))
    for function in (third, torch.func.grad(lambda omega0: period(1.0, 0.0, omega0))):
        with pytest.raises(NotImplementedError, match=line):
            torch.func.grad(function)(one)
