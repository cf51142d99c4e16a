"""The modules of scripts/stability."""
