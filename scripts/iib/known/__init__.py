"""Answers that are known without a simulation."""
