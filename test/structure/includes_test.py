#!/usr/bin/python3
"""The layout: no circle between files or folders, no ROS in the core, no TBB in public headers."""

import pathlib
import re
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
INCLUDE_FOLDERS = [
    ROOT / "include",
    ROOT / "src/core",
    ROOT / "src/surface",
    ROOT / "src/view",
    ROOT / "src/tools",
    ROOT / "src/ros",
]
INCLUDE = re.compile(r'^\s*#\s*include\s+[<"]([^>"]+)[>"]', re.MULTILINE)


def sources(*folders):
    return sorted(
        p for folder in folders for p in (ROOT / folder).rglob("*") if p.suffix in (".h", ".cpp")
    )


def includes(path):
    """Names of all includes of a file, and the files of this project among them."""
    names = INCLUDE.findall(path.read_text(encoding="utf-8"))
    own = []
    for name in names:
        for folder in [path.parent, *INCLUDE_FOLDERS]:
            if (folder / name).is_file():
                own.append((folder / name).resolve())
                break
    return names, own


def circle(graph):
    """A list of nodes that lead back to the first, or [] if there is none."""
    done, path = set(), []

    def visit(node):
        if node in path:
            return path[path.index(node) :] + [node]
        if node in done:
            return []
        path.append(node)
        for following in sorted(graph.get(node, ())):
            found = visit(following)
            if found:
                return found
        path.pop()
        done.add(node)
        return []

    for start in sorted(graph):
        found = visit(start)
        if found:
            return found
    return []


class Includes(unittest.TestCase):
    def test_no_header_includes_itself_through_others(self):
        graph = {p: set(includes(p)[1]) for p in sources("include", "src")}
        self.assertEqual([str(p.relative_to(ROOT)) for p in circle(graph)], [])

    def test_no_circle_between_folders_of_the_core(self):
        core = ROOT / "src/core"
        graph = {}
        for path in sources("src/core"):
            folder = path.parent.name
            graph.setdefault(folder, set())
            for included in includes(path)[1]:
                if core in included.parents and included.parent.name != folder:
                    graph[folder].add(included.parent.name)
        self.assertGreater(len(graph), 5)
        self.assertEqual(circle(graph), [])

    def test_no_circle_between_parts(self):
        graph = {}
        for path in sources("include", "src"):
            part = path.relative_to(ROOT).parts[:2]
            graph.setdefault(part, set())
            for included in includes(path)[1]:
                other = included.relative_to(ROOT).parts[:2]
                if other != part:
                    graph[part].add(other)
        self.assertEqual(circle(graph), [])

    def test_only_src_ros_and_src_rviz_know_ros(self):
        ros = re.compile(r"^(ros|tf2\w*|nodelet|pluginlib|\w+_msgs|diagnostic_updater)/")
        for path in sources("include", "src/core", "src/surface", "src/view", "src/tools"):
            for name in includes(path)[0]:
                self.assertIsNone(ros.match(name), f"{path.relative_to(ROOT)} includes {name}")

    def test_public_headers_need_eigen_and_the_standard_library_only(self):
        for path in sources("include"):
            for name in includes(path)[0]:
                allowed = name.startswith(("ice_ice_baby/", "Eigen/")) or re.match(
                    r"^[a-z_]+$", name
                )
                self.assertTrue(allowed, f"{path.relative_to(ROOT)} includes {name}")

    def test_tests_mirror_the_folders_of_the_core(self):
        folders = {p.name for p in (ROOT / "src/core").iterdir() if p.is_dir()}
        tested = {p.name for p in (ROOT / "test/core").iterdir() if p.is_dir()}
        self.assertLessEqual(tested, folders)


class Circles(unittest.TestCase):
    def test_finds_one(self):
        self.assertEqual(circle({1: {2}, 2: {3}, 3: {2}}), [2, 3, 2])

    def test_finds_none_in_a_diamond(self):
        self.assertEqual(circle({1: {2, 3}, 2: {4}, 3: {4}}), [])


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[1:]])
