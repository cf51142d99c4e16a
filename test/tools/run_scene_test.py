"""Contract of run_scene: exit codes, one clear line for bad input, the report, the pictures."""
import csv
import json
import unittest

import numpy

from run_scene_case import RunSceneCase

KEYS = """scene particles springs simulated_time_s wall_time_s steps density_error_mean
density_error_max kinetic_energy_j max_speed_m_s escaped non_finite state_hash threads precision
stages""".split()


class RunScene(RunSceneCase):
    def report(self, *words):
        path = self.folder / "report.json"
        result = self.run_scene(self.scene, "--report", path, *words)
        self.assertEqual(result.returncode, 0, result.stderr)
        return json.loads(path.read_text())

    def test_a_run_is_quiet_but_for_its_summary(self):
        result = self.run_scene(self.scene)
        self.assertEqual(result.returncode, 0)
        self.assertEqual(result.stderr, "")
        self.assertEqual(len(result.stdout.splitlines()), 1, "no progress bar in a pipe")
        self.assertNotIn("\r", result.stdout)
        self.assertIn("180 particles", result.stdout)

    def test_report_has_every_key_and_adds_up(self):
        report = self.report("--threads", 2, "--precision", "double")
        for key in KEYS:
            self.assertIn(key, report)
        self.assertEqual(report["scene"], "small")
        self.assertEqual(report["particles"], 180)
        self.assertEqual(report["springs"], 0)
        self.assertEqual(report["threads"], 2)
        self.assertEqual(report["precision"], "double")
        self.assertAlmostEqual(report["simulated_time_s"], 0.1)
        self.assertEqual(report["steps"], 30)
        self.assertEqual((report["escaped"], report["non_finite"]), (0, 0))
        self.assertRegex(report["state_hash"], "^[0-9a-f]{16}$")
        for stage in report["stages"]:
            self.assertEqual(set(stage), {"name", "calls", "time_s", "bytes"})
        calls = {stage["name"]: stage["calls"] for stage in report["stages"]}
        self.assertEqual(calls["predict"], 30)
        self.assertNotIn("make_springs", calls)

    def test_same_bits_for_any_number_of_threads(self):
        hashes = {self.report("--threads", n)["state_hash"] for n in (1, 2, 4)}
        self.assertEqual(len(hashes), 1)
        self.assertNotIn(self.report("--set", "solver.substeps=9")["state_hash"], hashes)

    def test_preset_duration_and_overrides_hold(self):
        report = self.report(
            "--duration",
            0.05,
            "--preset",
            "paper",
            "--set",
            "solver.substeps=2",
            "--set",
            "temperature.initial_c=-5",
        )
        self.assertEqual(report["preset"], "paper")
        self.assertEqual(report["steps"], 6)
        self.assertGreater(report["springs"], 0)

    def test_bad_input_is_one_line_that_says_what(self):
        cases = [
            (["no_such_scene"], "no_such_scene"),
            (["dam_brake"], "did you mean dam_break"),
            ([], "name a scene"),
            ([self.folder / "none.yaml"], "none.yaml"),
            ([self.scene, "--set", "solver.iteration=3"], "solver.iterations"),
            ([self.scene, "--set", "solver.iterations"], "key=value"),
            ([self.scene, "--set", "solver.iterations=x"], "must be a number"),
            ([self.scene, "--set", "solver.substeps=-1"], "[0, 1000]"),
            ([self.scene, "--precision", "half"], "float or double"),
            ([self.scene, "--preset", "fast"], "default, paper"),
            ([self.scene, "--quality", "best"], "fast, balanced, accurate"),
            ([self.scene, "--threads", "-1"], "threads"),
            ([self.scene, "--duration", "nan"], "--duration"),
            ([self.scene, "--duration", "-3"], "--duration"),
            ([self.scene, "--frames-hz", "0"], "--frames-hz"),
            ([self.scene, "--sample-hz", "-1"], "--sample-hz"),
            ([self.scene, "--report", self.folder / "no" / "r.json"], "report"),
            ([self.scene, "--series", self.folder / "no" / "s.csv"], "series"),
            ([self.scene, "--particles", self.folder / "no" / "p.csv"], "particles"),
            ([self.scene, "--record", self.folder / "no" / "r.npy"], "record"),
            ([self.scene, "--frames", self.scene], "small.yaml"),
            (
                [
                    self.scene,
                    "--record",
                    self.folder / "r.npy",
                    "--duration",
                    "1e6",
                    "--set",
                    "solver.frame_rate_hz=10000",
                ],
                "MB free; lower --sample-hz or --duration",
            ),
            (
                [self.scene, "--frames", self.folder, "--duration", "1e6"],
                "3e+07 files, more than 1e+05",
            ),
            (["/dev/zero"], "device or a pipe"),
            ([self.folder], "is a folder"),
        ]
        for words, clue in cases:
            with self.subTest(words=words):
                self.assertIn(clue, self.refused(*words))

    def test_options_that_do_not_exist_are_bad_input(self):
        for words in (["--nonsense"], ["--threads", "many"], ["--duration"]):
            error = self.refused(self.scene, *words)
            self.assertTrue(error.startswith("run_scene: "), error)
            self.assertIn("--help", error)

    def test_what_becomes_unstable_has_its_own_exit_code(self):
        result = self.run_scene(self.scene, "--set", "solver.max_speed_m_s=0.01")
        self.assertEqual(result.returncode, 2)
        self.assertIn("unstable", result.stderr)

    def test_corrections_that_were_cut_are_warned_of_once_they_are_many(self):
        cut = self.run_scene(
            self.scene, "--set", "solver.max_correction_h=0.001", "--set", "solver.substeps=1"
        )
        self.assertEqual(cut.returncode, 0, cut.stderr)
        self.assertIn("solver.max_correction_h = 0.001 cut ", cut.stderr)
        self.assertIn("raise solver.substeps", cut.stderr)
        self.assertEqual(cut.stderr.count("cut"), 1, cut.stderr)
        few = self.report("--set", "solver.max_correction_h=0.05")
        self.assertLessEqual(few["correction_limited"], 0.01 * 180 * few["steps"])
        self.assertEqual(
            self.run_scene(self.scene, "--set", "solver.max_correction_h=0.05").stderr, ""
        )

    def test_pictures_are_png(self):
        pictures = self.folder / "pictures"
        result = self.run_scene(self.scene, "--frames", pictures, "--frames-hz", 30)
        self.assertEqual(result.returncode, 0, result.stderr)
        files = sorted(pictures.iterdir())
        self.assertEqual(len(files), 3)
        for file in files:
            self.assertEqual(file.read_bytes()[:8], b"\x89PNG\r\n\x1a\n")

    def test_pictures_replace_those_of_an_earlier_run_and_nothing_else(self):
        pictures = self.folder / "pictures"
        pictures.mkdir()
        for name in ("frame_00099.png", "frame_mine.png", "frame_000999.png"):
            (pictures / name).write_text("old")
        result = self.run_scene(self.scene, "--frames", pictures, "--duration", "0.01")
        self.assertEqual(result.returncode, 0, result.stderr)
        names = {file.name for file in pictures.iterdir()}
        self.assertEqual(names, {"frame_00000.png", "frame_mine.png", "frame_000999.png"})

    def table(self, option, *words):
        path = self.folder / "table.csv"
        result = self.run_scene(self.scene, option, path, *words)
        self.assertEqual(result.returncode, 0, result.stderr)
        with path.open(newline="") as file:
            return [
                {name: float(value) for name, value in row.items()} for row in csv.DictReader(file)
            ]

    def test_series_has_the_start_and_every_frame(self):
        rows = self.table("--series")
        self.assertEqual(len(rows), 7)
        self.assertEqual(
            (rows[0]["time_s"], rows[0]["wall_s"], rows[0]["rms_speed_m_s"]), (0, 0, 0)
        )
        self.assertAlmostEqual(rows[-1]["time_s"], 0.1)
        for row in rows[1:]:
            self.assertGreater(row["wall_s"], 0)
            self.assertAlmostEqual(
                row["total_energy_j"],
                row["kinetic_energy_j"] + row["potential_energy_j"] + row["elastic_energy_j"],
            )
        for name in (
            "density_error_mean",
            "own_density_error_max",
            "temperature_c",
            "strictness",
            "springs",
        ):
            self.assertIn(name, rows[0])

    def test_wrenches_are_reported_if_asked_for(self):
        self.assertNotIn("wrenches", self.report())
        tank = self.report("--wrenches", "--duration", "2")["wrenches"]["tank"]
        weight_n = 180 * 0.05**3 * 1000 * 9.81
        self.assertAlmostEqual(tank["force_n"][2], -weight_n, delta=0.02 * weight_n)
        self.assertEqual(len(tank["torque_n_m"]), 3)

    def test_the_series_has_the_wrench_since_the_row_before(self):
        """Summed over the fall and the splash, force and weight are the change of momentum."""
        self.assertNotIn("tank.force_z_n", self.table("--series")[0])
        options = ("--wrenches", "--sample-hz", "30", "--duration", "1")
        rows = self.table("--series", *options)
        first, last = rows[0], rows[-1]
        self.assertEqual(first["tank.force_z_n"], 0)
        weight_n = 180 * 0.05**3 * 1000 * 9.81
        given_n_s = sum(row["tank.force_z_n"] for row in rows) / 30
        lost = last["momentum_z_kg_m_s"] - first["momentum_z_kg_m_s"]
        self.assertAlmostEqual(-given_n_s - weight_n * 1, lost, delta=0.01 * weight_n)
        self.assertLess(max(abs(row["tank.force_x_n"]) for row in rows), 0.2 * weight_n)

    def test_report_and_series_have_what_each_vessel_holds(self):
        gauges = ("--set", "gauges=[{name: low, position_m: [0, 0, 0.1], size_m: [1, 1, 0.2]}]")
        vessels = self.report(*gauges)["vessels"]
        self.assertEqual(list(vessels), ["tank", "low"])
        tank, low = vessels["tank"], vessels["low"]
        self.assertEqual(tank["particles"], 180)
        self.assertAlmostEqual(tank["water_m3"], 180 * 0.05**3)
        self.assertAlmostEqual(tank["level_m"], 180 * 0.05**3 / 0.16)
        self.assertEqual((tank["ice_m3"], tank["mean_celsius"]), (0, None))
        self.assertGreater(low["entered_m3"], 0)  # the block falls
        self.assertAlmostEqual(
            low["water_m3"] - 108 * 0.05**3, low["entered_m3"] - low["left_m3"]
        )
        row = self.table("--series", *gauges)[-1]
        self.assertAlmostEqual(row["tank.water_m3"], tank["water_m3"])
        self.assertAlmostEqual(row["low.level_m"], low["level_m"])
        without = self.report("--set", "containers=[]")
        self.assertNotIn("vessels", without)

    def test_samples_thin_series_and_record(self):
        record = self.folder / "record.npy"
        rows = self.table("--series", "--sample-hz", 20, "--record", record)
        self.assertEqual(
            [round(row["time_s"], 6) for row in rows], [0, 0.05, 0.1], "every third frame"
        )
        self.assertEqual(len(numpy.load(record)), 3)
        self.assertGreater(rows[1]["resident_bytes"], 1e6)
        odd = self.table("--series", "--sample-hz", 15)
        self.assertEqual(
            [round(60 * row["time_s"]) for row in odd], [0, 4, 6], "the last frame always"
        )

    def test_the_fastest_of_all_frames_is_told(self):
        report = self.report()
        fastest = max(row["max_speed_m_s"] for row in self.table("--series"))
        self.assertAlmostEqual(report["fastest_m_s"], fastest)
        self.assertGreater(report["peak_resident_bytes"], 1e6)

    def test_series_knows_where_the_water_is_and_how_it_falls(self):
        rows = self.table("--series")
        start, end = rows[0], rows[-1]
        for axis, low, high in (("x", -0.125, 0.125), ("y", -0.125, 0.125), ("z", 0.075, 0.275)):
            self.assertAlmostEqual(start[f"min_{axis}_m"], low, 6)
            self.assertAlmostEqual(start[f"max_{axis}_m"], high, 6)
            self.assertAlmostEqual(start[f"mean_{axis}_m"], (low + high) / 2, 6)
        self.assertAlmostEqual(start["rms_x_m"], 0.05 * (35 / 12) ** 0.5, 6)  # of 6 places
        mass_kg = start["potential_energy_j"] / (9.81 * start["mean_z_m"])
        in_free_fall = rows[3]  # before the floor is reached
        self.assertAlmostEqual(in_free_fall["momentum_z_kg_m_s"] / mass_kg, -9.81 * 0.05, 4)
        self.assertAlmostEqual(in_free_fall["momentum_x_kg_m_s"] / mass_kg, 0, 4)
        self.assertAlmostEqual(in_free_fall["angular_momentum_y_kg_m2_s"] / mass_kg, 0, 4)
        self.assertLess(end["mean_z_m"], start["mean_z_m"])

    def test_particles_are_those_of_the_last_frame_by_id(self):
        rows = self.table("--particles", "--duration", 0.05)
        self.assertEqual([row["id"] for row in rows], list(range(180)))
        for row in rows:
            self.assertAlmostEqual(row["vz"], -9.81 * 0.05, 3)
            self.assertGreater(row["density"], 0)
        self.assertAlmostEqual(rows[0]["x"], -0.125, 5)

    def test_record_has_every_position_of_every_frame(self):
        path = self.folder / "record.npy"
        result = self.run_scene(self.scene, "--record", path)
        self.assertEqual(result.returncode, 0, result.stderr)
        record = numpy.load(path)
        self.assertEqual((record.shape, record.dtype), ((7, 180, 3), numpy.float32))
        self.assertTrue(numpy.allclose(record[0, 0], [-0.125, -0.125, 0.075]))
        last = numpy.array([[row["x"], row["y"], row["z"]] for row in self.table("--particles")])
        self.assertTrue(numpy.allclose(record[-1], last))

    def test_water_with_nothing_below_it_leaves_the_bounds_and_the_run_ends_well(self):
        record = self.folder / "record.npy"
        falls = ("--set", "containers=[]")
        bounds = ("--set", "bounds.min_m=[-1, -1, 0]")
        report = self.report(*falls, *bounds, "--duration", 0.5, "--record", record)
        self.assertEqual((report["particles"], report["spilled"]), (0, 180))
        self.assertLess(report["error"]["energy_rise"], 1e-3)
        positions = numpy.load(record)
        self.assertEqual(positions.shape, (31, 180, 3))
        gone = numpy.isnan(positions).all(axis=2)
        self.assertTrue((gone == numpy.isnan(positions).any(axis=2)).all())
        self.assertTrue((gone[1:] >= gone[:-1]).all(), "nothing returns")
        self.assertEqual(sorted(set(gone.sum(axis=1))), [0, 36, 72, 108, 144, 180], "by layers")
        self.assertTrue((gone[:, :36] >= gone[:, -36:]).all(), "the lowest layer first")

    def test_water_in_free_fall_leaves_the_default_bounds_before_the_speed_limit(self):
        report = self.report("--set", "containers=[]", "--duration", 3.2, "--sample-hz", 5)
        self.assertEqual((report["particles"], report["spilled"]), (0, 180))
        self.assertEqual(report["speed_limited"], 0)

    def test_report_has_the_faces_that_the_scene_has_and_the_settings_in_force(self):
        report = self.report("--set", "solver.substeps=5")
        metrics = report["error"]
        self.assertLessEqual(
            {
                "density_mean",
                "density_max",
                "own_density_mean",
                "own_density_max",
                "volume_lost",
                "energy_drift",
                "energy_rise",
            },
            set(metrics),
        )
        self.assertNotIn("column_height_m", metrics, "the block falls")
        self.assertNotIn("ice_drift_spacings", metrics, "water only")
        self.assertAlmostEqual(metrics["density_mean"], report["density_error_mean"])
        self.assertEqual(report["settings"]["solver"]["substeps"], 5)
        self.assertEqual(report["settings"]["fluid"]["kernel"], "cubic")

    def test_profile_shows_the_stages(self):
        result = self.run_scene(self.scene, "--profile")
        self.assertIn("neighbours", result.stdout)
        self.assertIn("us/call", result.stdout)

    def test_help_has_examples_and_exit_codes(self):
        result = self.run_scene("--help")
        self.assertEqual(result.returncode, 0)
        self.assertIn("Examples:", result.stdout)
        self.assertIn("run_scene dam_break", result.stdout)
        self.assertIn("Exit code", result.stdout)

    def test_list_names_the_scenes_and_defaults_the_keys(self):
        self.assertIn("dam_break", self.run_scene("--list").stdout)
        self.assertIn("quality: balanced", self.run_scene("--defaults").stdout)
        result = self.run_scene("--list", ICE_ICE_BABY_SCENES=str(self.folder))
        self.assertEqual(result.stdout.split()[0], "small")

    def test_a_broken_scene_is_named_and_the_others_listed(self):
        (self.folder / "broken.yaml").write_text("name: a\nname: b\n")
        result = self.run_scene("--list", ICE_ICE_BABY_SCENES=str(self.folder))
        self.assertEqual(result.returncode, 1)
        self.assertEqual(result.stdout.split()[0], "small")
        self.assertIn("broken: key name stands twice", result.stderr)

    def test_a_scene_without_water_runs_and_says_so(self):
        self.scene.write_text("duration_s: 0.02\n")
        result = self.run_scene(self.scene)
        self.assertEqual(result.returncode, 0)
        self.assertIn("holds no water", result.stderr)


if __name__ == "__main__":
    unittest.main()
