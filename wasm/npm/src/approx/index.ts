/** Approximations by name: of the angle over time, of the period, and by the integrators people use. */

export { AngleApproximation, type AngleError, AngleFormula, angle } from "./angle.js";
export { NumericalFormula, type NumericalSteps, NumericalSolution, numerical } from "./numerical.js";
export { PeriodFormula, period, type Swing } from "./period.js";
export type { Entry, Interval, Orders, Registry } from "./registry.js";
