"""The parts of scripts/error_vs_runtime."""
