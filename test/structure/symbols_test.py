#!/usr/bin/python3
"""No function of one library is defined in another too: the loader would take one of them for both.

Usage: symbols_test.py LIBRARY...
"""
import subprocess
import sys


def symbols_of(library):
    """Mangled names of what the library defines in our namespace, and their kinds in nm."""
    lines = subprocess.run(
        ["nm", "-D", "--defined-only", library], capture_output=True, text=True, check=True
    ).stdout.splitlines()
    return {name: kind for _, kind, name in map(str.split, lines) if "12ice_ice_baby" in name}


def main(libraries):
    symbols = {library: symbols_of(library) for library in libraries}
    own = [
        (name, library, other)
        for library in libraries
        for other in libraries
        for name, kind in symbols[library].items()
        if other != library and kind in "TDB" and name in symbols[other]
    ]
    for name, library, other in own:
        print("%s is defined in %s and in %s" % (name, library, other))
    assert sum(map(len, symbols.values())) > 1000
    return 1 if own else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
