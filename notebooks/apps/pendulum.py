# A pendulum to set by two sliders: its motion, its period, and what a small swing would take.
#
#     pip install 'libration[plot,widget]' marimo
#     marimo run notebooks/apps/pendulum.py

import marimo

__generated_with = "0.25.2"
app = marimo.App(app_title="A pendulum")


@app.cell
def _():
    import math

    import marimo as mo

    from libration import Pendulum

    return Pendulum, math, mo


@app.cell
def _(mo):
    angle = mo.ui.slider(1, 179, value=150, label="release angle [degrees]", show_value=True)
    length = mo.ui.slider(0.1, 2.0, step=0.05, value=1.0, label="length [m]", show_value=True)
    mo.vstack([mo.md("# A pendulum"), angle, length])
    return angle, length


@app.cell
def _(Pendulum, angle, length, math):
    pendulum = Pendulum.degrees(angle.value, length=length.value)
    small = 2 * math.pi / pendulum.omega0
    return pendulum, small


@app.cell
def _(mo, pendulum, small):
    longer = 100 * (pendulum.period / small - 1)
    mo.md(f"It swings once in **{pendulum.period:.4f} s**, {longer:.1f} % longer than a small swing, {small:.4f} s.")
    return


@app.cell
def _(pendulum):
    pendulum.plot()
    return


@app.cell
def _(mo):
    mo.md("The same pendulum as the lab, to drag, where anywidget is installed:")
    return


@app.cell
def _(pendulum):
    pendulum
    return


if __name__ == "__main__":
    app.run()
