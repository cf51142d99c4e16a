"""Closed forms, differential equations and measurements of water. SI units."""

import math

import numpy as np

GRAVITY_M_S2 = 9.81

# Martin and Moyce 1952, Phil. Trans. R. Soc. A 244, 312: where the foot of a collapsing column is,
# x / a, at T = n t sqrt(g / a), for a column of width a and height n^2 a. Named by n^2 and by a in
# inches. (2, 2.25): their table 2, and from T = 4 on their figure 3 as PySPH reads it; (2, 1.125):
# figure 3 as PySPH reads it; (1, 2.25): as two later papers print it, which agree.
MARTIN_MOYCE = {
    (2, 2.25): (
        (
            0.41,
            0.84,
            1.19,
            1.43,
            1.63,
            1.83,
            1.98,
            2.20,
            2.32,
            2.51,
            2.65,
            2.83,
            2.98,
            3.11,
            3.33,
            4.034,
            4.418,
        ),
        (
            1.11,
            1.22,
            1.44,
            1.67,
            1.89,
            2.11,
            2.33,
            2.56,
            2.78,
            3.00,
            3.22,
            3.44,
            3.67,
            3.89,
            4.11,
            4.944,
            5.881,
        ),
    ),
    (2, 1.125): (
        (0.849, 1.212, 1.602, 2.283, 2.950, 3.598, 3.905, 4.592),
        (1.245, 1.443, 1.884, 2.689, 3.728, 4.528, 4.999, 5.841),
    ),
    (1, 2.25): (
        (
            0.43,
            0.62,
            0.80,
            0.97,
            1.14,
            1.29,
            1.45,
            1.62,
            1.76,
            1.93,
            2.07,
            2.24,
            2.40,
            2.54,
            2.71,
            2.87,
            3.04,
            3.21,
            3.29,
            3.32,
            3.90,
            4.49,
        ),
        (
            1.11,
            1.22,
            1.44,
            1.67,
            1.89,
            2.11,
            2.33,
            2.56,
            2.78,
            3.00,
            3.22,
            3.44,
            3.67,
            3.89,
            4.11,
            4.33,
            4.56,
            4.78,
            4.89,
            5.00,
            6.00,
            7.00,
        ),
    ),
}


def symplectic_fall(start, velocity, time, step, gravity=-GRAVITY_M_S2):
    """Height in free fall as symplectic Euler steps it: exact up to rounding."""
    return start + velocity * time + 0.5 * gravity * time * (time + step)


def parabola(start, velocity, time, gravity=-GRAVITY_M_S2):
    return start + velocity * time + 0.5 * gravity * time**2


def fall_time(height):
    return math.sqrt(2.0 * height / GRAVITY_M_S2)


def martin_moyce_time(time, width, ratio):
    """T = n t sqrt(g / a)."""
    return time * math.sqrt(ratio * GRAVITY_M_S2 / width)


def elliptical_patch(rate, times, steps_per_unit=4000):
    """Semi-axes of a disk of radius 1 that starts as v = (rate x, -rate y) and feels no outer force
    (Monaghan 1994).

    The flow stays v = (A x, -A y) inside an ellipse of semi-axes a, b on which the pressure is
    zero: a' = A a, b' = -A b, A' = A^2 (b^2 - a^2) / (a^2 + b^2). Returns an array of rows (a, b).
    """

    def slope(state):
        a, b, strain = state
        return np.array(
            [strain * a, -strain * b, strain**2 * (b**2 - a**2) / (a**2 + b**2)]
        )

    state, now, rows = np.array([1.0, 1.0, rate]), 0.0, []
    for time in times:
        count = max(1, math.ceil((time - now) * rate * steps_per_unit))
        step = (time - now) / count
        for _ in range(count):
            k1 = slope(state)
            k2 = slope(state + 0.5 * step * k1)
            k3 = slope(state + 0.5 * step * k2)
            k4 = slope(state + step * k3)
            state = state + step / 6.0 * (k1 + 2 * k2 + 2 * k3 + k4)
        now = time
        rows.append(state[:2])
    return np.array(rows)


def standing_wave_period(length, depth):
    """Of the first sideways mode of water in a tank: half a wave (linear theory)."""
    wave_number = math.pi / length
    return 2 * math.pi / math.sqrt(GRAVITY_M_S2 * wave_number * math.tanh(wave_number * depth))


def damped_swing(times, values):
    """Period, decay rate and amplitude of amplitude exp(-decay t) sin(2 pi t / period + phase) +
    offset.

    Least squares: for each period and decay tried the rest is linear.
    """
    times, values = np.asarray(times), np.asarray(values)

    def fit(period, decay):
        envelope = np.exp(-decay * times)
        angle = 2 * np.pi * times / period
        columns = np.stack(
            [envelope * np.sin(angle), envelope * np.cos(angle), np.ones_like(times)], axis=1
        )
        solution, *_ = np.linalg.lstsq(columns, values, rcond=None)
        return np.sum((columns @ solution - values) ** 2), math.hypot(*solution[:2])

    span = times[-1] - times[0]
    periods, decays = np.linspace(span / 20, span / 2, 181), np.linspace(0, 10 / span, 11)
    for _ in range(12):  # each round looks closer around the best
        errors = np.array([[fit(p, d)[0] for d in decays] for p in periods])
        row, column = np.unravel_index(np.argmin(errors), errors.shape)
        period, decay = periods[row], decays[column]
        width, height = periods[1] - periods[0], decays[1] - decays[0]
        periods = np.linspace(max(period - width, 1e-9), period + width, 9)
        decays = np.linspace(max(decay - height, 0.0), decay + height, 9)
    return period, decay, fit(period, decay)[1]
