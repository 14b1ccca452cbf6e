"""The kinds of evidence that a claim may have, each with what checks it."""
