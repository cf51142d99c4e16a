"""Random starts of examples/pour, with a node of its own."""
