"""The command line of scripts/pour."""

from iib.common.command_line import Parser, exit_code
from iib.common.markdown import heading, row
from iib.common.refusal import Refusal
from iib.pour import starts

DESCRIPTION = """Lets the arm of examples/pour pour 200 ml of water from random starts.

Starts a master, a node and the arm of its own, in simulated time and as fast as possible. Prints a
row of a table for each start. The fill of the cup, the place of the glass and the flow of the tap
are random. Meaning and figures: doc/robots.md.

Examples:
  scripts/pour                             # 20 starts
  scripts/pour --starts 3 --seed 7
  scripts/pour --scene pour_iced

Exit code: 0 every start poured within 2 % and spilled nothing, 1 not, or bad input.
"""
COLUMNS = {
    "poured ml": ("poured_ml", "%.1f"),
    "error %": ("error_percent", "%+.1f"),
    "spilled particles": ("spilled_particles", "%d"),
    "wrist g": ("wrist_g", "%+.1f"),
    "scale g": ("scale_g", "%+.1f"),
    "simulated s": ("simulated_s", "%.1f"),
    "real-time factor": ("real_time_factor", "%.2f"),
}


def parser():
    p = Parser("scripts/pour", DESCRIPTION)
    p.add_argument("--scene", default="pour", help="pour or pour_iced (pour)")
    p.add_argument("--starts", type=int, default=20, help="number of starts (20)")
    p.add_argument("--only", type=int, help="this one of them alone")
    p.add_argument("--seed", type=int, default=1, help="of the random starts (1)")
    p.add_argument("--ml", type=float, default=200.0, help="volume to pour (200)")
    p.add_argument(
        "--sense", default="vessels", help="vessels or wrist: what the arm pours by (vessels)"
    )
    p.add_argument("--threads", type=int, default=2, help="of the solver (2)")
    return p


def checked(args):
    if args.scene not in ("pour", "pour_iced"):
        raise Refusal(f"--scene {args.scene} is neither pour nor pour_iced")
    if not 1 <= args.starts <= 1000:
        raise Refusal(f"--starts {args.starts} is outside [1, 1000]")
    if args.only is not None and not 1 <= args.only <= args.starts:
        raise Refusal(f"--only {args.only} is outside [1, {args.starts}]")
    if not 20 <= args.ml <= 220:
        raise Refusal(f"--ml {args.ml:g} is outside [20, 220]")  # of at least 260 ml
    if args.sense not in ("vessels", "wrist"):
        raise Refusal(f"--sense {args.sense} is neither vessels nor wrist")
    if not 1 <= args.threads <= 1024:
        raise Refusal(f"--threads {args.threads} is outside [1, 1024]")
    return args


def cells(start, result):
    glass = "%+.0f, %+.0f" % tuple(1000 * m for m in start.glass_m)
    known = [start.number, f"{start.fill_ml:.0f}", glass, f"{start.tap_l_min:.1f}"]
    return known + [form % result[key] for key, form in COLUMNS.values()]


def run(words):
    args = checked(parser().parse_args(words))
    from iib.pour.bench import Bench  # needs ROS

    chosen = [s for s in starts.of_seed(args.seed, args.starts) if args.only in (None, s.number)]
    print("\n".join(heading(["start", "cup ml", "glass at mm", "tap l/min", *COLUMNS])), flush=True)
    results = []
    with Bench(args.scene, args.threads) as bench:
        for start in chosen:
            results.append(bench.pour(start, args.ml, args.sense))
            print(row(cells(start, results[-1])), flush=True)
    good = sum(result["succeeded"] for result in results)
    print(f"{good} of {len(results)} starts poured {args.ml:g} ml within 2 % and spilled nothing")
    return 0 if good == len(results) else 1


def main():
    return exit_code("scripts/pour", run)
