"""Decide claims about real elementary expressions.

A claim is text, LaTeX or a SymPy relation. It is an identity (``==``), an inequality (``<``,
``<=``, ``>``, ``>=``, ``!=``), or an asymptotic statement (``O``, ``o``, ``~``) along a path to a
point. Its expressions consist of rational numbers, π, variables, powers, roots and the elementary
functions; its conditions are relations of the same kind. The function
:func:`tresym.checking.check` answers with one of four verdicts and a sentence that gives the
reason:

- ``PROVED``: an exact procedure proves the claim, without floating-point arithmetic.
- ``ENCLOSED``: ball arithmetic proves it on a whole region or along a whole path.
- ``REFUTED``: at an exact point the conditions hold and balls exclude the claim.
- ``UNDECIDED``: none of these. It never counts as a pass.

Meaning of a claim. It states something about every real point at which its conditions hold and both
sides are defined, together with every function whose derivative occurs in them. If no such point is
shown to exist, the answer is UNDECIDED, never vacuously PROVED. This differs from the convention of
complex principal branches: ``log(x**2) == 2*log(x)`` is PROVED, since negative x are outside the
common domain, and ``sqrt(x**2) == x`` is REFUTED. Text from users is never evaluated by Python or
SymPy. Lengths and exponents are limited, and input outside the grammar produces a one-line error.

Dependencies. Only python-flint is needed, and no other package of tresym. SymPy is used only by
:mod:`tresym.reals.language.sympy`, and only when its expressions are passed in.

Packages. Each imports only from those above it in this list:

- ``numbers``: exact rationals, intervals, decimals; balls, and the one place where their precision
  is set.
- ``language``: expression trees, and parsers for text, LaTeX and SymPy.
- ``domain``: conditions, exact sample points, domains of operations, and evaluation in balls.
- ``normal``: the exact normal form, in a ring with generators for roots, exponentials, angles and
  signs. Two expressions with the same normal form are equal.
- ``signs``: the sign of an expression under conditions, by several exact methods.
- ``balls``: branch and bound on boxes in ball arithmetic.
- ``expansions``: expansions of explicit functions with certified remainders, and limits.
- ``decisions``: a claim becomes a statement (``claim_parsing.py``), which the procedure of its kind
  decides.
  Begin at ``identity.py``, which explains the guarantee for equalities.

Above this package, ``tresym.asymptotics`` decides limits and orders, ``tresym.checking`` dispatches
any claim to its decider, and ``tresym.repair`` looks for true statements close to a false one.

``cross_check.py`` shares only the expression trees with the provers. Before a claim is accepted, it
tries to falsify the claim in ball arithmetic at points of its own choice. ``verdict.py`` defines
the verdicts, and ``processes.py`` runs work in other processes.
"""
