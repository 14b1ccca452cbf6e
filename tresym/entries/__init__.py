"""The atlas: classical asymptotic statements and bounds, each with its decided answer.

The files ``*.txt`` hold the entries by subject, written by hand; ``answers.json`` holds what the
engine found for them. Every number that an entry prints stands in a claim with a verdict there.
"""
