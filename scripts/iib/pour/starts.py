"""Random starts: how full the cup is, where the glass stands, how fast the tap flows."""

import dataclasses
import random

import yaml

from iib.common.paths import ROOT

FILL_ML, TAP_L_MIN = (260.0, 360.0), (4.0, 6.0)
GLASS_M = 0.04  # at most this far from its place in the scene, along x and along y


@dataclasses.dataclass
class Start:
    number: int
    fill_ml: float
    glass_m: tuple  # moved by, x and y
    tap_l_min: float

    def scene(self, name):
        """The text of a scene of config/scenes with this start."""
        scene = yaml.safe_load((ROOT / "config" / "scenes" / f"{name}.yaml").read_text())
        for solid in scene["cups"] + scene["boxes"]:
            if solid["name"] in ("glass", "scale"):
                x, y, z = solid["position_m"]
                solid["position_m"] = [x + self.glass_m[0], y + self.glass_m[1], z]
        scene["sources"][0]["flow_l_min"] = self.tap_l_min
        return yaml.safe_dump(scene, sort_keys=False)


def of_seed(seed, count):
    chance = random.Random(seed)
    return [
        Start(
            number,
            chance.uniform(*FILL_ML),
            tuple(chance.uniform(-GLASS_M, GLASS_M) for _ in range(2)),
            chance.uniform(*TAP_L_MIN),
        )
        for number in range(1, count + 1)
    ]
