"""Commands of the documents that the test does not run as they stand, and why."""

from fnmatch import fnmatch

# Command or pattern: why it is not run. Its program has to exist and to know its options.
NOT_RUN = {
    "scripts/demo": "installs packages and builds",
    "scripts/test*": "runs all tests, these too",
    "scripts/install_dependencies *": "installs packages",
    "scripts/error_vs_runtime *": "takes minutes",
    "scripts/stability": "takes minutes",
    "scripts/stability *": "takes minutes",
    "scripts/leaks": "takes minutes",
    "scripts/leaks --long": "takes hours",
    "scripts/verify": "takes minutes",
    "scripts/verify --fast *": "takes minutes",
    "scripts/verify --case *_at_rest": "is a test of its own",
    "scripts/verify --case spheric_2_levels*": "is a test of its own, or takes minutes",
    "scripts/check/*": "takes minutes, and needs tools that the machine may lack",
    "*scripts/load/flood --scene small": "takes minutes",
    "scripts/load/carry": "takes minutes",
    "scripts/pour*": "takes minutes",
    "scripts/render *": "needs Blender",
    "rostopic hz *": "runs until Ctrl-C",
    "cmake -*": "builds",
    "ctest -*": "runs other tests",
    "catkin_make *": "needs a catkin workspace",
    "run_scene --defaults > config/default.yaml": "changes the source tree",
    "run_scene dam_break --set fluid.spacing_m=0.015 *": "takes half a minute",
    "run_scene deep_column --threads 1 *": "takes a minute",
    "run_scene dam_break --threads 1 *": "takes half a minute",
    "run_scene pour --set solver.coarse_level=true *": "takes half a minute",
    "run_scene iceberg --threads 2 --duration 6 --profile": "takes half a minute",
}

# Command or pattern: its exit code, if not 0.
EXIT_CODES = {"run_scene container_splash --preset paper --duration 1.5 *": 2}

# Launch files that open rviz, which needs a display.
WITH_RVIZ = ("demo.launch", "replay.launch", "pour.launch")


def reason(text):
    """Why a command is not run, or ""."""
    return next((why for pattern, why in NOT_RUN.items() if fnmatch(text, pattern)), "")
