"""Files of LAMMPS' fix ave/chunk, as balance.py reads them."""
import numpy as np


def read_ave_chunk(name):
    """Columns of a file of fix ave/chunk: dict of name -> array (outputs, chunks); TimeStep -> array (outputs).

    A last output still being written is left out. ValueError: not such a file, or its number of chunks changes.
    """
    with open(name, encoding="ascii", errors="replace") as file:
        lines = [line.split() for line in file.read().split("\n")[:-1]]
    names = next((line[2:] for line in lines if line[:2] == ["#", "Chunk"]), None)
    if names is None:
        raise ValueError(f"{name} is no file of fix ave/chunk: no line '# Chunk name ...'")
    rows = [line for line in lines if line and line[0] != "#"]
    steps, blocks, at = [], [], 0
    while at < len(rows):
        chunks = int(rows[at][1])
        block = rows[at + 1:at + 1 + chunks]
        if len(block) < chunks:
            break
        steps.append(float(rows[at][0]))
        blocks.append([[float(word) for word in row[1:]] for row in block])
        at += 1 + chunks
    if not blocks or len({len(block) for block in blocks}) > 1:
        raise ValueError(f"{name} has no complete output, or its number of chunks changes")
    data = np.moveaxis(np.array(blocks), 2, 0)
    return {"TimeStep": np.array(steps), **dict(zip(names, data))}
