#!/usr/bin/python3
"""No two types of the project have one name: a program that loads both would run the code of one
with the data of the other."""
import collections
import pathlib
import re
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
UNNAMED = re.compile(r"^namespace \{.*?^\}  // namespace$", re.S | re.M)
# What Highway compiles lies in a namespace of its own.
TARGETS = re.compile(r"^namespace HWY_NAMESPACE \{.*?^\}  // namespace HWY_NAMESPACE$", re.S | re.M)
TYPE = re.compile(r"^(?:class|struct|enum class) (\w+)(?: final)?(?: : [^;{]*)? \{", re.M)


class Names(unittest.TestCase):
    def test_each_type_is_defined_once(self):
        files = collections.defaultdict(set)
        for folder in ("include", "src"):
            for path in sorted((ROOT / folder).rglob("*")):
                if path.suffix not in (".h", ".cpp"):
                    continue
                text = path.read_text()
                for hidden in (UNNAMED, TARGETS):
                    text = hidden.sub("", text)
                for name in TYPE.findall(text):
                    files[name].add(str(path.relative_to(ROOT)))
        self.assertGreater(len(files), 200)
        self.assertEqual({name: at for name, at in files.items() if len(at) > 1}, {})


if __name__ == "__main__":
    unittest.main()
