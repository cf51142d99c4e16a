"""The modules of scripts/error_vs_runtime."""
