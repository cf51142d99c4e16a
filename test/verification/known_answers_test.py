"""The closed forms against figures that were published or worked out by hand."""
import pathlib
import sys
import unittest

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
from iib.known import answers as known


class KnownAnswers(unittest.TestCase):
    def test_a_step_falls_by_symplectic_euler(self):
        position, velocity, step = 5.0, 2.0, 0.01
        for _ in range(100):
            velocity -= known.GRAVITY_M_S2 * step
            position += velocity * step
        self.assertAlmostEqual(known.symplectic_fall(5.0, 2.0, 1.0, step), position, 12)
        self.assertAlmostEqual(known.symplectic_fall(5.0, 2.0, 1.0, 0.0), known.parabola(5.0, 2.0, 1.0), 12)

    def test_fall_time_is_where_the_parabola_lands(self):
        self.assertAlmostEqual(known.parabola(3.0, 0.0, known.fall_time(3.0)), 0.0, 12)

    def test_the_patch_is_monaghans(self):
        axes = known.elliptical_patch(1.0, [0.25, 0.5, 0.76, 1.0, 2.0])
        np.testing.assert_allclose(axes[:, 0], [1.278, 1.595, 1.945, 2.276, 3.679], atol=6e-4)
        np.testing.assert_allclose(axes[:, 0] * axes[:, 1], 1.0, atol=1e-9)

    def test_the_patch_scales_with_its_rate(self):
        np.testing.assert_allclose(known.elliptical_patch(4.0, [0.25]), known.elliptical_patch(1.0, [1.0]), atol=1e-9)

    def test_measured_dams_run_forwards_and_agree_with_each_other(self):
        for times, fronts in known.MARTIN_MOYCE.values():
            self.assertEqual(len(times), len(fronts))
            self.assertTrue((np.diff(times) > 0).all() and (np.diff(fronts) > 0).all())
        (large, front), (small, other) = known.MARTIN_MOYCE[2, 2.25], known.MARTIN_MOYCE[2, 1.125]
        np.testing.assert_allclose(np.interp(small[1:6], large, front), other[1:6], rtol=0.03)

    def test_waves_of_deep_water_obey_g_over_k(self):
        deep = known.standing_wave_period(0.5, 100.0)
        self.assertAlmostEqual(deep, 2 * np.pi / np.sqrt(known.GRAVITY_M_S2 * np.pi / 0.5), 12)
        self.assertGreater(known.standing_wave_period(0.5, 0.05), deep)

    def test_a_damped_swing_is_found_again(self):
        time = np.linspace(0, 5, 300)
        swing = 0.3 * np.exp(-0.4 * time) * np.sin(2 * np.pi * time / 0.916 + 0.3) + 0.01
        period, decay, amplitude = known.damped_swing(time, swing)
        self.assertAlmostEqual(period, 0.916, 6)
        self.assertAlmostEqual(decay, 0.4, 4)
        self.assertAlmostEqual(amplitude, 0.3, 4)


if __name__ == "__main__":
    unittest.main()
