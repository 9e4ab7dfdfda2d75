/** What the modules of WebAssembly export, by their Rust files. */

/** What every module exports: wasm/src/abi/exchange.rs. */
export interface Exchange {
  memory: WebAssembly.Memory;
  columns(): number;
  rows(): number;
  list(): number;
  text(): number;
  text_length(): number;
  text_room(length: number): number;
}

/** What the modules of the pendulum export: wasm/src/abi.rs. */
export interface Exports extends Exchange {
  version(): void;
  orbit_new(
    theta0: number,
    velocity0: number,
    omega0: number,
    omega2: number,
    length: number,
    gravity: number,
    given: number,
  ): number;
  orbit_drop(orbit: number): void;
  orbit_facts(orbit: number): number;
  orbit_theta(orbit: number, rows: number): void;
  orbit_energies(orbit: number, rows: number): void;
  orbit_separatrix_velocity(orbit: number, rows: number): void;
  orbit_next_time(orbit: number, theta: number, after: number): number;
  orbit_motion(orbit: number, rows: number): void;
  orbit_turns(orbit: number, rows: number): void;
  orbit_times(orbit: number, theta: number, start: number, stop: number): number;
  orbit_turning_times(orbit: number, start: number, stop: number): number;
  registry(kind: number): number;
  angle_named(): number;
  angle_new(orbit: number): number;
  angle_drop(approximation: number): void;
  angle_theta(approximation: number, rows: number): void;
  angle_difference(approximation: number, rows: number): void;
  angle_period(approximation: number): number;
  angle_largest_error(approximation: number, periods: number): number;
  angle_ranges(bound: number, periods: number): number;
  period_values(by: number, rows: number): number;
  period_of(orbit: number): number;
  period_ranges(bound: number): number;
  numerical_named(step: number): number;
  numerical_new(orbit: number, step: number, until: number): number;
  numerical_drop(solution: number): void;
  numerical_motion(solution: number, rows: number): void;
  numerical_over_the_top(solution: number): number;
  numerical_steps(solution: number): number;
  jacobi(given: number, parameter: number, rows: number): void;
  complete(given: number, rows: number): void;
}

/** What the module of springs and friction exports: wasm/motions/src/abi.rs. */
export interface MotionExports extends Exchange {
  duffing_new(u0: number, velocity0: number, p: number, q: number, r: number, c: number): number;
  cubic_quintic_new(u0: number, velocity0: number, p: number, q: number, s: number): number;
  spring_drop(spring: number): void;
  spring_facts(spring: number): number;
  spring_motion(spring: number, rows: number): void;
  duffing_of_pendulum(theta0: number, velocity0: number, length: number, gravity: number): number;
  damped_new(
    theta0: number,
    velocity0: number,
    omega0: number,
    omega2: number,
    length: number,
    gravity: number,
    given: number,
    linear: number,
    quadratic: number,
    dry: number,
    presliding: number,
    constant: number,
    amplitude: number,
    frequency: number,
    phase: number,
  ): number;
  damped_drop(damped: number): void;
  damped_reach(damped: number, until: number): number;
  damped_motion(damped: number, rows: number): void;
  damped_energy(damped: number, rows: number): void;
  damped_turns(damped: number, rows: number): void;
  damped_turning_times(damped: number, start: number, stop: number): number;
  damped_rests(damped: number, start: number, stop: number): number;
  damped_averaged(damped: number, thetaMax: number, rows: number): void;
}
