"""A program that uses the package, for type checkers: what each call gives, and the mistakes they must find.

It is checked by test_typing.py and never run.
"""

from typing import assert_type

import numpy as np
import xarray
from numpy.typing import NDArray

import libration
from libration import (
    Duffing,
    DuffingForm,
    Fourier,
    JacobiValues,
    OscillatorRegime,
    Pendulum,
    Regime,
    approx,
    elliptic,
    ensemble,
    papers,
)

Floats = NDArray[np.float64]
T = np.linspace(0.0, 1.0, 5)
NAMED = xarray.DataArray(T, dims="time")
PENDULUM = Pendulum(1.0, length=1.0)


def ensembles() -> None:
    theta, velocity = ensemble.bunch(10, distribution="gaussian", sigma_theta=0.8, seed=1)
    assert_type(theta, Floats)
    assert_type(ensemble.track(theta, velocity, 0.1, steps=3), tuple[Floats, Floats, NDArray[np.int64]])
    ensemble.track(theta, velocity, 0.1, steps=3, kick=lambda theta, step: 0.1 * theta, record=[1, 3], scheme="order8")
    ring = ensemble.Bucket(8e6, 35640, 450e9, 938.272e6, 1, 26658.883, 3.225e-4)
    assert_type(ring.qs, float)
    assert_type(ring.matched(10, emittance=0.1, seed=1), tuple[Floats, Floats])
    ensemble.bunch(10, distribution="gaussian", sigma=0.8, seed=1)  # type: ignore
    ensemble.track(theta, velocity, 0.1, steps="3")  # type: ignore


def one_orbit() -> None:
    assert_type(PENDULUM.theta(1.0), np.float64)
    assert_type(PENDULUM.theta(1), np.float64)
    assert_type(PENDULUM.theta(T), Floats)
    assert_type(PENDULUM.theta([0.0, 1.0]), Floats)
    assert_type(PENDULUM.theta(NAMED), xarray.DataArray)
    assert_type(PENDULUM.theta(T, out=T), Floats)
    assert_type(Pendulum.degrees(30, length=1.0), Pendulum)
    assert_type(PENDULUM.length, float | None)
    assert_type(PENDULUM.gravity, float | None)
    assert_type(PENDULUM.velocity(np.float32(1.0)), np.float64)
    assert_type(PENDULUM.motion(1.0), tuple[np.float64, np.float64])
    assert_type(PENDULUM.motion(T), tuple[Floats, Floats])
    assert_type(PENDULUM.motion(NAMED), tuple[xarray.DataArray, xarray.DataArray])
    assert_type(PENDULUM.turns(1.0), tuple[np.int64, np.float64])
    assert_type(PENDULUM.turns(T), tuple[NDArray[np.int64], Floats])
    assert_type(PENDULUM.phase(T), Floats)
    assert_type(PENDULUM.sensitivities(1.0), Floats)
    assert_type(PENDULUM.sensitivities(NAMED), xarray.DataArray)
    assert_type(PENDULUM.times(0.0, 0.0, 1.0), Floats)
    assert_type(PENDULUM.fourier(3), Fourier)
    assert_type(PENDULUM.fourier(3).theta, Floats)
    assert_type(PENDULUM.regime, Regime)
    assert_type(PENDULUM.period, float)
    assert_type(PENDULUM.extremes, tuple[float, float])
    assert_type(Pendulum.from_action_phase(1.0, 0.5), Pendulum)
    assert_type(Pendulum(theta0_from_top=1e-17), Pendulum)
    assert_type(Pendulum.from_energy(energy_ratio_c=1e-17, length=1.0), Pendulum)
    assert_type(Pendulum.from_turning_angle(2.0, theta0=0.5, direction=-1), Pendulum)
    assert_type(Pendulum.from_period(7.0, regime="rotation"), Pendulum)
    assert_type(PENDULUM.times(0.0, 0.0, 1.0, every_turn=True), Floats)


def arrays_of_states() -> None:
    assert_type(libration.theta(1.0, 2.0), np.float64)
    assert_type(libration.theta(T, 2), Floats)
    assert_type(libration.theta(1.0, [1.0, 2.0], where=[True, False]), Floats)
    assert_type(libration.velocity(NAMED, 2.0), xarray.DataArray)
    assert_type(libration.motion(1.0, 2.0), tuple[np.float64, np.float64])
    assert_type(libration.advance(T, T, 0.1), tuple[Floats, Floats])
    assert_type(libration.action(1.0), np.float64)
    assert_type(libration.frequency(T), Floats)
    assert_type(libration.phase(NAMED), xarray.DataArray)
    assert_type(libration.from_action_phase(T, 0.0), tuple[Floats, Floats])
    assert_type(libration.from_action_phase(T, 0.0, length=1.0), tuple[Floats, Floats])
    assert_type(libration.period(energy_ratio_c=1e-17), np.float64)
    assert_type(libration.period(energy_ratio_c=T, length=1.0), Floats)
    assert_type(libration.energy(NAMED, omega2=2.0), xarray.DataArray)
    assert_type(libration.motion(1.0, theta0_from_top=T, omega2=73.5), tuple[Floats, Floats])
    assert_type(libration.next_crossing(1.0, T, after=2.0), Floats)
    assert_type(libration.turns(1.0, 2.0, 3.0), tuple[np.int64, np.float64])
    assert_type(libration.regime(T), NDArray[np.str_])
    assert_type(libration.from_nome(T), tuple[Floats, Floats])
    assert_type(elliptic.sc(1 + 0.5j, q=0.1), np.complex128)
    assert_type(elliptic.ns(T, q=0.1), Floats)
    assert_type(libration.sensitivities(T, 1.0), Floats)
    assert_type(libration.harmonic_distortion(1.0), np.float64)
    assert_type(libration.duffing_motion(T, 1.0), tuple[Floats, Floats])


def elliptic_functions() -> None:
    assert_type(libration.complete_k(m=0.5), np.float64)
    assert_type(elliptic.complete_e(mc=T), Floats)
    assert_type(elliptic.nome(k=NAMED), xarray.DataArray)
    assert_type(elliptic.sn(1.0, m=0.5), np.float64)
    assert_type(elliptic.arcdc(T, m=0.5), Floats)
    assert_type(elliptic.theta3(1.0, q=T), Floats)
    assert_type(elliptic.incomplete_pi(0.3, 1.0, m=NAMED), xarray.DataArray)
    assert_type(elliptic.carlson_rj(1.0, 2.0, 3.0, 4.0), np.float64)
    assert_type(elliptic.jacobi(1.0, m=0.5), JacobiValues[np.float64])
    assert_type(elliptic.jacobi(T, m=0.5).am, Floats)
    assert_type(elliptic.jacobi_complex(1j, m=0.5).sn, np.complex128)
    assert_type(elliptic.jacobi_complex(T + 1j, m=0.5).sn, NDArray[np.complex128])


def springs_and_approximations() -> None:
    duffing = Duffing(1.0, p=1.0, q=1.0)
    assert_type(duffing.u(1.0), np.float64)
    assert_type(duffing.motion(T), tuple[Floats, Floats])
    assert_type(duffing.regime, OscillatorRegime)
    assert_type(duffing.pendulum, tuple[float, Pendulum] | None)
    assert_type(DuffingForm("cn", 1.0, p=1.0, q=1.0).u(NAMED), xarray.DataArray)
    assert_type(approx.angle("cubic"), approx.AngleFormula)
    assert_type(approx.angle("cubic").of(PENDULUM).theta(T), Floats)
    assert_type(approx.angle("cubic").error(1.0), np.float64)
    assert_type(approx.period("linear").ratio(m=T), Floats)
    assert_type(approx.sine("salas-2").value(1.0), np.float64)
    assert_type(approx.numerical("rk4:0.1").of(PENDULUM).theta(T), Floats)
    assert_type(libration.plot.linear_theta(PENDULUM, 1.0), np.float64)


def exact_forms_of_papers() -> None:
    assert_type(papers.salas_22(1.0, 1), np.float64)
    assert_type(papers.salas_23(T, 1.0, [0.1, 0.2]), Floats)
    assert_type(papers.salas_24(NAMED, 1.0, omega0=2.0), xarray.DataArray)
    assert_type(papers.juchem_neto(1.0, NAMED), xarray.DataArray)
    assert_type(papers.limits()[0].given, float)
    assert_type(papers.claims("lima")[0].verdict, papers.Verdict)
    assert_type(papers.errata()[0].holds(0.5), bool)


def mistakes() -> None:
    libration.Pendulm(1.0)  # type: ignore[attr-defined]
    elliptic.complet_k(m=0.5)  # type: ignore[attr-defined]
    libration.elliptic.complet_k(m=0.5)  # type: ignore[attr-defined]
    approx.angel("cubic")  # type: ignore[attr-defined]
    print(PENDULUM.perod)  # type: ignore[attr-defined]
    print(PENDULUM.amplitude)  # type: ignore[attr-defined]
    Pendulum(1.0, length=1.0, g=9.8)  # type: ignore[call-arg]
    PENDULUM.theta("now")  # type: ignore[arg-type]
    PENDULUM.period = 2.0  # type: ignore[misc]
    libration.theta(1.0, omega2="1")  # type: ignore[arg-type]
    elliptic.complete_k(m=1j)  # type: ignore[call-overload]
    Pendulum("1")  # type: ignore[arg-type]
    papers.salas_23(1.0, "1")  # type: ignore[arg-type]
    papers.claims(1)  # type: ignore[arg-type]
