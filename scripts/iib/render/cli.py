"""The command scripts/render."""

import json
import pathlib
import shutil
import subprocess
import tempfile
import time

from iib.common.command_line import Parser, exit_code
from iib.common.progress import Progress
from iib.common.refusal import Refusal
from iib.common.run_scene import find_run_scene, finish_well

PROG = "scripts/render"
STUDIO = pathlib.Path(__file__).with_name("studio.py")
DESCRIPTION = """Photographs and films of a scene: run_scene makes the surfaces, Blender the light.

Water refracts and absorbs, ice scatters, vessels are glass. What the studio looks like is at the
top of scripts/iib/render/studio.py. Needs blender (scripts/install_dependencies render), for films
ffmpeg, and libopenvdb-dev when the programs are built. A still takes a minute or two."""
EXAMPLES = """Examples:
  scripts/render container_splash --at 0.8 --output splash.png
  scripts/render iceberg --at 3 --size 1280x720 --samples 128
  scripts/render container_splash --film --seconds 2 --fps 24 --size 640x480 --output splash.mp4

Exit code: 0 rendered, 1 bad input."""


def parser():
    p = Parser(PROG, DESCRIPTION, epilog=EXAMPLES)
    p.add_argument("scene", help="name of a scene or path of a .yaml file")
    p.add_argument("--at", type=float, default=1.0, help="simulated second of a still (1)")
    p.add_argument("--film", action="store_true", help="a film from the start instead of a still")
    p.add_argument("--seconds", type=float, default=2.0, help="simulated, of a film (2)")
    p.add_argument("--fps", type=float, default=24.0, help="pictures per simulated second (24)")
    p.add_argument("--size", default="960x720", help="in pixels (960x720)")
    p.add_argument("--samples", type=int, default=64, help="rays per pixel; fewer are faster (64)")
    p.add_argument("--set", action="append", default=[], metavar="KEY=VALUE", help="of the scene")
    p.add_argument("--output", help="SCENE.png, or SCENE.mp4 for a film, unless told")
    p.add_run_scene()
    return p


def check(args):
    """Width and height, once everything is sound."""
    try:
        width, height = (int(word) for word in args.size.split("x"))
    except ValueError:
        raise Refusal(f"--size {args.size} must be WIDTHxHEIGHT, as 960x720") from None
    limits = (
        ("--size", width, 16, 8192),
        ("--size", height, 16, 8192),
        ("--samples", args.samples, 1, 10000),
        ("--at", args.at, 0.0, 1e4),
        ("--seconds", args.seconds, 0.0, 1e4),
        ("--fps", args.fps, 0.1, 240.0),
    )
    for name, value, low, high in limits:
        if not low <= value <= high:
            raise Refusal(f"{name} = {value:g} is outside the allowed range [{low:g}, {high:g}]")
    if not shutil.which("blender"):
        raise Refusal("no blender; run scripts/install_dependencies render")
    if args.film and not shutil.which("ffmpeg"):
        raise Refusal("no ffmpeg; run scripts/install_dependencies render")
    return width, height


def surfaces(args, folder):
    """Runs the scene; returns times and files of what is to be seen."""
    rate = args.fps if args.film else 1.0 / max(args.at, 1e-3)
    duration = args.seconds if args.film else args.at + 0.05
    finish_well(
        find_run_scene(args.run_scene),
        args.scene,
        args.set,
        accepted=("ok", "unstable"),
        duration=duration,
        surface=folder,
        frames_hz=rate,
    )
    index = json.loads((folder / "water.ply.series").read_text())["files"]
    times = [entry["time"] for entry in index]
    return times if args.film else times[-1:]


def render(folder, job):
    """Has Blender make every picture of the job, and shows how far it is."""
    path = folder / "job.json"
    path.write_text(json.dumps(job))
    command = ["blender", "--background", "--factory-startup", "--python-exit-code", "1"]
    command += ["--python", str(STUDIO), "--", str(path)]
    with subprocess.Popen(
        command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True
    ) as blender:
        names = [f"picture at {time_s:.2f} s" for time_s in job["times"]]
        bar, lines, begun = Progress(names), [], time.monotonic()
        bar.begin(names[0])
        for line in blender.stdout:
            lines.append(line)
            if line.startswith("picture "):
                bar.end(names[int(line.split()[1])], time.monotonic() - begun)
                begun = time.monotonic()
        bar.close()
    if blender.returncode != 0:
        raise Refusal("blender failed: " + "".join(lines[-5:]).strip())


def run(words):
    args = parser().parse_args(words)
    name = pathlib.Path(args.scene).stem
    output = pathlib.Path(args.output or f"{name}.{'mp4' if args.film else 'png'}").resolve()
    if not output.parent.is_dir():
        raise Refusal(f"--output {output}: there is no folder {output.parent}")
    width, height = check(args)
    with tempfile.TemporaryDirectory() as place:
        folder = pathlib.Path(place)
        times = surfaces(args, folder)
        job = {
            "folder": str(folder),
            "times": times,
            "size": [width, height],
            "samples": args.samples,
        }
        render(folder, job)
        if args.film:
            encode(folder, args.fps, output)
        else:
            shutil.copy(folder / "picture_00000.png", output)
    print(output)
    return 0


def encode(folder, fps, output):
    command = ["ffmpeg", "-y", "-loglevel", "error", "-framerate", f"{fps:g}"]
    command += ["-i", str(folder / "picture_%05d.png"), "-pix_fmt", "yuv420p", str(output)]
    if subprocess.run(command).returncode != 0:
        raise Refusal(f"ffmpeg could not write {output}")


def main():
    return exit_code(PROG, run)
