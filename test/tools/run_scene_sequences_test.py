"""Sequences that run_scene writes: surfaces and particles, read by another program's library."""
import csv
import json
import unittest

import meshio
import numpy

from run_scene_case import RunSceneCase


class Sequences(RunSceneCase):
    def index(self, folder, name):
        return json.loads((self.folder / folder / (name + ".series")).read_text())["files"]

    def test_particles_are_those_of_the_table(self):
        for kind in ("vtk", "ply"):
            out = self.folder / kind
            table = self.folder / "last.csv"
            words = ["--export", out, "--export-format", kind, "--frames-hz", 60]
            result = self.run_scene(self.scene, *words, "--particles", table)
            self.assertEqual(result.returncode, 0, result.stderr)
            files = self.index(kind, "particles." + kind)
            self.assertEqual(
                [f["name"] for f in files], [f"particles_{k:05d}.{kind}" for k in range(6)]
            )
            self.assertAlmostEqual(files[3]["time"], 0.05)
            start = meshio.read(out / files[0]["name"])
            self.assertEqual(start.points.shape, (180, 3))
            with open(table, encoding="utf-8") as rows:
                last = list(csv.DictReader(rows))
            at = self.run_scene(self.scene, *words, "--duration", 0.12)  # a frame longer
            self.assertEqual(at.returncode, 0, at.stderr)
            end = meshio.read(out / "particles_00006.{}".format(kind))
            numpy.testing.assert_allclose(
                end.points, [[float(row[axis]) for axis in "xyz"] for row in last], atol=1e-6
            )
            values = end.point_data
            numpy.testing.assert_allclose(
                numpy.ravel(values["density"]), [float(row["density"]) for row in last], rtol=1e-5
            )

    def test_surfaces_have_an_index_and_replace_those_of_an_earlier_run(self):
        out = self.folder / "surface"
        result = self.run_scene(self.scene, "--surface", out, "--frames-hz", 60)
        if "libopenvdb-dev" in result.stderr:
            self.assertEqual(result.returncode, 1)
            self.skipTest("this build makes no surfaces")
        self.assertEqual(result.returncode, 0, result.stderr)
        files = self.index("surface", "water.ply")
        self.assertEqual(len(files), 6)
        mesh = meshio.read(out / files[0]["name"])
        self.assertGreater(len(mesh.cells_dict["triangle"]), 500)
        self.assertLess(abs(mesh.points[:, 2].max() - 0.3), 0.02)
        self.assertIn("temperature", mesh.point_data)
        tank = meshio.read(out / "colliders.obj")
        self.assertLess(abs(numpy.ptp(tank.points[:, 2]) - 0.4), 0.05)
        result = self.run_scene(self.scene, "--surface", out, "--duration", 0.02)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(
            sorted(f.name for f in out.iterdir()),
            ["colliders.obj", "water.ply.series", "water_00000.ply"],
        )

    def test_surfaces_of_a_scene_with_heat_have_colours(self):
        out = self.folder / "warm"
        result = self.run_scene(
            self.scene,
            "--surface",
            out,
            "--duration",
            0.02,
            "--set",
            "thermal.enabled=true",
            "--set",
            "temperature.initial_c=100",
        )
        if "libopenvdb-dev" in result.stderr:
            self.skipTest("this build makes no surfaces")
        self.assertEqual(result.returncode, 0, result.stderr)
        values = meshio.read(out / "water_00000.ply").point_data
        red, blue = values["red"].astype(int), values["blue"].astype(int)
        self.assertGreater((red - blue).min(), 50)  # boiling water is red

    def test_unknown_formats_are_refused(self):
        self.assertIn(
            "must be vtk or ply",
            self.refused(self.scene, "--export", self.folder / "x", "--export-format", "csv"),
        )
        self.assertIn("cannot make the folder", self.refused(self.scene, "--export", "/proc/x"))


if __name__ == "__main__":
    unittest.main()
