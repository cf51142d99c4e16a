"""A running node, a master for it, and load on both."""
