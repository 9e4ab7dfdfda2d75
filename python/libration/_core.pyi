from collections.abc import Callable
from typing import final

import numpy as np

__all__ = [
    "AngleApproximation",
    "AngleFormula",
    "CubicQuintic",
    "DampedPendulum",
    "Duffing",
    "DuffingForm",
    "NumericalSolution",
    "Orbit",
    "PeriodFormula",
    "Record",
    "SineFormula",
    "__version__",
    "action",
    "advance",
    "arccd_k",
    "arccd_m",
    "arccd_mc",
    "arccd_q",
    "arccn_k",
    "arccn_m",
    "arccn_mc",
    "arccn_q",
    "arccs_k",
    "arccs_m",
    "arccs_mc",
    "arccs_q",
    "arcdc_k",
    "arcdc_m",
    "arcdc_mc",
    "arcdc_q",
    "arcdn_k",
    "arcdn_m",
    "arcdn_mc",
    "arcdn_q",
    "arcds_k",
    "arcds_m",
    "arcds_mc",
    "arcds_q",
    "arcnc_k",
    "arcnc_m",
    "arcnc_mc",
    "arcnc_q",
    "arcnd_k",
    "arcnd_m",
    "arcnd_mc",
    "arcnd_q",
    "arcns_k",
    "arcns_m",
    "arcns_mc",
    "arcns_q",
    "arcsc_k",
    "arcsc_m",
    "arcsc_mc",
    "arcsc_q",
    "arcsd_k",
    "arcsd_m",
    "arcsd_mc",
    "arcsd_q",
    "arcsn_k",
    "arcsn_m",
    "arcsn_mc",
    "arcsn_q",
    "carlson_rc",
    "carlson_rd",
    "carlson_rf",
    "carlson_rj",
    "cd_complex_k",
    "cd_complex_m",
    "cd_complex_mc",
    "cd_complex_q",
    "cd_k",
    "cd_m",
    "cd_mc",
    "cd_q",
    "cd_rows_k",
    "cd_rows_m",
    "cd_rows_mc",
    "cd_rows_q",
    "check_friction",
    "cn_complex_k",
    "cn_complex_m",
    "cn_complex_mc",
    "cn_complex_q",
    "cn_k",
    "cn_m",
    "cn_mc",
    "cn_q",
    "cn_rows_k",
    "cn_rows_m",
    "cn_rows_mc",
    "cn_rows_q",
    "column",
    "complete_e_k",
    "complete_e_m",
    "complete_e_mc",
    "complete_e_q",
    "complete_k_k",
    "complete_k_m",
    "complete_k_mc",
    "complete_k_q",
    "complete_pi_k",
    "complete_pi_m",
    "complete_pi_mc",
    "complete_pi_q",
    "cs_complex_k",
    "cs_complex_m",
    "cs_complex_mc",
    "cs_complex_q",
    "cs_k",
    "cs_m",
    "cs_mc",
    "cs_q",
    "cs_rows_k",
    "cs_rows_m",
    "cs_rows_mc",
    "cs_rows_q",
    "cubic_quintic_action",
    "cubic_quintic_escape_times",
    "cubic_quintic_frequency",
    "cubic_quintic_from_action_phase",
    "cubic_quintic_from_energy",
    "cubic_quintic_motion",
    "cubic_quintic_period",
    "cubic_quintic_phase",
    "cubic_quintic_regime",
    "cubic_quintic_rows",
    "cubic_quintic_sensitivities",
    "cubic_quintic_u",
    "cubic_quintic_velocity",
    "dc_complex_k",
    "dc_complex_m",
    "dc_complex_mc",
    "dc_complex_q",
    "dc_k",
    "dc_m",
    "dc_mc",
    "dc_q",
    "dc_rows_k",
    "dc_rows_m",
    "dc_rows_mc",
    "dc_rows_q",
    "dn_complex_k",
    "dn_complex_m",
    "dn_complex_mc",
    "dn_complex_q",
    "dn_k",
    "dn_m",
    "dn_mc",
    "dn_q",
    "dn_rows_k",
    "dn_rows_m",
    "dn_rows_mc",
    "dn_rows_q",
    "ds_complex_k",
    "ds_complex_m",
    "ds_complex_mc",
    "ds_complex_q",
    "ds_k",
    "ds_m",
    "ds_mc",
    "ds_q",
    "ds_rows_k",
    "ds_rows_m",
    "ds_rows_mc",
    "ds_rows_q",
    "duffing_action",
    "duffing_escape_times",
    "duffing_frequency",
    "duffing_from_action_phase",
    "duffing_from_energy",
    "duffing_motion",
    "duffing_of_pendulum",
    "duffing_period",
    "duffing_phase",
    "duffing_regime",
    "duffing_rows",
    "duffing_sensitivities",
    "duffing_u",
    "duffing_velocity",
    "energy_ratio",
    "energy_ratio_c",
    "equivalent_length",
    "exponential",
    "factors",
    "factors_length",
    "factors_omega2",
    "fit_columns",
    "fit_records",
    "fit_steps",
    "frequency",
    "friction_law",
    "friction_models",
    "from_action_phase",
    "from_nome",
    "gravity_of_period",
    "gravity_of_pivots",
    "harmonic_distortion",
    "heuman_lambda_k",
    "heuman_lambda_m",
    "heuman_lambda_mc",
    "heuman_lambda_q",
    "histogram",
    "incomplete_e_k",
    "incomplete_e_m",
    "incomplete_e_mc",
    "incomplete_e_q",
    "incomplete_f_k",
    "incomplete_f_m",
    "incomplete_f_mc",
    "incomplete_f_q",
    "incomplete_pi_k",
    "incomplete_pi_m",
    "incomplete_pi_mc",
    "incomplete_pi_q",
    "jacobi_complex_k",
    "jacobi_complex_m",
    "jacobi_complex_mc",
    "jacobi_complex_q",
    "jacobi_epsilon_k",
    "jacobi_epsilon_m",
    "jacobi_epsilon_mc",
    "jacobi_epsilon_q",
    "jacobi_k",
    "jacobi_m",
    "jacobi_mc",
    "jacobi_q",
    "jacobi_rows_k",
    "jacobi_rows_m",
    "jacobi_rows_mc",
    "jacobi_rows_q",
    "jacobi_zeta_k",
    "jacobi_zeta_m",
    "jacobi_zeta_mc",
    "jacobi_zeta_q",
    "moments",
    "nc_complex_k",
    "nc_complex_m",
    "nc_complex_mc",
    "nc_complex_q",
    "nc_k",
    "nc_m",
    "nc_mc",
    "nc_q",
    "nc_rows_k",
    "nc_rows_m",
    "nc_rows_mc",
    "nc_rows_q",
    "nd_complex_k",
    "nd_complex_m",
    "nd_complex_mc",
    "nd_complex_q",
    "nd_k",
    "nd_m",
    "nd_mc",
    "nd_q",
    "nd_rows_k",
    "nd_rows_m",
    "nd_rows_mc",
    "nd_rows_q",
    "nome_k",
    "nome_m",
    "nome_mc",
    "nome_q",
    "normal_gravity",
    "ns_complex_k",
    "ns_complex_m",
    "ns_complex_mc",
    "ns_complex_q",
    "ns_k",
    "ns_m",
    "ns_mc",
    "ns_q",
    "ns_rows_k",
    "ns_rows_m",
    "ns_rows_mc",
    "ns_rows_q",
    "orbit_action",
    "orbit_advance",
    "orbit_energy",
    "orbit_energy_ratio",
    "orbit_energy_ratio_c",
    "orbit_frequency",
    "orbit_from_action_phase",
    "orbit_motion",
    "orbit_next_crossing",
    "orbit_period",
    "orbit_phase",
    "orbit_regime",
    "orbit_second_sensitivities",
    "orbit_sensitivities",
    "orbit_theta",
    "orbit_theta_max",
    "orbit_velocity",
    "pendulum_of_duffing",
    "period",
    "phase",
    "sc_complex_k",
    "sc_complex_m",
    "sc_complex_mc",
    "sc_complex_q",
    "sc_k",
    "sc_m",
    "sc_mc",
    "sc_q",
    "sc_rows_k",
    "sc_rows_m",
    "sc_rows_mc",
    "sc_rows_q",
    "schemes",
    "sd_complex_k",
    "sd_complex_m",
    "sd_complex_mc",
    "sd_complex_q",
    "sd_k",
    "sd_m",
    "sd_mc",
    "sd_q",
    "sd_rows_k",
    "sd_rows_m",
    "sd_rows_mc",
    "sd_rows_q",
    "sn_complex_k",
    "sn_complex_m",
    "sn_complex_mc",
    "sn_complex_q",
    "sn_k",
    "sn_m",
    "sn_mc",
    "sn_q",
    "sn_rows_k",
    "sn_rows_m",
    "sn_rows_mc",
    "sn_rows_q",
    "state_motion",
    "state_sensitivities",
    "state_theta",
    "state_velocity",
    "steps",
    "theta1_k",
    "theta1_m",
    "theta1_mc",
    "theta1_q",
    "theta2_k",
    "theta2_m",
    "theta2_mc",
    "theta2_q",
    "theta3_k",
    "theta3_m",
    "theta3_mc",
    "theta3_q",
    "theta4_k",
    "theta4_m",
    "theta4_mc",
    "theta4_q",
    "torque_at",
    "turns",
    "uniforms",
    "wrap",
    "xla_advance",
    "xla_motion",
    "xla_period",
    "xla_sensitivities",
]

__version__: str

action: np.ufunc
advance: np.ufunc
arccd_k: np.ufunc
arccd_m: np.ufunc
arccd_mc: np.ufunc
arccd_q: np.ufunc
arccn_k: np.ufunc
arccn_m: np.ufunc
arccn_mc: np.ufunc
arccn_q: np.ufunc
arccs_k: np.ufunc
arccs_m: np.ufunc
arccs_mc: np.ufunc
arccs_q: np.ufunc
arcdc_k: np.ufunc
arcdc_m: np.ufunc
arcdc_mc: np.ufunc
arcdc_q: np.ufunc
arcdn_k: np.ufunc
arcdn_m: np.ufunc
arcdn_mc: np.ufunc
arcdn_q: np.ufunc
arcds_k: np.ufunc
arcds_m: np.ufunc
arcds_mc: np.ufunc
arcds_q: np.ufunc
arcnc_k: np.ufunc
arcnc_m: np.ufunc
arcnc_mc: np.ufunc
arcnc_q: np.ufunc
arcnd_k: np.ufunc
arcnd_m: np.ufunc
arcnd_mc: np.ufunc
arcnd_q: np.ufunc
arcns_k: np.ufunc
arcns_m: np.ufunc
arcns_mc: np.ufunc
arcns_q: np.ufunc
arcsc_k: np.ufunc
arcsc_m: np.ufunc
arcsc_mc: np.ufunc
arcsc_q: np.ufunc
arcsd_k: np.ufunc
arcsd_m: np.ufunc
arcsd_mc: np.ufunc
arcsd_q: np.ufunc
arcsn_k: np.ufunc
arcsn_m: np.ufunc
arcsn_mc: np.ufunc
arcsn_q: np.ufunc
carlson_rc: np.ufunc
carlson_rd: np.ufunc
carlson_rf: np.ufunc
carlson_rj: np.ufunc
cd_complex_k: np.ufunc
cd_complex_m: np.ufunc
cd_complex_mc: np.ufunc
cd_complex_q: np.ufunc
cd_k: np.ufunc
cd_m: np.ufunc
cd_mc: np.ufunc
cd_q: np.ufunc
cd_rows_k: np.ufunc
cd_rows_m: np.ufunc
cd_rows_mc: np.ufunc
cd_rows_q: np.ufunc
cn_complex_k: np.ufunc
cn_complex_m: np.ufunc
cn_complex_mc: np.ufunc
cn_complex_q: np.ufunc
cn_k: np.ufunc
cn_m: np.ufunc
cn_mc: np.ufunc
cn_q: np.ufunc
cn_rows_k: np.ufunc
cn_rows_m: np.ufunc
cn_rows_mc: np.ufunc
cn_rows_q: np.ufunc
complete_e_k: np.ufunc
complete_e_m: np.ufunc
complete_e_mc: np.ufunc
complete_e_q: np.ufunc
complete_k_k: np.ufunc
complete_k_m: np.ufunc
complete_k_mc: np.ufunc
complete_k_q: np.ufunc
complete_pi_k: np.ufunc
complete_pi_m: np.ufunc
complete_pi_mc: np.ufunc
complete_pi_q: np.ufunc
cs_complex_k: np.ufunc
cs_complex_m: np.ufunc
cs_complex_mc: np.ufunc
cs_complex_q: np.ufunc
cs_k: np.ufunc
cs_m: np.ufunc
cs_mc: np.ufunc
cs_q: np.ufunc
cs_rows_k: np.ufunc
cs_rows_m: np.ufunc
cs_rows_mc: np.ufunc
cs_rows_q: np.ufunc
dc_k: np.ufunc
dc_m: np.ufunc
dc_mc: np.ufunc
dc_rows_k: np.ufunc
dc_rows_m: np.ufunc
dc_rows_mc: np.ufunc
dc_rows_q: np.ufunc
dn_k: np.ufunc
dn_m: np.ufunc
dn_mc: np.ufunc
dn_rows_k: np.ufunc
dn_rows_m: np.ufunc
dn_rows_mc: np.ufunc
dn_rows_q: np.ufunc
ds_k: np.ufunc
ds_m: np.ufunc
ds_mc: np.ufunc
ds_rows_k: np.ufunc
ds_rows_m: np.ufunc
ds_rows_mc: np.ufunc
ds_rows_q: np.ufunc
cubic_quintic_action: np.ufunc
cubic_quintic_escape_times: np.ufunc
cubic_quintic_frequency: np.ufunc
cubic_quintic_motion: np.ufunc
cubic_quintic_period: np.ufunc
cubic_quintic_phase: np.ufunc
cubic_quintic_regime: np.ufunc
cubic_quintic_rows: np.ufunc
cubic_quintic_sensitivities: np.ufunc
cubic_quintic_u: np.ufunc
cubic_quintic_velocity: np.ufunc
dc_complex_k: np.ufunc
dc_complex_m: np.ufunc
dc_complex_mc: np.ufunc
dc_complex_q: np.ufunc
dc_q: np.ufunc
dn_complex_k: np.ufunc
dn_complex_m: np.ufunc
dn_complex_mc: np.ufunc
dn_complex_q: np.ufunc
dn_q: np.ufunc
ds_complex_k: np.ufunc
ds_complex_m: np.ufunc
ds_complex_mc: np.ufunc
ds_complex_q: np.ufunc
ds_q: np.ufunc
duffing_action: np.ufunc
duffing_escape_times: np.ufunc
duffing_frequency: np.ufunc
duffing_motion: np.ufunc
duffing_period: np.ufunc
duffing_phase: np.ufunc
duffing_regime: np.ufunc
duffing_rows: np.ufunc
duffing_sensitivities: np.ufunc
duffing_u: np.ufunc
duffing_velocity: np.ufunc
energy_ratio: np.ufunc
energy_ratio_c: np.ufunc
factors: np.ufunc
factors_length: np.ufunc
factors_omega2: np.ufunc
frequency: np.ufunc
from_action_phase: np.ufunc
from_nome: np.ufunc
harmonic_distortion: np.ufunc
heuman_lambda_k: np.ufunc
heuman_lambda_m: np.ufunc
heuman_lambda_mc: np.ufunc
heuman_lambda_q: np.ufunc
incomplete_e_k: np.ufunc
incomplete_e_m: np.ufunc
incomplete_e_mc: np.ufunc
incomplete_e_q: np.ufunc
incomplete_f_k: np.ufunc
incomplete_f_m: np.ufunc
incomplete_f_mc: np.ufunc
incomplete_f_q: np.ufunc
incomplete_pi_k: np.ufunc
incomplete_pi_m: np.ufunc
incomplete_pi_mc: np.ufunc
incomplete_pi_q: np.ufunc
jacobi_complex_k: np.ufunc
jacobi_complex_m: np.ufunc
jacobi_complex_mc: np.ufunc
jacobi_complex_q: np.ufunc
jacobi_epsilon_k: np.ufunc
jacobi_epsilon_m: np.ufunc
jacobi_epsilon_mc: np.ufunc
jacobi_epsilon_q: np.ufunc
jacobi_k: np.ufunc
jacobi_m: np.ufunc
jacobi_mc: np.ufunc
jacobi_q: np.ufunc
jacobi_rows_k: np.ufunc
jacobi_rows_m: np.ufunc
jacobi_rows_mc: np.ufunc
jacobi_rows_q: np.ufunc
jacobi_zeta_k: np.ufunc
jacobi_zeta_m: np.ufunc
jacobi_zeta_mc: np.ufunc
jacobi_zeta_q: np.ufunc
nc_complex_k: np.ufunc
nc_complex_m: np.ufunc
nc_complex_mc: np.ufunc
nc_complex_q: np.ufunc
nc_k: np.ufunc
nc_m: np.ufunc
nc_mc: np.ufunc
nc_q: np.ufunc
nc_rows_k: np.ufunc
nc_rows_m: np.ufunc
nc_rows_mc: np.ufunc
nc_rows_q: np.ufunc
nd_complex_k: np.ufunc
nd_complex_m: np.ufunc
nd_complex_mc: np.ufunc
nd_complex_q: np.ufunc
nd_k: np.ufunc
nd_m: np.ufunc
nd_mc: np.ufunc
nd_q: np.ufunc
nd_rows_k: np.ufunc
nd_rows_m: np.ufunc
nd_rows_mc: np.ufunc
nd_rows_q: np.ufunc
nome_k: np.ufunc
nome_m: np.ufunc
nome_mc: np.ufunc
nome_q: np.ufunc
ns_complex_k: np.ufunc
ns_complex_m: np.ufunc
ns_complex_mc: np.ufunc
ns_complex_q: np.ufunc
ns_k: np.ufunc
ns_m: np.ufunc
ns_mc: np.ufunc
ns_q: np.ufunc
ns_rows_k: np.ufunc
ns_rows_m: np.ufunc
ns_rows_mc: np.ufunc
ns_rows_q: np.ufunc
orbit_action: np.ufunc
orbit_advance: np.ufunc
orbit_energy: np.ufunc
orbit_energy_ratio: np.ufunc
orbit_energy_ratio_c: np.ufunc
orbit_frequency: np.ufunc
orbit_from_action_phase: np.ufunc
orbit_motion: np.ufunc
orbit_next_crossing: np.ufunc
orbit_period: np.ufunc
orbit_phase: np.ufunc
orbit_regime: np.ufunc
orbit_second_sensitivities: np.ufunc
orbit_sensitivities: np.ufunc
orbit_theta: np.ufunc
orbit_theta_max: np.ufunc
orbit_velocity: np.ufunc
period: np.ufunc
phase: np.ufunc
sc_complex_k: np.ufunc
sc_complex_m: np.ufunc
sc_complex_mc: np.ufunc
sc_complex_q: np.ufunc
sc_k: np.ufunc
sc_m: np.ufunc
sc_mc: np.ufunc
sc_q: np.ufunc
sc_rows_k: np.ufunc
sc_rows_m: np.ufunc
sc_rows_mc: np.ufunc
sc_rows_q: np.ufunc
sd_complex_k: np.ufunc
sd_complex_m: np.ufunc
sd_complex_mc: np.ufunc
sd_complex_q: np.ufunc
sd_k: np.ufunc
sd_m: np.ufunc
sd_mc: np.ufunc
sd_q: np.ufunc
sd_rows_k: np.ufunc
sd_rows_m: np.ufunc
sd_rows_mc: np.ufunc
sd_rows_q: np.ufunc
sn_complex_k: np.ufunc
sn_complex_m: np.ufunc
sn_complex_mc: np.ufunc
sn_complex_q: np.ufunc
sn_k: np.ufunc
sn_m: np.ufunc
sn_mc: np.ufunc
sn_q: np.ufunc
sn_rows_k: np.ufunc
sn_rows_m: np.ufunc
sn_rows_mc: np.ufunc
sn_rows_q: np.ufunc
state_motion: np.ufunc
state_sensitivities: np.ufunc
state_theta: np.ufunc
state_velocity: np.ufunc
theta1_k: np.ufunc
theta1_m: np.ufunc
theta1_mc: np.ufunc
theta1_q: np.ufunc
theta2_k: np.ufunc
theta2_m: np.ufunc
theta2_mc: np.ufunc
theta2_q: np.ufunc
theta3_k: np.ufunc
theta3_m: np.ufunc
theta3_mc: np.ufunc
theta3_q: np.ufunc
theta4_k: np.ufunc
theta4_m: np.ufunc
theta4_mc: np.ufunc
theta4_q: np.ufunc
turns: np.ufunc
# Addresses of functions, for JAX.
xla_advance: object
xla_motion: object
xla_period: object
xla_sensitivities: object

@final
class AngleFormula:
    def __new__(cls, name: str) -> AngleFormula: ...
    @staticmethod
    def patterns() -> list[str]: ...
    @property
    def name(self) -> str: ...
    @property
    def facts(self) -> tuple[str, str, str, str, tuple[float, float] | None, str]: ...
    def of(self, /, orbit: Orbit) -> AngleApproximation: ...
    def ranges(self, /, bound: float, periods: float) -> list[tuple[float, float]]: ...

@final
class AngleApproximation:
    @property
    def period(self) -> float: ...
    def theta(self, /, t: np.ndarray) -> np.ndarray: ...
    def difference(self, /, t: np.ndarray) -> np.ndarray: ...
    def largest_error(self, /, periods: float) -> tuple[float, float, float]: ...

@final
class PeriodFormula:
    def __new__(cls, name: str) -> PeriodFormula: ...
    @staticmethod
    def patterns() -> list[str]: ...
    @property
    def name(self) -> str: ...
    @property
    def facts(self) -> tuple[str, str, str, str, tuple[float, float] | None, str]: ...
    def ratio(self, /, theta_max: np.ndarray) -> np.ndarray: ...
    def ratio_of_m(self, /, m: np.ndarray) -> np.ndarray: ...
    def ratio_of_mc(self, /, mc: np.ndarray) -> np.ndarray: ...
    def error(self, /, theta_max: np.ndarray) -> np.ndarray: ...
    def error_of_m(self, /, m: np.ndarray) -> np.ndarray: ...
    def error_of_mc(self, /, mc: np.ndarray) -> np.ndarray: ...
    def period(self, /, orbit: Orbit) -> float: ...
    def quarter_period(self, /, orbit: Orbit) -> float: ...
    def ranges(self, /, bound: float) -> list[tuple[float, float]]: ...

@final
class SineFormula:
    def __new__(cls, name: str, phi_max: float | None = None) -> SineFormula: ...
    @staticmethod
    def patterns() -> list[str]: ...
    @property
    def name(self) -> str: ...
    @property
    def facts(self) -> tuple[str, str, str, str, tuple[float, float] | None, str]: ...
    @property
    def phi_max(self) -> float | None: ...
    def coefficients(self, /) -> np.ndarray: ...
    def value(self, /, phi: np.ndarray) -> np.ndarray: ...
    def largest_error(self, /, phi_max: float) -> tuple[float, float, float, float]: ...
    def ranges(self, /, bound: float) -> list[tuple[float, float]]: ...

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
    @staticmethod
    def from_start(
        angle: float,
        value: float,
        direction: float,
        kind: float,
        omega0: float | None = None,
        omega2: float | None = None,
        length: float | None = None,
        gravity: float | None = None,
    ) -> Orbit: ...
    @property
    def operands(self) -> tuple[float, float, float, float, float, float, float]: ...
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
    def times(self, /, theta: float, start: float, stop: float, every_turn: bool) -> np.ndarray: ...
    def turning_times(self, /, start: float, stop: float) -> np.ndarray: ...
    def fourier(self, /, n: int) -> list[np.ndarray]: ...
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

@final
class CubicQuintic:
    def __new__(cls, u0: float, velocity0: float, p: float, q: float, s: float) -> CubicQuintic: ...
    @property
    def operands(self) -> list[float]: ...
    @property
    def u0(self) -> float: ...
    @property
    def velocity0(self) -> float: ...
    @property
    def regime(self) -> str: ...
    @property
    def period(self) -> float: ...
    @property
    def range(self) -> tuple[float, float]: ...
    @property
    def energy(self) -> float: ...
    @property
    def escape_time(self) -> float: ...
    @property
    def escape_time_backward(self) -> float: ...
    @property
    def action(self) -> float: ...
    @property
    def frequency(self) -> float: ...
    @property
    def distortion(self) -> float: ...
    def fourier(self, /, n: int) -> tuple[float, np.ndarray, np.ndarray]: ...
    def u(self, /, t: float) -> np.float64: ...
    def velocity(self, /, t: float) -> np.float64: ...
    def motion(self, /, t: float) -> tuple[np.float64, np.float64]: ...
    def times(self, /, u: float, start: float, stop: float) -> np.ndarray: ...

@final
class DampedPendulum:
    def __new__(
        cls,
        theta0: float,
        velocity0: float,
        friction: tuple[float, ...],
        torque: tuple[float, ...],
        samples: tuple[np.ndarray, np.ndarray, str] | None = None,
        omega0: float | None = None,
        omega2: float | None = None,
        length: float | None = None,
        gravity: float | None = None,
    ) -> DampedPendulum: ...
    @property
    def frequency(self) -> tuple[float, float]: ...
    def state(self, /, t: float) -> tuple[np.float64, np.float64]: ...
    def motion(self, /, t: np.ndarray) -> tuple[np.ndarray, np.ndarray]: ...
    def turns(self, /, t: np.ndarray) -> tuple[np.ndarray, np.ndarray]: ...
    def energy(self, /, t: np.ndarray) -> np.ndarray: ...
    def sensitivities(self, /, t: np.ndarray) -> list[np.ndarray]: ...
    def times(self, /, theta: float, start: float, stop: float) -> np.ndarray: ...
    def turning_times(self, /, start: float, stop: float) -> np.ndarray: ...
    def rests(self, /, start: float, stop: float) -> list[tuple[float, float]]: ...
    def decrements(self, /, start: float, stop: float) -> tuple[np.ndarray, np.ndarray]: ...

def check_friction(terms: tuple[float, ...]) -> None: ...
def friction_law(
    name: str,
    values: np.ndarray,
    friction: tuple[float, ...],
    theta_max: float = 0.0,
    omega0: float | None = None,
    omega2: float | None = None,
    length: float | None = None,
    gravity: float | None = None,
) -> np.ndarray: ...
def torque_at(
    terms: tuple[float, ...], samples: tuple[np.ndarray, np.ndarray, str] | None, t: np.ndarray
) -> np.ndarray: ...

@final
class Duffing:
    def __new__(cls, u0: float, velocity0: float, p: float, q: float, r: float, c: float) -> Duffing: ...
    @property
    def operands(self) -> list[float]: ...
    @property
    def u0(self) -> float: ...
    @property
    def velocity0(self) -> float: ...
    @property
    def regime(self) -> str: ...
    @property
    def period(self) -> float: ...
    @property
    def range(self) -> tuple[float, float]: ...
    @property
    def energy(self) -> float: ...
    @property
    def escape_time(self) -> float: ...
    @property
    def escape_time_backward(self) -> float: ...
    @property
    def action(self) -> float: ...
    @property
    def frequency(self) -> float: ...
    @property
    def distortion(self) -> float: ...
    def fourier(self, /, n: int) -> tuple[float, np.ndarray, np.ndarray]: ...
    def u(self, /, t: float) -> np.float64: ...
    def velocity(self, /, t: float) -> np.float64: ...
    def motion(self, /, t: float) -> tuple[np.float64, np.float64]: ...
    def times(self, /, u: float, start: float, stop: float) -> np.ndarray: ...

@final
class DuffingForm:
    def __new__(cls, form: str, p: float, q: float, c1: float, c2: float) -> DuffingForm: ...
    @property
    def rate(self) -> float: ...
    @property
    def parameter(self) -> tuple[float, float]: ...
    def motion(self, /, t: np.ndarray) -> tuple[np.ndarray, np.ndarray]: ...
    @staticmethod
    def table() -> list[tuple[str, list[str]]]: ...

def cubic_quintic_from_action_phase(
    action: float, phase: float, about: float | None, force: tuple[float, float, float]
) -> tuple[float, float]: ...
def cubic_quintic_from_energy(
    energy: float, u0: float, direction: float, force: tuple[float, float, float]
) -> tuple[float, float]: ...
def duffing_of_pendulum(
    theta0: float,
    velocity0: float,
    omega0: float | None = None,
    omega2: float | None = None,
    length: float | None = None,
    gravity: float | None = None,
) -> tuple[float, float, float, float]: ...
def duffing_from_action_phase(
    action: float, phase: float, about: float | None, force: tuple[float, float, float, float]
) -> tuple[float, float]: ...
def duffing_from_energy(
    energy: float, u0: float, direction: float, force: tuple[float, float, float, float]
) -> tuple[float, float]: ...
def pendulum_of_duffing(duffing: Duffing) -> tuple[float, float, float, float] | None: ...
def uniforms(seed: int, first: int, u: np.ndarray, v: np.ndarray) -> None: ...
def exponential(u: np.ndarray, lost: float, x: np.ndarray) -> None: ...
def wrap(theta: np.ndarray, turns: np.ndarray) -> None: ...
def steps(
    theta: np.ndarray,
    velocity: np.ndarray,
    turns: np.ndarray,
    dt: np.ndarray,
    omega0: np.ndarray,
    phase: np.ndarray,
) -> None: ...
def moments(
    theta: np.ndarray, velocity: np.ndarray
) -> tuple[tuple[float, float], tuple[float, float, float]] | None: ...
def histogram(columns: list[np.ndarray], bins: list[tuple[float, float, int]], counts: np.ndarray) -> None: ...
def schemes() -> list[tuple[str, str, str, bool]]: ...

@final
class NumericalSolution:
    def __new__(cls, scheme: str, step: float | None, orbit: Orbit, until: float) -> NumericalSolution: ...
    def theta(self, t: np.ndarray) -> np.ndarray: ...
    def steps(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]: ...
    @property
    def over_the_top(self) -> float: ...

@final
class Record:
    def __new__(
        cls,
        name: str,
        data: bytes,
        columns: list[str],
        units: list[str],
        rate: float | None = None,
        run: int | None = None,
        length: float | None = None,
    ) -> Record: ...
    @property
    def kind(self) -> str: ...
    @property
    def understood(self) -> list[str]: ...
    @property
    def dropped(self) -> list[tuple[str, int, list[int], str]]: ...
    @property
    def run(self) -> tuple[int, int]: ...
    @property
    def time(self) -> np.ndarray: ...
    @property
    def series(self) -> list[tuple[str, str, np.ndarray, float | None]]: ...
    def columns(self) -> tuple[str, list[np.ndarray]]: ...

def friction_models() -> list[str]: ...
def fit_steps() -> list[str]: ...
def fit_columns(
    data: tuple[str, list[np.ndarray]], known: dict[str, object], told: Callable[[str], None] | None
) -> tuple[str, list[str], list[np.ndarray]]: ...
def fit_records(
    records: list[tuple[str, list[np.ndarray]]],
    lengths: list[tuple[float, float]] | None,
    known: dict[str, object],
    told: Callable[[str], None] | None,
) -> tuple[str, list[str], list[tuple[str, list[str], list[np.ndarray]]]]: ...
def gravity_of_pivots(
    periods: list[tuple[float, float]], distances: list[tuple[float, float]], between: bool
) -> tuple[str, list[str]]: ...
def equivalent_length(
    parts: list[tuple[str, tuple[float, float], tuple[float, float], tuple[float, float]]],
) -> tuple[float, float]: ...
def gravity_of_period(
    period: tuple[float, float],
    length: tuple[float, float],
    swing: tuple[float, float],
    end: tuple[float, float] | None = ...,
) -> tuple[tuple[float, float], list[tuple[str, float]], float]: ...
def normal_gravity(latitude: float, height: float) -> float: ...
def column(
    data: bytes,
    name: str | None,
    wanted: tuple[str, str, tuple[str, ...], int, str],
    factor: Callable[[str], str | None],
    quoted: Callable[[str], str],
) -> tuple[np.ndarray, str]: ...
