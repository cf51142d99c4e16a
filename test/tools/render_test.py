#!/usr/bin/python3
"""scripts/render: what it refuses, and a picture where Blender is installed."""
import pathlib
import shutil
import sys
import tempfile
import unittest

RUN_SCENE = sys.argv.pop(1)

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
from iib.common.refusal import Refusal
from iib.render import cli

SCENE = """name: drop
fluid: {spacing_m: 0.05}
blocks: [{min_m: [-0.1, -0.1, 0], max_m: [0.1, 0.1, 0.2]}]
containers: [{name: tank, size_m: [0.4, 0.4, 0.4]}]
solids: [{name: box, size_m: [0.1, 0.1, 0.1], position_m: [0, 0, 0.3], density_kg_m3: 500}]
"""


class Render(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.scene = self.folder / "drop.yaml"
        self.scene.write_text(SCENE)

    def refusal(self, *words):
        with self.assertRaises(Refusal) as caught:
            cli.run([str(self.scene), "--output", str(self.folder / "a.png"), *words])
        return str(caught.exception)

    def test_bad_input_is_refused_before_anything_runs(self):
        self.assertIn("must be WIDTHxHEIGHT", self.refusal("--size", "big"))
        self.assertIn("--size = 3 is outside", self.refusal("--size", "640x3"))
        self.assertIn("--samples = 0 is outside", self.refusal("--samples", "0"))
        self.assertIn("--fps = 0 is outside", self.refusal("--film", "--fps", "0"))
        self.assertIn("there is no folder", self.refusal("--output", "/no/such/folder/a.png"))

    @unittest.skipUnless(shutil.which("blender"), "Blender is not installed")
    def test_a_still_and_a_film(self):
        words = [str(self.scene), "--size", "32x24", "--samples", "1", "--run-scene", RUN_SCENE]
        still, film = self.folder / "a.png", self.folder / "a.mp4"
        cli.run([*words, "--at", "0.1", "--output", str(still)])
        self.assertGreater(still.stat().st_size, 500)
        cli.run([*words, "--film", "--seconds", "0.1", "--output", str(film)])
        self.assertGreater(film.stat().st_size, 500)


if __name__ == "__main__":
    unittest.main()
