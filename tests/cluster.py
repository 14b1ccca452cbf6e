"""A Dask cluster in a process of its own: it prints its address and ends with its input."""

import json
import sys

from distributed import LocalCluster


def main() -> None:
    """Two worker processes of two threads each, until standard input ends."""
    with LocalCluster(
        n_workers=2, threads_per_worker=2, processes=True, dashboard_address=None
    ) as cluster:
        print(json.dumps(cluster.scheduler_address), flush=True)
        sys.stdin.read()


if __name__ == "__main__":
    main()
