"""stability.json: what each part found last, with processor, commit and date."""

import json
import math

from iib.common.refusal import Refusal
from iib.common.files import write_atomically


def plain(value):
    """JSON has no NaN; None stands for what was not measured."""
    if isinstance(value, dict):
        return {key: plain(item) for key, item in value.items()}
    if isinstance(value, (list, tuple)):
        return [plain(item) for item in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value


def kept(folder):
    """Of each part that a folder of the suite holds: its lines, and of what and when."""
    path = folder / "stability.json"
    if not path.exists():
        raise Refusal(f"{folder} holds no stability.json; name the folder --out of an earlier run")
    return json.loads(path.read_text())


class Results:
    """A part keeps the lines that this time were not asked for."""

    def __init__(self, out, about):
        self.path, self.about = out / "stability.json", about
        self.parts = kept(out) if self.path.exists() else {}

    def put(self, part, lines):
        before = self.parts.get(part, {}).get("lines", {})
        self.parts[part] = {**self.about, "lines": {**before, **plain(lines)}}
        write_atomically(self.path, json.dumps(self.parts, indent=1) + "\n")

    def get(self, part):
        """Lines by name, and of what and when."""
        found = self.parts.get(part, {})
        return found.get("lines", {}), {
            key: value for key, value in found.items() if key != "lines"
        }
