"""The kinds of evidence, each with the code that checks it."""
