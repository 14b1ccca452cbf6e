"""The kinds of evidence, each with the code that checks it.

The judge selects the module by the type of the evidence. A derivation goes to ``chain``, an
integral to ``integrals``, a bound on boxes to ``box_bounds`` or ``chart_bounds``, an order to
``asymptotics``, a printed decimal to ``printed_numbers``, a counterexample to ``refutation``.
``allowed_evidence`` says which kind of evidence may support which kind of statement.
"""
