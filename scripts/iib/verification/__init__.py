"""The modules of scripts/verify."""
