# SPDX-License-Identifier: GPL-3.0-or-later
"""scikit-learn's Lloyd on the tables that kmeans_peer_bench wrote: same items, same start, same number of iterations.

    kmeans_peer.py FOLDER        prints a line a table: name, seconds of both, ratio, agreement
"""
import json
import pathlib
import sys
import time
import warnings

import numpy as np
from sklearn.cluster import KMeans

warnings.filterwarnings("ignore")  # it says that it did not converge, which is asked for
folder = pathlib.Path(sys.argv[1])
for file in sorted(folder.glob("*.json")):
    own = json.loads(file.read_text())
    items = np.fromfile(folder / (file.stem + ".items"), dtype=np.float64).reshape(-1, own["features"])
    start = np.fromfile(folder / (file.stem + ".start"), dtype=np.float64).reshape(-1, own["features"])
    labels = np.fromfile(folder / (file.stem + ".labels"), dtype=np.int32)
    peer = KMeans(len(start), init=start, n_init=1, max_iter=own["iterations"], tol=0, algorithm="lloyd")
    begin = time.perf_counter()
    peer.fit(items)
    seconds = time.perf_counter() - begin
    # Clusters keep the numbers of their starting centres in scikit-learn; Gripscope numbers by appearance.
    _, first = np.unique(peer.labels_, return_index=True)
    renumbered = np.argsort(np.argsort(first))[np.searchsorted(np.unique(peer.labels_), peer.labels_)]
    print(
        f"{file.stem}: Gripscope {own['seconds']:.3f} s, scikit-learn {seconds:.3f} s, "
        f"{seconds / own['seconds']:.1f} times as long, {peer.n_iter_} iterations; "
        f"labels that differ: {np.count_nonzero(renumbered != labels)}, "
        f"inertia differs by {abs(peer.inertia_ / own['inertia'] - 1):.1e}"
    )
