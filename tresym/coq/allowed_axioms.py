"""The axioms on which a proof in Coq may rest, by name; any other name is reported.

`REALS` are the axioms behind the real numbers of Coq's standard library. `MACHINE` are the
operations of the processor on 63-bit integers and 64-bit floats, which Coq takes as primitives, and
what `Uint63` and `FloatAxioms` say of them; Coq's interval arithmetic computes with these. Both are
complete lists for Coq 8.16.
"""

from __future__ import annotations

import re

REALS = frozenset(
    {
        "ClassicalDedekindReals.sig_not_dec",
        "ClassicalDedekindReals.sig_forall_dec",
        "FunctionalExtensionality.functional_extensionality_dep",
        "Classical_Prop.classic",
    }
)
_MACHINE = {
    "PrimInt63": "int lsl lsr land lor lxor asr add sub mul mulc div mod divs mods eqb ltb leb "
    "ltsb lesb addc addcarryc subc subcarryc diveucl diveucl_21 addmuldiv compare compares head0 "
    "tail0",
    "Uint63": "of_to_Z lsl_spec lsr_spec land_spec lor_spec lxor_spec add_spec sub_spec mul_spec "
    "mulc_spec div_spec mod_spec eqb_correct eqb_refl ltb_spec leb_spec compare_def_spec "
    "head0_spec tail0_spec addc_def_spec addcarryc_def_spec subc_def_spec subcarryc_def_spec "
    "diveucl_def_spec diveucl_21_spec addmuldiv_def_spec",
    "PrimFloat": "float classify abs sqrt opp eqb ltb leb compare mul add sub div of_uint63 "
    "normfr_mantissa frshiftexp ldshiftexp next_up next_down",
    "FloatAxioms": "Prim2SF_valid SF2Prim_Prim2SF Prim2SF_SF2Prim opp_spec abs_spec eqb_spec "
    "ltb_spec leb_spec compare_spec classify_spec mul_spec add_spec sub_spec div_spec sqrt_spec "
    "of_uint63_spec normfr_mantissa_spec frshiftexp_spec ldshiftexp_spec next_up_spec "
    "next_down_spec",
}
MACHINE = frozenset(f"{file}.{name}" for file, names in _MACHINE.items() for name in names.split())
_ENTRIES = re.compile(r"^make(\[\d+\])?: (Entering|Leaving) directory .*$", re.MULTILINE)


def assumptions(output: str) -> str:
    """Summarise the output of ``Print Assumptions`` in a sentence; it names every other axiom."""
    said = _ENTRIES.sub("", output)
    names = set(re.findall(r"^([^\s:]+)\s*:", said, re.MULTILINE)) - {"Axioms"}
    others = sorted(names - REALS - MACHINE)
    if others:
        return f"it rests on {', '.join(others)}"
    if names & MACHINE:
        return "it rests on the classical reals and on Coq's machine integers and floats"
    return "it rests on the classical reals alone"
