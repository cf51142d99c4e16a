"""The range of every key, read from `run_scene --defaults`, so that there is no second list."""

import dataclasses
import re

from iib.common import processes

LINE = re.compile(
    r"^(?P<comment>#?)(?P<indent> *)(?P<key>\w+):(?P<value>[^#{]*).*"
    r"\{\[(?P<low>\S+), (?P<high>\S+)\]\}$"
)
SECTION = re.compile(r"^(?P<section>\w+):(?P<list> \[\])?\s*$")


@dataclasses.dataclass
class Range:
    """low and high are allowed. whole: of whole numbers; parts: of a vector; matrix: of rows."""

    key: str
    low: float
    high: float
    default: str

    @property
    def vector(self):
        return self.default.startswith("[")

    @property
    def matrix(self):
        return self.default.startswith("[[")


def ranges(program):
    """By dotted key; of a list, by the name of the list, as blocks.max_m."""
    text = processes.run([program, "--defaults"])
    return parse(text)


def parse(text):
    found, section = {}, ""
    for line in text.splitlines():
        begins = SECTION.match(line)
        if begins:
            section = begins["section"] + "."
            continue
        match = LINE.match(line)
        if not match:
            continue
        nested = match["comment"] or match["indent"]
        key = (section if nested else "") + match["key"]
        found[key] = Range(key, float(match["low"]), float(match["high"]), match["value"].strip())
    return found
