"""The conditions under which the paper's statements are made, each named once."""

from tresym.ledger.vocabulary import *
from tresym.racket.notation import *

STANDARD = {"a": fmpq(1517, 121), "b": fmpq(55, 874)}
"""The shape of the standard racket, by the moments that Table 1 prints."""

standard_racket = tuple(equal(x, Rational(str(STANDARD[str(x)]))) for x in (a, b))

ordered_moments = (I1 > 0, I2 > 0, I3 > 0, I2 - I1 > 0, I3 - I2 > 0, M > 0)
"""0 < I₁ < I₂ < I₃, and a body that turns."""

shape_of_a_body = (a > 0, b > 0, b < 1)
"""What ordered moments mean for the shape."""

shape = (a > 0, b > 0, b <= 1)
"""The closed range of shapes on which the paper's formulas are studied."""

tilted = (theta > 0, theta < pi, sin(theta) > 0)
"""The handle is not parallel to the angular momentum."""

defect = (epsilon > 0, epsilon < pi / 2, sin(epsilon) > 0, cos(epsilon) > 0)
"""A flip defect strictly between a perfect flip and none."""

auxiliary = (k > 0, r > 0)
"""k = √(ab) and r = √(b/a)."""

later = (T > 0, exp(T) - 1 > 0)
"""T is positive; the second condition says the same to the sign procedure."""
