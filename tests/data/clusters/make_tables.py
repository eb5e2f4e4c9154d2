# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes five tables and what scikit-learn finds in them (sklearn.json), for cluster_tables_test.cpp.

    python3 tests/data/clusters/make_tables.py        needs numpy and scikit-learn; writes beside itself
"""
import json
import pathlib

import numpy as np
import sklearn
from sklearn.cluster import KMeans
from sklearn.metrics import calinski_harabasz_score, davies_bouldin_score, silhouette_score

here = pathlib.Path(__file__).parent
random = np.random.default_rng(20261121)


def cloud(count, centre, spread):
    return np.asarray(centre) + np.asarray(spread) * random.standard_normal((count, 3))


def blobs():
    return np.vstack([cloud(60, centre, 1) for centre in 10 * random.random((5, 3))])


def unequal():
    return np.vstack([cloud(240, (0, 0, 0), 1), cloud(30, (4, 0, 0), 0.4), cloud(10, (0, 4, 1), 0.3)])


def elongated():
    stretched = np.vstack([cloud(80, (0, 3 * i, 0), (3, 0.4, 0.4)) for i in range(3)])
    turn, _ = np.linalg.qr(random.standard_normal((3, 3)))
    return stretched @ turn


def duplicates():
    different = np.round(cloud(25, (0, 0, 0), 2))
    return different[random.integers(0, 25, 200)]


tables = {
    "blobs": (blobs(), 5),
    "unequal_sizes": (unequal(), 3),
    "elongated": (elongated(), 3),
    "duplicates": (duplicates(), 6),
    "one_cluster": (cloud(250, (5, 5, 5), 1), 4),
}
results = {"scikit_learn": sklearn.__version__, "restarts": 10, "tables": {}}
for name, (table, clusters) in tables.items():
    table = np.round(table, 5)
    np.savetxt(here / f"{name}.csv", table, fmt="%.5f", delimiter=",", header="m,b,k", comments="")
    found = KMeans(clusters, n_init=10, random_state=0, tol=0).fit(table)
    results["tables"][name] = {
        "clusters": clusters,
        "inertia": found.inertia_,
        "labels": found.labels_.tolist(),
        "silhouette": silhouette_score(table, found.labels_),
        "calinski_harabasz": calinski_harabasz_score(table, found.labels_),
        "davies_bouldin": davies_bouldin_score(table, found.labels_),
    }
(here / "sklearn.json").write_text(json.dumps(results) + "\n")
