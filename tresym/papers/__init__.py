"""A paper of your own: read a short file of claims, decide them, and write its documents.

A file of claims (``.tresym``) has one statement a line, in the grammar of ``tresym check``, with
prose and sections between them::

    # Kepler's equation
    M, e real; given 0 <= e < 1
    u := root(x - e*sin(x) - M, x, M - 2, M + 2)

    The eccentric anomaly is within e of the mean anomaly.
    near: abs(u - M) <= e

:func:`tresym.papers.reading.read_paper` reads it, and
:func:`tresym.papers.verification.verify_paper` decides every claim by the same methods as
``tresym check``.
"""
