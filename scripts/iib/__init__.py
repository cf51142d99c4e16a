"""The Python of the project. Commands and tests import it as `iib`; it never imports them."""
