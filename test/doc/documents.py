"""Commands, programs, files and links of the Markdown documents."""

import dataclasses
import pathlib
import re
import shlex

ROOT = pathlib.Path(__file__).resolve().parents[2]
DOCUMENTS = sorted([ROOT / "README.md", ROOT / "CONTRIBUTING.md", *(ROOT / "doc").glob("*.md")])
SCENES = {path.stem for path in (ROOT / "config" / "scenes").glob("*.yaml")}

# What begins like this in `code` is a command; all lines of a fenced block without a language are.
PROGRAMS = re.compile(
    r"((\w+=\S+ )?(scripts/|\.ci/run)\S+|(run_scene|roslaunch|rosservice|rostopic|rosparam|rosnode"
    r"|rosbag|rosrun|source|export|cmake|ctest|catkin_make|cp|mkdir|sudo|apt-get)\b)"
)
PLACEHOLDER = re.compile(r"\[?[A-Z][A-Z_]*(\.\w+)?\]?")  # SCENE, [COMMIT], FILE.cpp


@dataclasses.dataclass
class Step:
    """What a reader pastes. kind: command, python, cpp or yaml; line: in the document."""

    document: pathlib.Path
    line: int
    section: int
    kind: str
    text: str
    inline: bool = False  # in `code`, not in a fenced block
    scene: str = ""  # named in the same row of a table

    def place(self):
        return f"{self.document.relative_to(ROOT)}:{self.line}"

    def words(self):
        return shlex.split(self.text)

    def is_mention(self):
        """Whether it names a program or an option in running text: `scripts/bench --count`."""
        words = [word for word in self.words() if not re.match(r"\w+=", word)]
        return self.inline and all(word.startswith("-") for word in words[1:])

    def is_template(self):
        """Whether the reader has to replace a word."""
        values = [word.rsplit("=", 1)[-1] for word in self.words()]
        return any(PLACEHOLDER.fullmatch(v) and v not in ("ON", "OFF") for v in values)

    def program(self):
        return next(word for word in self.words() if not re.match(r"\w+=", word))

    def options(self):
        words = [word for word in self.words() if re.match(r"--?[a-zA-Z]", word)]
        return [word.split("=")[0] for word in words if word != "--help"]


def without_comment(line):
    return re.sub(r"\s+# .*$", "", line.strip())


def steps_of(document):
    """All steps of a document, in its order."""
    found, section, fence = [], 0, None
    for number, line in enumerate(document.read_text().splitlines(), 1):
        marker = re.match(r"\s*```(\w*)", line)
        if marker and fence is None:
            fence, body, begin = marker[1] or "command", [], number + 1
        elif marker:
            if fence in ("python", "cpp", "yaml"):
                found.append(Step(document, begin, section, fence, "\n".join(body) + "\n"))
            fence = None
        elif fence == "command":
            if without_comment(line):
                found.append(Step(document, number, section, fence, without_comment(line)))
        elif fence is not None:
            body.append(line)
        else:
            section += line.startswith("#")
            found += inline(document, number, section, line)
    return found


def inline(document, number, section, line):
    """Commands in `code`; those of a table belong to the scene that their row names."""
    spans = re.findall(r"`([^`]+)`", line)
    scene = next((s for s in spans if s in SCENES), "") if line.startswith("|") else ""
    found = [text for text in spans if PROGRAMS.match(text)]
    return [Step(document, number, section, "command", text, True, scene) for text in found]


def links_of(document):
    """(line, path, anchor) of every link to a file of the project."""
    for number, line in enumerate(document.read_text().splitlines(), 1):
        for target in re.findall(r"\]\(([^)\s]+)\)", line):
            if not re.match(r"\w+:", target):
                yield number, *(target.split("#", 1) + [""])[:2]


def anchors_of(document):
    titles = re.findall(r"^#+ (.*)$", document.read_text(), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-") for title in titles}
