# ranks: 1 2
"""A run killed in the middle, or while it writes a restart file, is continued from the good one of the two restart files
and ends as if nothing had happened: bit for bit; with drag, which is computed again from other velocities, to rounding; with LAMMPS' fix deform, which moves
the cell after the forces, to a fraction of a step (see tests/decks/restart).
"""
import fcntl
import os
import select
import signal
import subprocess
from pathlib import Path

import numpy as np

import deck

A, B, PIPE = Path("restart_a"), Path("restart_b"), Path("pipe")


def kill(process):
    """kill -9 of LAMMPS, of one of its ranks if there are several: the others may not go on without it."""
    children = Path(f"/proc/{process.pid}/task/{process.pid}/children").read_text().split()
    os.kill(int(children[-1]) if deck.RANKS > 1 else process.pid, signal.SIGKILL)
    try:
        process.wait(timeout=20)
    except subprocess.TimeoutExpired:
        process.kill()
        process.wait()
        deck.expect("all ranks end", False)


def halted(pipe, size, **variables):
    """A run that writes to a pipe, halted when size bytes have arrived: it is killed there. Returns the bytes."""
    pipe.unlink(missing_ok=True)
    os.mkfifo(pipe)
    reader = os.open(pipe, os.O_RDWR)    # for writing, too: no end of file before LAMMPS opens it
    fcntl.fcntl(reader, fcntl.F_SETPIPE_SZ, 4096)    # the writer is at most a page ahead
    command, environment = deck.command_line("in.run", last=100000, **variables)
    process = subprocess.Popen(command, env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    arrived = b""
    while len(arrived) < size and select.select([reader], [], [], 30)[0]:
        arrived += os.read(reader, size - len(arrived))
    kill(process)
    os.close(reader)
    pipe.unlink()
    deck.expect("it was killed in the middle", len(arrived) == size and process.returncode != 0, f"code {process.returncode}")
    return arrived


def same(what, agreement):
    a, b = deck.read_dump("straight.dump"), deck.read_dump("end.dump")
    worst = {name: np.max(np.abs(a[name] - b[name])) / np.sqrt(np.mean(a[name]**2)) for name in a}
    if agreement == "bits":
        wrong = [name for name in a if not np.array_equal(a[name], b[name])]
        deck.expect(f"{what}: bit for bit", not wrong, f"{' '.join(wrong)} {max(worst.values()):.1e}")
    elif agreement == "drag":
        # step 200 adjusts the flow after its forces: from there the drag is computed again in the flow after that
        limit = 1e-5 if "middle" in what and "rheometer" in what else 1e-8
        deck.expect(f"{what}: to {limit}", max(worst.values()) < limit, f"{max(worst.values()):.1e}")
    else:    # what happens in a fraction of a step of 5e-4
        shift = np.max(np.abs(a["y"] - b["y"]))
        deck.expect(f"{what}: y within a fraction of a step", shift < 5e-4, f"{shift:.1e}")


CASES = [    # what drives the cell, drag, agreement
    ("rheometer", "", "bits"),
    ("rheometer", "0.1 cell", "drag"),
    ("force", "", "bits"),
    ("deform", "", "step"),
]
for cell, drag, agreement in CASES[:4 if deck.RANKS == 1 else 1]:
    deck.make_state(shape="orthogonal" if cell == "force" else "triclinic")
    variables = {"cell": cell, "drag": f"fix drag all drag/background {drag}" if drag else "print none"}
    what = f"{cell}, with drag" if drag else cell
    deck.run("in.run", out="straight.dump", **variables)

    halted(PIPE, 2000, stuck=PIPE, **variables)    # after step 200, which b holds
    deck.run("in.run", **variables, **{"from": B})
    same(f"{what}, killed in the middle", agreement)

    B.write_bytes(halted(PIPE, A.stat().st_size // 2, second=PIPE, **variables))    # b is torn, a is whole
    text = deck.run("in.run", fails=True, **variables, **{"from": B}).text
    deck.expect(f"{what}, the torn file is refused", "ERROR" in text, next(s for s in text.splitlines() if "ERROR" in s))
    deck.run("in.run", **variables, **{"from": A})
    same(f"{what}, killed while writing", agreement)
deck.finish()
