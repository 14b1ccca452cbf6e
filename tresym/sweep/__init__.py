"""Compute the flip defect of very many shapes, on processes of this machine or on any executor.

A :mod:`source <tresym.sweep.source>` (a grid or a CSV file) is divided into batches. An executor
computes them (:mod:`tresym.sweep.workers`, :mod:`tresym.sweep.rows`), and each is stored in an
SQLite file in one transaction (:mod:`tresym.sweep.table`). A stored batch is never computed again:
a sweep that was interrupted, even by ``kill -9``, continues where it stopped when it is started
again.
"""

from tresym.sweep.run import Summary, sweep
from tresym.sweep.source import CsvFile, Grid, Source
from tresym.sweep.table import to_frame
from tresym.sweep.workers import cluster, processes

__all__ = ["CsvFile", "Grid", "Source", "Summary", "cluster", "processes", "sweep", "to_frame"]
