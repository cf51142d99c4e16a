"""SPHERIC benchmark 2: a dam breaks against a box on the floor. SI units.

Measured at MARIN (Kleefsman et al. 2005, J. Comput. Phys. 206, 363), published as test 2 of the
SPHERIC community (Issa and Violeau 2006). Readings of the level traces every quarter of a second;
x_m is the distance from the wall that the water runs against.
"""

import typing

TANK_M = 3.22
TIME_S = [0.25 * k for k in range(1, 24)]


class Gauge(typing.NamedTuple):
    name: str
    x_m: float
    bound_percent: float
    level_m: list


GAUGES = (
    Gauge(
        "H1",
        0.496,
        15.0,
        [
            0.001,
            0.001,
            0.001,
            0.151,
            0.270,
            0.346,
            0.323,
            0.288,
            0.298,
            0.324,
            0.251,
            0.229,
            0.222,
            0.209,
            0.176,
            0.162,
            0.154,
            0.153,
            0.133,
            0.170,
            0.182,
            0.188,
            0.278,
        ],
    ),
    Gauge(
        "H2",
        0.992,
        10.0,
        [
            0.001,
            0.099,
            0.140,
            0.179,
            0.201,
            0.236,
            0.321,
            0.287,
            0.289,
            0.281,
            0.230,
            0.203,
            0.199,
            0.202,
            0.178,
            0.135,
            0.161,
            0.145,
            0.260,
            0.252,
            0.221,
            0.218,
            0.226,
        ],
    ),
    Gauge(
        "H3",
        1.488,
        15.0,
        [
            0.050,
            0.095,
            0.129,
            0.155,
            0.157,
            0.145,
            0.131,
            0.142,
            0.297,
            0.270,
            0.234,
            0.238,
            0.210,
            0.186,
            0.169,
            0.174,
            0.165,
            0.270,
            0.249,
            0.205,
            0.214,
            0.219,
            0.212,
        ],
    ),
    Gauge(
        "H4",
        2.638,
        10.0,
        [
            0.500,
            0.426,
            0.347,
            0.279,
            0.223,
            0.182,
            0.153,
            0.130,
            0.115,
            0.104,
            0.177,
            0.202,
            0.211,
            0.197,
            0.325,
            0.332,
            0.256,
            0.260,
            0.269,
            0.233,
            0.218,
            0.218,
            0.195,
        ],
    ),
)
