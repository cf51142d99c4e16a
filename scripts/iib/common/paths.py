"""Where things are in the source tree."""

import pathlib

ROOT = pathlib.Path(__file__).resolve().parents[3]
SCENES = ROOT / "config" / "scenes"
DOC = ROOT / "doc"
IMAGES = DOC / "images"
