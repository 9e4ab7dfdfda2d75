from typing import final

import numpy as np

__all__ = [
    "Orbit",
    "__version__",
    "action",
    "advance",
    "complete_e_k",
    "complete_e_m",
    "complete_e_mc",
    "complete_k_k",
    "complete_k_m",
    "complete_k_mc",
    "factors",
    "frequency",
    "from_action_phase",
    "harmonic_distortion",
    "incomplete_e_k",
    "incomplete_e_m",
    "incomplete_e_mc",
    "incomplete_f_k",
    "incomplete_f_m",
    "incomplete_f_mc",
    "jacobi_k",
    "jacobi_m",
    "jacobi_mc",
    "nome_k",
    "nome_m",
    "nome_mc",
    "orbit_motion",
    "orbit_phase",
    "orbit_second_sensitivities",
    "orbit_sensitivities",
    "orbit_theta",
    "orbit_velocity",
    "phase",
    "state_motion",
    "state_sensitivities",
    "state_theta",
    "state_velocity",
    "turns",
]

__version__: str

action: np.ufunc
advance: np.ufunc
complete_e_k: np.ufunc
complete_e_m: np.ufunc
complete_e_mc: np.ufunc
complete_k_k: np.ufunc
complete_k_m: np.ufunc
complete_k_mc: np.ufunc
factors: np.ufunc
frequency: np.ufunc
from_action_phase: np.ufunc
harmonic_distortion: np.ufunc
incomplete_e_k: np.ufunc
incomplete_e_m: np.ufunc
incomplete_e_mc: np.ufunc
incomplete_f_k: np.ufunc
incomplete_f_m: np.ufunc
incomplete_f_mc: np.ufunc
jacobi_k: np.ufunc
jacobi_m: np.ufunc
jacobi_mc: np.ufunc
nome_k: np.ufunc
nome_m: np.ufunc
nome_mc: np.ufunc
orbit_motion: np.ufunc
orbit_phase: np.ufunc
orbit_second_sensitivities: np.ufunc
orbit_sensitivities: np.ufunc
orbit_theta: np.ufunc
orbit_velocity: np.ufunc
phase: np.ufunc
state_motion: np.ufunc
state_sensitivities: np.ufunc
state_theta: np.ufunc
state_velocity: np.ufunc
turns: np.ufunc

@final
class Orbit:
    def __new__(
        cls,
        theta0: float,
        velocity0: float,
        omega0: float | None = None,
        omega2: float | None = None,
        length: float | None = None,
        gravity: float | None = None,
    ) -> Orbit: ...
    @property
    def operands(self) -> tuple[float, float, float, float, float]: ...
    @property
    def theta0(self) -> float: ...
    @property
    def velocity0(self) -> float: ...
    @property
    def regime(self) -> str: ...
    @property
    def period(self) -> float: ...
    @property
    def theta_max(self) -> float: ...
    @property
    def energy_ratio(self) -> float: ...
    @property
    def energy_ratio_c(self) -> float: ...
    @property
    def energy(self) -> float: ...
    @property
    def omega0(self) -> float: ...
    @property
    def omega2(self) -> float: ...
    def theta(self, /, t: float) -> np.float64: ...
    def velocity(self, /, t: float) -> np.float64: ...
    def motion(self, /, t: float) -> tuple[np.float64, np.float64]: ...
    def turns(self, /, t: float) -> tuple[np.int64, np.float64]: ...
    def phase(self, /, t: float) -> np.float64: ...
    def times(self, /, theta: float, start: float, stop: float) -> np.ndarray: ...
    def turning_times(self, /, start: float, stop: float) -> np.ndarray: ...
    def fourier(self, /, n: int) -> tuple[np.ndarray, np.ndarray]: ...
    @staticmethod
    def state_of(
        action: float,
        phase: float,
        direction: float,
        omega0: float | None = None,
        omega2: float | None = None,
        length: float | None = None,
        gravity: float | None = None,
    ) -> tuple[float, float]: ...
    @property
    def extremes(self) -> tuple[float, float]: ...
    @property
    def action(self) -> float: ...
    @property
    def frequency(self) -> float: ...
    @property
    def distortion(self) -> float: ...
