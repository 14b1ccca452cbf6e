"""Compute very many shapes into one table, on this machine's processes or on any executor.

A :mod:`source <tresym.sweep.source>` (a grid or a CSV file) is cut into batches; each is computed
wherever the executor likes
(:mod:`tresym.sweep.workers`, :mod:`tresym.sweep.rows`) and lands in one SQLite file in one
transaction (:mod:`tresym.sweep.table`). What has landed is never computed again: a sweep that was
interrupted, even by ``kill -9``, goes on where it stopped when it is started again.
"""

from tresym.sweep.run import Summary, sweep
from tresym.sweep.source import CsvFile, Grid, Source
from tresym.sweep.table import to_frame
from tresym.sweep.workers import cluster, processes

__all__ = ["CsvFile", "Grid", "Source", "Summary", "cluster", "processes", "sweep", "to_frame"]
