"""Decide claims about real elementary expressions.

What it is. A claim is text, LaTeX or a SymPy relation: an identity (``==``), an inequality
(``<``, ``<=``, ``>``, ``>=``, ``!=``), or an order (``O``, ``o``, ``~``) along a path to a point.
Its expressions are made of rational numbers, π, variables, powers, roots and the elementary
functions; its conditions are relations of the same kind. :func:`tresym.reals.decisions.check`
answers with one of four verdicts, and with a sentence that says how:

- ``PROVED``: an exact procedure said yes; no floating point took part.
- ``ENCLOSED``: ball arithmetic contains it, on a whole region or along a whole path.
- ``REFUTED``: an exact point at which the conditions hold and balls exclude the claim.
- ``UNDECIDED``: none of these. It is never a pass.

What it promises. A claim means: true at every real point of its conditions at which both sides
are defined, and so is every function whose derivative stands in them. Where no such point is
shown, the answer is UNDECIDED, never vacuously PROVED. This is not the convention of complex
principal branches: ``log(x**2) == 2*log(x)`` is PROVED, since negative x are outside the common
domain, and ``sqrt(x**2) == x`` is REFUTED. Nothing a user writes is evaluated by Python or by
SymPy; lengths and exponents have limits, and what is not read is refused in one line.

What it needs. python-flint, and nothing else of tresym: no racket is known here. SymPy enters
through :mod:`tresym.reals.language.sympy` alone, and only when its expressions are given.

Where to start reading. The rooms, each of which imports only from those above it:

- ``numbers``: exact rationals, intervals, decimals; balls, and the one place where their
  precision is set.
- ``language``: the expression tree, and how it is read from text, LaTeX and SymPy.
- ``places``: conditions, exact points in them, where each operation is defined, and values in
  balls.
- ``normal``: the exact normal form: a ring with generators for roots, exponentials, angles and
  signs, in which equal expressions have difference 0.
- ``signs``: the sign of an expression under conditions, by several exact methods.
- ``balls``: boxes cut in halves until balls decide.
- ``growth``: leading terms on one scale of functions, with certified remainders.
- ``decisions``: a statement is read (``reading.py``), each comparison goes to the procedure of its
  kind (``statement.py``), and the answer is put into words (``answer.py``). Begin at
  ``identity.py``, which states the promise for equalities.
- ``repair``: what is true instead of a refuted claim: one edit away, conditions, other values.
- ``corpus``: true and false claims with known answers, for tests and measurements.

``advocate.py`` shares nothing with the provers: it attacks in balls what is about to pass, at
points that they did not choose. ``verdict.py`` names the verdicts; ``processes.py`` runs work in
other processes.
"""
