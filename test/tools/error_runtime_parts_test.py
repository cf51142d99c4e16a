"""The parts of error_vs_runtime: grids, fronts, tables, choices, distances, labels, the bar."""
import pathlib
import sys
import unittest
import unittest.mock

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
from iib.common import machine, progress
from iib.common.refusal import Refusal
from iib.error_runtime import choices, grid, labels, pareto, points, runner, trajectory


class Machine(unittest.TestCase):
    def test_needs_no_git(self):
        with unittest.mock.patch.dict("os.environ", PATH=""):
            self.assertEqual(machine.commit(), "unknown")


class Grid(unittest.TestCase):
    def test_is_the_product_of_its_axes(self):
        axes = grid.parse_grid({"substeps": "2,4", "iterations": None}, ["solver.epsilon=0.1,1e-2"])
        self.assertEqual(axes, {"solver.substeps": ["2", "4"], "solver.epsilon": ["0.1", "0.01"]})
        expanded = grid.expand(axes)
        self.assertEqual(len(expanded), 4)
        self.assertEqual(expanded[1], {"solver.substeps": "2", "solver.epsilon": "0.01"})
        self.assertEqual(grid.expand({}), [{}])

    def test_takes_each_number_once_however_it_is_written(self):
        self.assertEqual(grid.parse_axis("k", "0.5,.50,5e-1,1,1.0"), ["0.5", "1"])

    def test_leaves_brackets_whole(self):
        self.assertEqual(grid.split_values("[0, 0, -9],[0, 0, 0]"), ["[0, 0, -9]", "[0, 0, 0]"])

    def test_knows_shorthands_as_keys_too(self):
        self.assertEqual(grid.parse_grid({}, ["warm-start=0,0.5"]), {"solver.warm_start": ["0", "0.5"]})

    def test_refuses_what_is_no_grid(self):
        for texts, clue in ((["solver.substeps"], "key=v1"), (["k="], "empty value"), (["k=1,,2"], "empty"),
                            (["k=1", "k=2"], "twice"), (["threads=0"], "1 to 1024"),
                            (["precision=half"], "float or double")):
            with self.subTest(texts=texts), self.assertRaisesRegex(Refusal, clue):
                grid.parse_grid({}, texts)


class Front(unittest.TestCase):
    def test_has_the_points_that_nothing_beats(self):
        known = [(1, 8), (2, 4), (3, 5), (4, 2), (4, 3), (5, 2), None, (0.5, 9)]
        self.assertEqual(pareto.front(known), [7, 0, 1, 3])

    def test_of_equal_points_has_the_first(self):
        self.assertEqual(pareto.front([(1, 1), (1, 1)]), [0])

    def test_of_nothing_is_empty(self):
        self.assertEqual(pareto.front([]), [])
        self.assertEqual(pareto.front([None]), [])


class Points(unittest.TestCase):
    def run_of(self, wall, status="ok", **point):
        report = {"particles": 100, "simulated_time_s": 2.0, "wall_time_s": wall, "state_hash": "",
                  "error": {"density_mean": 0.01}, "rms_speed_m_s": 0, "residual_speed_m_s": 0,
                  "max_speed_m_s": 0, "settings": {"solver": {"substeps": 8}}, "threads": 2}
        return {"point": point, "status": status, "message": "", "report": report}

    def test_medians_and_spread(self):
        row, = points.table([self.run_of(wall) for wall in (4.0, 2.0, 9.0)])
        self.assertEqual((row["repeats"], row["wall_s_per_s"]), (3, 2.0))
        self.assertEqual((row["wall_s_per_s_min"], row["wall_s_per_s_max"]), (1.0, 4.5))
        self.assertEqual(row["us_per_particle_per_s"], 20000.0)

    def test_an_unstable_run_makes_an_unstable_point_that_is_never_on_the_front(self):
        rows = points.table([self.run_of(2.0, a="1"), self.run_of(1.0, "unstable", a="2")])
        self.assertEqual([row["status"] for row in rows], ["ok", "unstable"])
        self.assertEqual([row["on_front"] for row in rows], [1, 0])

    def test_a_refused_point_stays(self):
        refused = {"point": {"a": "1"}, "status": "refused", "message": "no"}
        row, = points.table([refused])
        self.assertEqual((row["status"], row["message"], row["on_front"]), ("refused", "no", 0))

    def test_an_axis_that_a_point_does_not_set_shows_what_was_in_force(self):
        rows = points.table([self.run_of(1.0), self.run_of(1.0, **{"solver.substeps": "4"})])
        self.assertEqual([row["solver.substeps"] for row in rows], [8, "4"])

    def test_runs_to_do_come_in_rounds_and_failures_once(self):
        a, b = {"k": "1"}, {"k": "2"}
        self.assertEqual(runner.pending([a, b], 2, []), [a, b, a, b])
        done = [{"point": a, "status": "ok"}, {"point": b, "status": "unstable"}]
        self.assertEqual(runner.pending([a, b], 2, done), [a])


class Choices(unittest.TestCase):
    def row(self, substeps, cost, mean, largest, status="ok"):
        return {"solver.substeps": substeps, "us_per_particle_per_s": cost, "density_mean": mean,
                "density_max": largest, "status": status}

    def setUp(self):
        self.dam = [self.row("2", 20, 0.03, 0.2), self.row("8", 80, 0.002, 0.02), self.row("16", 160, 1e-4, 0.01)]
        self.pool = [self.row("2", 30, 0.1, 0.9), self.row("8", 70, 0.01, 0.1),
                     self.row("16", 150, 1e-3, 0.02, "unstable")]
        self.settings = choices.joined([self.dam, self.pool], ["solver.substeps"])

    def test_a_setting_is_judged_by_its_worst_scene(self):
        self.assertEqual([s["keys"]["solver.substeps"] for s in self.settings], ["2", "8"])
        self.assertEqual([(s["cost"], s["error"], s["largest"]) for s in self.settings],
                         [(30, 0.1, 0.9), (80, 0.01, 0.1)])

    def test_more_particles_afford_less(self):
        self.assertEqual(choices.for_count(self.settings, 12_500)["keys"], {"solver.substeps": "8"})
        self.assertEqual(choices.for_count(self.settings, 12_501)["keys"], {"solver.substeps": "2"})
        self.assertIsNone(choices.for_count(self.settings, 50_000))
        self.assertEqual(choices.most_particles(self.settings[0]), 33_000)

    def test_the_cheapest_setting_that_is_accurate_enough(self):
        self.assertEqual(choices.for_target(self.settings, 0.1)["cost"], 30)
        self.assertEqual(choices.for_target(self.settings, 0.05)["cost"], 80)
        self.assertIsNone(choices.for_target(self.settings, 0.001))

    def test_peers_are_met_in_the_mean_and_the_largest_error(self):
        peer = {"us_per_particle_per_s": 800, "mean_error_percent": 0.2, "max_error_percent": 2}
        (_, best, ratio), = choices.against_peers(self.dam, [peer])
        self.assertEqual((best["solver.substeps"], ratio), ("8", 10))
        peer["max_error_percent"] = 1.5
        self.assertEqual(choices.against_peers(self.dam, [peer])[0][2], 5)
        peer["max_error_percent"] = 0.5
        self.assertIsNone(choices.against_peers(self.dam, [peer])[0][1])

    def test_water_that_boils_is_no_choice(self):
        self.dam[1]["energy_rise"] = 0.03
        self.pool[1]["energy_rise"] = 0.001
        settings = choices.sound(choices.joined([self.dam, self.pool], ["solver.substeps"]))
        self.assertEqual([s["keys"]["solver.substeps"] for s in settings], ["2"])

    def test_a_setting_can_be_pasted(self):
        self.assertEqual(choices.overrides({"solver.substeps": "8", "threads": "2"}),
                         "--set solver.substeps=8 --threads 2")


class Terminal:
    """A stream that says it is a terminal and keeps what is written."""

    def __init__(self, terminal):
        self.terminal, self.text = terminal, ""

    def isatty(self):
        return self.terminal

    def write(self, text):
        self.text += text

    def flush(self):
        pass


class Bar(unittest.TestCase):
    def test_foretells_each_run_by_the_same_point_before(self):
        screen = Terminal(True)
        bar = progress.Progress(["a", "b", "a", "b"], screen)
        self.assertIsNone(bar.seconds_left())
        bar.end("a", 10)
        bar.end("b", 100)
        self.assertEqual(bar.seconds_left(), 110)
        bar.end("a", 20)
        self.assertEqual(bar.seconds_left(), 100)
        self.assertIn("75%|", screen.text)
        self.assertIn("3/4", screen.text)
        self.assertIn("<1:40]", screen.text)

    def test_is_silent_in_a_pipe(self):
        screen = Terminal(False)
        bar = progress.Progress(["a"], screen)
        bar.end("a", 1)
        bar.close()
        self.assertEqual(screen.text, "")


class Trajectory(unittest.TestCase):
    def test_distance_is_in_spacings_and_time_is_when_it_is_passed(self):
        import numpy

        reference = numpy.zeros((4, 2, 3), "f4")
        record = reference.copy()
        record[:, :, 2] = numpy.array([0, 0.05, 0.2, 0.1])[:, None]
        apart = trajectory.distances(record, reference, 0.1)
        self.assertTrue(numpy.allclose(apart, [0, 0.5, 2, 1]))
        self.assertAlmostEqual(trajectory.time_within(apart, 10), 0.2)
        self.assertAlmostEqual(trajectory.time_within(apart, 10, limit=9), 0.3)


class Labels(unittest.TestCase):
    def test_cover_neither_each_other_nor_points(self):
        spots = [(50 + 9 * (k % 4), 50 + 9 * (k // 4)) for k in range(12)]
        boxes = labels.place(spots, [(14, 9)] * 12, (0, 0, 300, 300))
        for k, box in enumerate(boxes):
            for other in boxes[:k]:
                self.assertEqual(labels.overlap(box, other), 0)
            for x, y in spots:
                self.assertEqual(labels.overlap(box, (x - 4, y - 4, x + 4, y + 4)), 0)


if __name__ == "__main__":
    unittest.main()
