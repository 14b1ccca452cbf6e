"""Read a LaTeX manuscript and give every link of its displays a status.

``files`` and ``source`` collect the text and its displays, ``display`` and ``links`` take a
display apart into links such as ``A = B`` or ``B < C``. ``kinds`` finds out what each symbol is,
and ``context``, ``scopes`` and ``prose`` collect the definitions and conditions that apply.
``deciding`` hands every link that was understood to :mod:`tresym.reals` and gives it a status;
what was not understood stays UNREAD.
"""
