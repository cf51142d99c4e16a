"""Imports of the package iib: no circle, nothing of the tests, and one way to find it."""
import ast
import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
from iib.common.paths import ROOT

SCRIPTS, TESTS = ROOT / "scripts", ROOT / "test"
FIND_PACKAGE = 'sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[{}] / "scripts"))'


def module_name(path):
    parts = path.relative_to(SCRIPTS).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


def imported(path):
    """Names of modules, wherever the file imports them; relative ones begin with a dot."""
    names = []
    for node in ast.walk(ast.parse(path.read_text())):
        if isinstance(node, ast.Import):
            names += [alias.name for alias in node.names]
        elif isinstance(node, ast.ImportFrom):
            origin = "." * node.level + (node.module or "")
            names += [origin, *(f"{origin}.{alias.name}" for alias in node.names)]
    return names


def circle(graph):
    """Nodes along a circle of edges, the first one again at the end; [] if there is none."""
    done = set()

    def search(node, trail):
        if node in trail:
            return [*trail[trail.index(node) :], node]
        if node in done:
            return []
        for target in sorted(graph.get(node, ())):
            found = search(target, [*trail, node])
            if found:
                return found
        done.add(node)
        return []

    return next((found for found in (search(node, []) for node in sorted(graph)) if found), [])


def package_of(module):
    """iib.common of iib.common.paths."""
    return ".".join(module.split(".")[:2])


def is_python(path):
    if path.suffix:
        return path.suffix == ".py"
    return path.is_file() and path.read_bytes().startswith(b"#!/usr/bin/python3")


class Package(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        paths = {module_name(path): path for path in (SCRIPTS / "iib").rglob("*.py")}
        cls.imports = {name: imported(path) for name, path in paths.items()}
        cls.graph = {name: set(paths).intersection(cls.imports[name]) for name in paths}

    def test_a_circle_is_found(self):
        self.assertEqual(circle({"a": {"b"}, "b": {"c"}, "c": {"b"}}), ["b", "c", "b"])
        self.assertEqual(circle({"a": {"b", "c"}, "b": {"c"}}), [])

    def test_modules_are_found(self):
        self.assertIn("iib.common.refusal", self.graph["iib.common.command_line"])
        self.assertGreater(len(self.graph), 50)

    def test_modules_do_not_import_in_a_circle(self):
        modules = {
            name: targets - {"iib", package_of(name)} for name, targets in self.graph.items()
        }
        self.assertEqual(circle(modules), [])

    def test_packages_do_not_import_in_a_circle(self):
        packages = {}
        for name, targets in self.graph.items():
            own = package_of(name)
            packages.setdefault(own, set()).update(map(package_of, targets))
            packages[own] -= {own, "iib"}
        self.assertEqual(circle(packages), [])
        self.assertEqual(packages["iib.common"], set())

    def test_nothing_of_the_tests_is_imported(self):
        own = {path.stem for path in TESTS.rglob("*.py")} | {"test"}
        for name, targets in self.imports.items():
            self.assertEqual(own.intersection(t.split(".")[0] for t in targets), set(), name)

    def test_imports_name_the_package(self):
        for name, targets in self.imports.items():
            self.assertEqual([t for t in targets if t.startswith(".")], [], name)


class Users(unittest.TestCase):
    def test_commands_and_tests_find_the_package_in_one_way(self):
        paths = [*SCRIPTS.iterdir(), *SCRIPTS.glob("[!i]*/*"), *TESTS.rglob("*.py")]
        users = [path for path in paths if is_python(path) and "\nfrom iib" in path.read_text()]
        self.assertGreater(len(users), 20)
        for path in users:
            depth = len(path.relative_to(ROOT).parts) - 1
            before = path.read_text().split("\nfrom iib")[0]
            self.assertEqual(before.splitlines()[-1], FIND_PACKAGE.format(depth), path)


if __name__ == "__main__":
    unittest.main()
