"""A small scene in a folder of its own, and run_scene to run it."""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

RUN_SCENE = sys.argv.pop(1)


class RunSceneCase(unittest.TestCase):
    DURATION_S = 0.1
    SCHEDULE = ""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.scene = self.folder / "small.yaml"
        self.scene.write_text(
            f"""name: small
duration_s: {self.DURATION_S}
fluid: {{spacing_m: 0.05}}
blocks: [{{min_m: [-0.15, -0.15, 0.05], max_m: [0.15, 0.15, 0.3]}}]
containers: [{{name: tank, size_m: [0.4, 0.4, 0.4], open_top: false}}]
{self.SCHEDULE}
"""
        )

    def run_scene(self, *words, **environment):
        return subprocess.run(
            [RUN_SCENE, *map(str, words)],
            text=True,
            capture_output=True,
            env={**os.environ, **environment},
            timeout=60,
        )

    def refused(self, *words):
        result = self.run_scene(*words)
        self.assertEqual(result.returncode, 1, f"{words}: {result.stdout}{result.stderr}")
        self.assertEqual(len(result.stderr.strip().splitlines()), 1, result.stderr)
        return result.stderr
