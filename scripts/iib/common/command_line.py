"""Command lines: options, bad input in one line, exit codes."""

import argparse
import sys

from iib.common.refusal import Refusal


class Parser(argparse.ArgumentParser):
    """Raises a Refusal for bad input. description and epilog are printed as they are written."""

    def __init__(self, prog, description, **options):
        super().__init__(
            prog=prog,
            description=description,
            formatter_class=argparse.RawDescriptionHelpFormatter,
            allow_abbrev=False,
            **options,
        )

    def error(self, message):
        raise Refusal(f"{message}; --help shows the options")

    def add_run_scene(self):
        """--run-scene, for run_scene.find_run_scene."""
        self.add_argument(
            "--run-scene", metavar="PATH", help="program (default: the newest in the build folders)"
        )


def exit_code(prog, run, stopped="stopped"):
    """Runs `run(words)` with the words of the command line.

    Returns its exit code; 1 after a Refusal, 130 after Ctrl-C, each with one line on stderr.
    """
    try:
        return run(sys.argv[1:]) or 0
    except Refusal as refusal:
        print(f"{prog}: {refusal}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print(f"{prog}: {stopped}", file=sys.stderr)
        return 130
