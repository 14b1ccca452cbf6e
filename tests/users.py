"""What a user's editor sees of tresym: read by mypy alone, which refuses an ignore that is idle."""

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

import tresym
from tresym.ledger.verification import Report
from tresym.racket.body import NamedBody
from tresym.racket.result import Flip, Journey
from tresym.reals.decisions.answer import Answer

flip: Flip = tresym.flip_defect("12.5372", "0.0629", "1/100", digits=30)
same: Flip = tresym.flip_defect(tresym.Body(1210, 16380, 17480))
named: Flip = tresym.flip_defect(tresym.bodies["book"])
bodies: Mapping[str, NamedBody] = tresym.bodies
journey: Journey = tresym.flip_angle("1", "1/10", psi0="pi/2", rate="1")
many: NDArray[np.float64] = tresym.flip_map(1.0, 0.1, [0.1, 0.2], 1.0)
answer: Answer = tresym.check("x == x", limit=5)
held: bool = answer.verdict is tresym.Verdict.PROVED
report: Report = tresym.verify("eq_gamma")

tresym.nonsense()  # type: ignore[attr-defined]
flip.nonsense()  # type: ignore[attr-defined]
answer.verdct  # type: ignore[attr-defined]  # noqa: B018
tresym.flip_defect("1", "1/10", precision=50)  # type: ignore[call-arg]
tresym.check("x == x", limit="5")  # type: ignore[arg-type]
