"""Closed forms of freezing against published figures, and how levels are read."""
import math
import pathlib
import sys
import unittest

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
from iib.known import ice as known_ice


class KnownIce(unittest.TestCase):
    def test_one_phase_is_stefans(self):
        for stefan, constant in ((0.05, 0.156821), (0.2, 0.306424), (1.0, 0.620063)):
            self.assertAlmostEqual(known_ice.alike(stefan).constant(), constant, 6)

    def test_superheat_is_neumanns(self):
        for water_c, constant in ((5.0, 0.469851), (10.0, 0.377760)):
            self.assertAlmostEqual(known_ice.alike(1.0, water_c).constant(), constant, 6)

    def test_real_ice_takes_ten_minutes_for_nine_millimetres(self):
        ice = known_ice.Freezing()
        self.assertAlmostEqual(ice.constant(), 0.17343, 5)
        self.assertAlmostEqual(1e3 * float(ice.front(600.0)), 9.23, 2)
        self.assertAlmostEqual(ice.time(ice.front(600.0)), 600.0, 6)

    def test_lifted_water_satisfies_the_balance_at_the_front(self):
        """The similarity solution in its own equations, by differences, at another density."""
        ice = known_ice.alike(1.0, 5.0, 917.0)
        ratio, time = 0.917, 1000.0
        front, alpha = float(ice.front(time)), 2.0 / (1000.0 * 2000.0)
        reach = 2.0 * math.sqrt(alpha * time)
        shift = (1.0 - ratio) * front / reach

        def water_c(x):
            return 5.0 * (1.0 - math.erfc(x / reach - shift) / math.erfc(front / reach - shift))

        def ice_c(x):
            own = 2.0 * math.sqrt(ice.diffusivity_m2_s() * time)
            return -10.0 + 10.0 * math.erf(x / own) / math.erf(front / own)

        step = 1e-6 * front
        into = 2.0 * (ice_c(front) - ice_c(front - step)) / step - 2.0 * (water_c(front + step) - water_c(front)) / step
        self.assertAlmostEqual(into / (917.0 * ice.latent_heat_fusion_j_kg * front / (2.0 * time)), 1.0, 4)

    def test_a_lattice_stands_as_high_as_its_cells(self):
        heights = np.repeat((np.arange(15) + 0.5) * 0.02, 400)
        self.assertAlmostEqual(known_ice.level(heights, 0.02), 0.3, 3)
        shaken = heights + np.random.default_rng(0).uniform(-0.01, 0.01, heights.size)
        self.assertAlmostEqual(known_ice.level(shaken, 0.02), 0.3, 3)

    def test_half_a_cube_is_below_its_middle(self):
        heights = np.repeat((np.arange(10) + 0.5) * 0.02, 100)
        self.assertAlmostEqual(known_ice.below(heights, 0.1, 0.02), 0.5, 12)
        self.assertAlmostEqual(known_ice.below(heights, 0.055, 0.02), 0.275, 12)


if __name__ == "__main__":
    unittest.main()
