#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Gives the command line hostile files: captures, recordings, profiles and libraries mutated from good ones.

Usage: tests/fuzz/mutate.py PROGRAM [--files 10000] [--seed 1]      PROGRAM: gripscope-cli

Each answer must be an exit code that the program documents, within a second of processor time and 500 MB. Prints what was
run and the worst of it; what is over a limit, or crashed, is kept and named. Exit: 0 nothing found; 1 a finding.
"""
import argparse
import json
import os
import random
import resource
import shutil
import signal
import sqlite3
import struct
import sys
import tempfile

EXITS = {0, 2, 3, 4, 5, 6}
MOST_SECONDS = 1.0  # of processor time: how busy the machine is does not count
MOST_BYTES = 500e6
PATIENCE_S = 120  # of the clock, for what waits instead of working
NUMBERS = ["0", "-1", "1e-22", "1e300", "-1e-300", "nan", "inf", "9999999999999999999", "1e15", "", "0x10", "2147483648"]


class Run:
    def __init__(self, exit_code, seconds, peak):
        self.exit, self.seconds, self.peak = exit_code, seconds, peak

    def is_sound(self, files=1):
        return self.exit in EXITS and self.seconds <= MOST_SECONDS * files and self.peak <= MOST_BYTES


def run(program, arguments, home):
    """One process with limits of its own; -N: ended by signal N."""
    child = os.fork()
    if child == 0:
        resource.setrlimit(resource.RLIMIT_AS, (2_000_000_000, 2_000_000_000))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        resource.setrlimit(resource.RLIMIT_CPU, (60, 60))
        os.environ.update(HOME=home, XDG_DATA_HOME=home, GRIPSCOPE_PROFILES=home + "/profiles")
        null = os.open(os.devnull, os.O_RDWR)
        for descriptor in (0, 1, 2):
            os.dup2(null, descriptor)
        resource.setrlimit(resource.RLIMIT_FSIZE, (200_000_000, 200_000_000))
        signal.alarm(PATIENCE_S)
        os.execv(program, [program] + arguments)
    _, status, usage = os.wait4(child, 0)
    return Run(os.waitstatus_to_exitcode(status), usage.ru_utime + usage.ru_stime, usage.ru_maxrss * 1024)


def mutate_bytes(good, rng, other):
    out = bytearray(good)
    for _ in range(rng.choice((1, 1, 2, 4, 16, 64))):
        if not out:
            break
        kind, at = rng.randrange(7), rng.randrange(len(out))
        if kind == 0:
            out[at] ^= 1 << rng.randrange(8)
        elif kind == 1:
            out[at] = rng.choice((0, 1, 0x7F, 0x80, 0xFF))
        elif kind == 2:  # a number of any size at its edge
            number = rng.choice((b"\0" * 8, b"\xff" * 8, struct.pack("<d", rng.choice((1e-22, 1e300, float("nan"), -1.0)))))
            size = rng.choice((1, 2, 4, 8))
            out[at:at + size] = number[8 - size:]
        elif kind == 3:
            del out[at:at + rng.choice((1, 2, 12, 64, 4096))]
        elif kind == 4:
            piece = rng.randrange(len(other))
            out[at:at] = other[piece:piece + rng.choice((1, 12, 76, 1000))]
        elif kind == 5:
            piece = bytes(out[at:at + rng.choice((4, 12, 76, 512))])
            out[at:at] = piece * rng.choice((1, 2, 10))
        elif rng.random() < 0.3:
            del out[at:]
    return bytes(out)


def mutate_text(good, rng, other):
    """As bytes, or a number of it exchanged for another one."""
    if rng.random() < 0.4:
        return mutate_bytes(good, rng, other)
    text = good.decode("utf-8", "replace")
    places = [i for i in range(len(text)) if text[i].isdigit() and (i == 0 or not (text[i - 1].isdigit() or text[i - 1] in ".-e"))]
    for at in sorted(rng.sample(places, min(len(places), rng.choice((1, 1, 2, 5)))), reverse=True):
        end = at
        while end < len(text) and (text[end].isdigit() or text[end] in ".e-"):
            end += 1
        text = text[:at] + rng.choice(NUMBERS) + text[end:]
    return text.encode()


def hostile_value(value, rng):
    """In place of what a cell holds: another kind, an edge, hostile text, or itself with bytes changed."""
    if rng.random() < 0.4:
        if isinstance(value, bytes) and value:
            return mutate_bytes(value, rng, value)
        if isinstance(value, str) and value:
            return mutate_text(value.encode(), rng, value.encode()).decode("utf-8", "replace")
    return rng.choice((None, "", "A", "<img src=x>", "%1 %2", "\x1b[2J\x00\u202e", "x" * 300_000, '{"m":1e999}', "[" * 5000, b"",
                       b"\xff" * 64, bytes(100_000), 0, -1, 1, 2**31, 2**63 - 1, -2**63, 1e-22, 1e300, -1e300, float("inf")))


def mutate_library(good, rng, other):
    """As bytes, which are mostly refused at the door; or cells and rows changed, the schema left as it is."""
    if rng.random() < 0.3:
        return mutate_bytes(good, rng, other)
    with tempfile.NamedTemporaryFile(suffix=".db") as file:
        file.write(good)
        file.flush()
        library = sqlite3.connect(file.name, isolation_level=None)
        library.executescript("PRAGMA ignore_check_constraints=ON; PRAGMA foreign_keys=OFF; PRAGMA journal_mode=DELETE;")
        tables = [name for name, in library.execute("SELECT name FROM sqlite_master WHERE type='table' AND name NOT LIKE 'sqlite_%'")]
        filled = [name for name in tables if library.execute(f'SELECT 1 FROM "{name}" LIMIT 1').fetchone()]
        for _ in range(rng.choice((1, 1, 2, 5, 20))):
            table = rng.choice(filled)
            columns = [row[1] for row in library.execute(f'PRAGMA table_info("{table}")')]
            column, kind = rng.choice(columns), rng.random()
            row = library.execute(f'SELECT "{column}" FROM "{table}" LIMIT 1 OFFSET ?', (rng.randrange(4),)).fetchone()
            if row is None:
                continue
            try:
                if kind < 0.85:  # where the old value stood; it may stand in several rows
                    library.execute(f'UPDATE OR IGNORE "{table}" SET "{column}"=? WHERE "{column}" IS ?', (hostile_value(row[0], rng), row[0]))
                elif kind < 0.95:
                    library.execute(f'DELETE FROM "{table}" WHERE "{column}" IS ?', (row[0],))
                else:
                    library.execute(f"PRAGMA user_version={rng.choice((0, 1, 5, 99, -1))}")
            except sqlite3.Error:
                pass  # the schema itself refuses it (NOT NULL, a STRICT type)
        library.close()
        with open(file.name, "rb") as mutated:
            return mutated.read()


def checked_run(program, arguments, home):
    if run(program, arguments, home).exit != 0:
        sys.exit("the good files could not be made: " + " ".join(arguments))


def make_good(program, home):
    """The good files of each kind, by their ending."""
    def path(name):
        return os.path.join(home, name)
    recordings = []
    for i, kind in enumerate(("prbs", "multisine")):
        recordings.append(path(f"good{i}.csv"))
        checked_run(program, ["simulate", "--object", "0.04,43,9990", "--sample-time", "0.001", "--bit", "0.005", "--samples", "150",
                              "--excitation", kind, "--noise-sd", "1e-7", "-o", recordings[-1]], home)
    captures = [path("good.gscap")]
    checked_run(program, ["record", "--device", f"virtual:?speed=0&capture={captures[0]}", "--seconds", "0.1", "--arm", "-o",
                          path("squeeze.csv")], home)
    recordings.append(path("squeeze.csv"))
    library = path("good.db")
    checked_run(program, ["enroll", "--library", library, "--type", "A"] + recordings[:2], home)
    checked_run(program, ["types", "rename", "--type", "A", "--to", "B", "--reason", "a test", "--library", library], home)
    here = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../resources/profiles")
    profiles = [os.path.join(here, name) for name in sorted(os.listdir(here)) if name.endswith(".json") and "schema" not in name]
    read = lambda names: [open(name, "rb").read() for name in names]
    return {"gscap": read(captures), "csv": read(recordings), "json": read(profiles), "db": read([library])}


KINDS = {  # ending: (share of the files, at once, how bytes are mutated, commands)
    "gscap": (0.35, 20, mutate_bytes, [["replay", "--json"], ["replay", "--squeezes"], ["replay", "-o", "out"]]),
    "json": (0.25, 50, mutate_text, [["profile", "check"], ["profile", "check", "--json"]]),
    "csv": (0.15, 20, mutate_text, [["identify", "--json"], ["identify"]]),
    "db": (0.25, 1, mutate_library, [["types", "list", "--library"], ["history", "--library"], ["audit", "--verify", "--library"],
                                   ["types", "versions", "--library"], ["types", "squeezes", "--type", "B", "--library"],
                                     ["types", "guide", "--library"], ["types", "confusion", "--library"],
                                     ["history", "--json", "--library"], ["drift", "--library"], ["classify", "good0.csv", "--library"]]),
}


def try_batch(program, command, names, home, findings, worst):
    outcome = run(program, command + names, home)
    if outcome.is_sound(len(names)) and len(names) > 1 and outcome.seconds <= MOST_SECONDS:
        worst.append((outcome.seconds, outcome.peak, outcome.exit))
        return
    for name in names:  # which of them it was
        alone = run(program, command + [name], home)
        worst.append((alone.seconds, alone.peak, alone.exit))
        if not alone.is_sound():
            kept = os.path.join(tempfile.gettempdir(), "gripscope-finding-" + os.path.basename(name))
            shutil.copy(name, kept)
            findings.append(f"{' '.join(command)} {kept}: exit {alone.exit}, {alone.seconds:.2f} s, {alone.peak / 1e6:.0f} MB")
    if not outcome.is_sound(len(names)) and outcome.exit not in EXITS:
        findings.append(f"{' '.join(command)} with {len(names)} files: exit {outcome.exit}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("--files", type=int, default=10000)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    program = os.path.abspath(options.program)
    rng = random.Random(options.seed)
    findings = []
    with tempfile.TemporaryDirectory() as home:
        good = make_good(program, home)
        os.chdir(home)
        for ending, (share, at_once, mutate, commands) in KINDS.items():
            worst, count, number = [], max(at_once, round(options.files * share)), 0
            while number < count:
                names = []
                for _ in range(min(at_once, count - number)):
                    names.append(os.path.join(home, f"{number}.{ending}"))
                    with open(names[-1], "wb") as file:
                        file.write(mutate(rng.choice(good[ending]), rng, rng.choice(good[ending])))
                    number += 1
                try_batch(program, rng.choice(commands), names, home, findings, worst)
                for name in names:
                    for beside in ("", "-wal", "-shm", "-journal"):
                        if os.path.exists(name + beside):
                            os.remove(name + beside)
            print(json.dumps({"kind": ending, "files": number, "longest_s": round(max(w[0] for w in worst), 3),
                              "largest_MB": round(max(w[1] for w in worst) / 1e6),
                              "exits": {code: sum(w[2] == code for w in worst) for code in sorted({w[2] for w in worst})}}),
                  flush=True)
    for finding in findings:
        print(finding)
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main())
