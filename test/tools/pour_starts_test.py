#!/usr/bin/python3
"""Random starts of scripts/pour: they depend on the seed alone and change what they name."""
import pathlib
import sys
import unittest

import yaml

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
from iib.common.paths import ROOT
from iib.common.refusal import Refusal
from iib.pour import cli, starts


def places(scene):
    return {s["name"]: s["position_m"] for s in scene["cups"] + scene["boxes"]}


class Starts(unittest.TestCase):
    def test_they_depend_on_the_seed_alone(self):
        self.assertEqual(starts.of_seed(3, 5), starts.of_seed(3, 5))
        self.assertEqual(starts.of_seed(3, 5), starts.of_seed(3, 9)[:5])
        self.assertNotEqual(starts.of_seed(3, 5), starts.of_seed(4, 5))

    def test_glass_and_scale_move_together_and_nothing_else_does(self):
        for name in ("pour", "pour_iced"):
            text = (ROOT / "config" / "scenes" / f"{name}.yaml").read_text()
            before = places(yaml.safe_load(text))
            for start in starts.of_seed(1, 20):
                scene = yaml.safe_load(start.scene(name))
                self.assertEqual(scene["sources"][0]["flow_l_min"], start.tap_l_min)
                for solid, (x, y, z) in places(scene).items():
                    dx, dy = start.glass_m if solid in ("glass", "scale") else (0, 0)
                    self.assertEqual([x, y, z], [before[solid][0] + dx, before[solid][1] + dy, z])

    def test_invalid_options_are_refused(self):
        for words in (
            ["--scene", "faucet"],
            ["--starts", "0"],
            ["--only", "21"],
            ["--ml", "1000"],
            ["--sense", "smell"],
            ["--threads", "0"],
        ):
            with self.assertRaises(Refusal, msg=words):
                cli.checked(cli.parser().parse_args(words))


if __name__ == "__main__":
    unittest.main()
