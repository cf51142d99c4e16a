"""Cases that a scene file cannot express: figures of a test program, for the same table."""

import json
import pathlib
import subprocess

from iib.common import processes
from iib.common.checks import at_most
from iib.common.refusal import Refusal

from iib.stability.cases import Measured

WHOLE = ("particles", "substeps", "non_finite", "escaped", "speed_limited")
REAL = (
    "simulated_s",
    "fastest_m_s",
    "density_error_mean",
    "density_error_max",
    "energy_rise",
    "wall_s",
)


def find_program(run_scene, given=None):
    """The given one, or that of the build folder in which run_scene lies."""
    if given is not None:
        if not pathlib.Path(given).is_file():
            raise Refusal(f"--commands {given} is no program; build the target stability_test")
        return pathlib.Path(given)
    for folder in pathlib.Path(run_scene).resolve().parents:
        if (folder / "CMakeCache.txt").exists():
            built = sorted(folder.glob("**/stability_test"))
            if built:
                return built[0]
            raise Refusal(
                f"no stability_test in {folder}; build it: ninja -C {folder} stability_test"
            )
    raise Refusal(f"{run_scene} lies in no build folder; name the program of commands: --commands")


def measure(program, out, names=()):
    """Lines of the table. names: only these tests."""
    path = pathlib.Path(out) / "commands.json"
    path.unlink(missing_ok=True)
    chosen = ":".join(f"*.{name}" for name in names) or "*"
    command = [str(program), f"--gtest_filter={chosen}", f"--gtest_output=json:{path}"]
    done = subprocess.run(command, capture_output=True, text=True)
    if not path.exists():
        raise Refusal(
            f"{program} ended by {done.returncode} and printed nothing: "
            + done.stderr.strip()[-300:]
        )
    suites = json.loads(path.read_text())["testsuites"]
    return [line(test) for suite in suites for test in suite["testsuite"]]


def listed(program):
    text = processes.run([program, "--gtest_list_tests"])
    return [row.strip() for row in text.splitlines() if row.startswith("  ")]


def text_of(escaped):
    """googletest escapes every byte of UTF-8 by itself."""
    return escaped.encode("latin-1").decode("utf-8")


def line(test):
    failures = test.get("failures", [])
    check = at_most("expectations that do not hold", len(failures), 0)
    measured = Measured(
        test["name"],
        int(test["number"]),
        text_of(test["title"]),
        text_of(test["expected"]),
        [check],
    )
    for name in WHOLE:
        setattr(measured, name, int(float(test.get(name, 0))))
    for name in REAL:
        setattr(measured, name, float(test.get(name, "nan")))
    measured.commands = [f"stability_test --gtest_filter=*.{test['name']}"]
    measured.commands += [failure["failure"].splitlines()[0] for failure in failures]
    return measured
