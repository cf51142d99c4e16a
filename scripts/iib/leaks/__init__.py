"""The modules of scripts/leaks."""
