"""Tell how good an approximation is: certified values, error tables, sharp constants

:func:`value` encloses an expression, :func:`error_table` compares an exact expression with an
approximate one, :func:`constant` encloses the best constant of an error bound.
"""

from __future__ import annotations

from tresym.accuracy.constants import constant
from tresym.accuracy.error_table import ErrorTable, error_table
from tresym.accuracy.values import Value, value

__all__ = ["ErrorTable", "Value", "constant", "error_table", "value"]
