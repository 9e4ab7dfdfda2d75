# Formulas of the period beside the exact one: the error of each at an angle of your choice.
#
#     pip install 'libration[plot]' marimo
#     marimo run notebooks/apps/formulas.py

import marimo

__generated_with = "0.25.2"
app = marimo.App(app_title="Formulas of the period")


@app.cell
def _():
    import marimo as mo
    import numpy as np

    from libration import approx
    from libration.plot import plot_period

    return approx, mo, np, plot_period


@app.cell
def _(approx, mo):
    angle = mo.ui.slider(1, 179, value=90, label="turning angle [degrees]", show_value=True)
    names = mo.ui.multiselect(approx.period.names, value=["linear", "bernoulli", "lima-arun"], label="formulas")
    mo.vstack([mo.md("# Formulas of the period"), angle, names])
    return angle, names


@app.cell
def _(angle, approx, mo, names, np):
    theta_max = np.radians(angle.value)
    rows = [
        {
            "formula": name,
            "T/T0": float(approx.period(name).ratio(theta_max)),
            "error in %": 100 * float(approx.period(name).error(theta_max)),
        }
        for name in names.value
        if ":" not in name
    ]
    mo.ui.table(rows, selection=None)
    return rows, theta_max


@app.cell
def _(plot_period):
    plot_period()
    return


if __name__ == "__main__":
    app.run()
