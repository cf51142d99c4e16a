#!/usr/bin/python3
"""Every deliberate fault of mutations.yaml fits the sources, so that check/mutate can plant it."""

import pathlib
import unittest

import yaml

ROOT = pathlib.Path(__file__).resolve().parents[2]


class Mutations(unittest.TestCase):
    def test_each_text_is_in_its_file_exactly_once(self):
        faults = yaml.safe_load((ROOT / "test" / "mutations.yaml").read_text())
        for name, fault in faults.items():
            with self.subTest(fault=name):
                source = (ROOT / fault["file"]).read_text()
                self.assertEqual(source.count(fault["from"]), 1)
                self.assertNotEqual(fault["from"], fault["to"])


if __name__ == "__main__":
    unittest.main()
