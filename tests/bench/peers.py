# SPDX-License-Identifier: GPL-3.0-or-later
"""The peers' times for ARX (2,1,1) on the 2,000 samples that the benchmark arxCoefficients writes.

numpy.linalg.lstsq gets the finished matrix; Octave's arx (package control), where it is installed, the record.
Prints one line a peer: name, median microseconds, coefficients.
"""
import shutil
import subprocess
import sys
import time

import numpy as np

record = sys.argv[1]
force, position = np.loadtxt(record, delimiter=",", unpack=True)
matrix = np.column_stack([-position[1:-1], -position[:-2], force[1:-1]])
right = position[2:]


def median_us(call, repeats=300):
    times = []
    for _ in range(repeats):
        start = time.perf_counter()
        call()
        times.append(time.perf_counter() - start)
    return 1e6 * float(np.median(times))


def row(name, microseconds, coefficients):
    print(f"{name} {microseconds:.1f} " + " ".join(f"{c:.15g}" for c in coefficients))


solution = np.linalg.lstsq(matrix, right, rcond=None)[0]
row("numpy", median_us(lambda: np.linalg.lstsq(matrix, right, rcond=None)), solution)

if shutil.which("octave-cli"):
    # octave-control counts na = 2, nb = 1 from one delay on: this is (2,1,1).
    program = f"""
    pkg load control; d = csvread('{record}'); data = iddata(d(:,2), d(:,1), 1);
    arx(data, 'na', 2, 'nb', 1); times = zeros(1, 30);
    for i = 1:30, tic; model = arx(data, 'na', 2, 'nb', 1); times(i) = toc; end
    [num, den] = filtdata(model(1, 1)); % input 2 of its model is the noise
    printf('%.1f %.15g %.15g %.15g\\n', 1e6 * median(times), den{{1}}(2), den{{1}}(3), num{{1}}(2));
    """
    found = subprocess.run(["octave-cli", "--no-gui", "--eval", program], capture_output=True, text=True)
    if found.returncode == 0:
        print("octave " + found.stdout.strip())
    else:
        print("octave: " + found.stderr.strip().splitlines()[-1], file=sys.stderr)
