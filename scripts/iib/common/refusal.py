"""The one error that bad input raises, worded for the person who typed it."""


class Refusal(Exception):
    """Names the thing, the value, what is allowed and the cure."""
