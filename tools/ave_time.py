"""Files of LAMMPS' fix ave/time, as steady.py reads them."""
import numpy as np


def read_ave_time(name):
    """Columns of a file of fix ave/time in scalar mode: dict of name -> array, first TimeStep.

    A last line still being written is left out. Where a run was continued and appended, the earlier run's
    values from that step on are dropped. ValueError: not such a file, or not a run and its continuation.
    """
    with open(name, encoding="ascii", errors="replace") as file:
        lines = file.read().split("\n")[:-1]    # what follows the last newline is not complete
    names, rows, joints, fresh = None, [], set(), False    # joints: rows with which a run begins
    for number, line in enumerate(lines, 1):
        words = line.split()
        if words[:2] == ["#", "TimeStep"]:
            if names not in (None, words[1:]):
                raise ValueError(f"{name}, line {number}: columns change; keep such runs in separate files")
            names, fresh = words[1:], True
            if "Number-of-rows" in names:
                raise ValueError(f"{name} is of mode vector; fix ave/time must have mode scalar")
        elif words and "#" not in line:    # a killed run may end within the line of the next header
            try:
                row = [float(word) for word in words]
            except ValueError:
                row = []
            if names is None or len(row) != len(names):
                raise ValueError(f"{name}, line {number}: not one number for each name of '# TimeStep name ...'")
            while rows and rows[-1][0] >= row[0]:
                rows.pop()
            joints.update([len(rows)] if fresh else [])
            rows.append(row)
            fresh = False
    if not rows:
        raise ValueError(f"{name} has no complete line of data")
    check_spacing(name, np.array(rows)[:, 0], joints)
    return dict(zip(names, np.array(rows).T))


def check_spacing(name, steps, joints):
    """ValueError if the steps are not equally spaced; where a run was appended one line may be missing."""
    apart = np.diff(steps)
    usual = next((d for n, d in enumerate(apart, 1) if n not in joints), None)
    for n, distance in enumerate(apart, 1):
        if usual and distance != usual and not (n in joints and distance == 2 * usual):
            raise ValueError(f"{name}: {usual:g} steps between lines, but {distance:g} after step {steps[n - 1]:g}: "
                             "not one run and its continuation; keep other runs in files of their own")
