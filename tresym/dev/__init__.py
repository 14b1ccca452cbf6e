"""Tools of developers, which run only in a source checkout; the wheel does not contain them."""
