"""How claims, conditions and derivations are typeset.

``latex`` and ``plain_text`` write formulas, ``statements`` a claim with its conditions,
``chains`` a derivation line by line, ``finding_text`` the reason of a verdict.
"""
