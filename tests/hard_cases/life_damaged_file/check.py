# ranks: 1 2
"""A restart file that is not what was written - cut off anywhere, or with a byte changed in what the package wrote - stops
the run with an error that says so: no crash, no hang, no other simulation. What LAMMPS itself wrote it checks only for
its length.
"""
import os
import signal
import struct
import subprocess
from pathlib import Path

import deck

CRASHES = {128 + s for s in (signal.SIGSEGV, signal.SIGABRT, signal.SIGBUS, signal.SIGFPE)}
MINE = slice(deck.RANKS - 1, None, 2)    # half of the places on one rank, half on two
SIZE_OF_ATOM = 16    # of atom_style sphere: length, x, tag, type, mask, image, v, radius, mass, omega


def read(name):
    """What LAMMPS says to this file, at most 20 s; a crash is a failure whatever it says."""
    command, environment = deck.command_line("in.read", file=name)
    done = subprocess.run(command, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=20,
                          check=False, errors="replace")
    crashed = done.returncode < 0 or done.returncode in CRASHES
    return "CRASH" if crashed else done.stdout


def judge(what, damaged, *messages):
    Path("damaged").write_bytes(damaged)
    text = read("damaged")
    shown = next((line for line in text.splitlines() if line.startswith("ERROR")), "no error" if text != "CRASH" else text)
    deck.expect(f"{what}", any(message in shown for message in messages), shown)


def flipped(whole, place, mask):
    return whole[:place] + bytes([whole[place] ^ mask]) + whole[place + 1:]


def atoms(whole):
    """Place of the first atom: the file ends with their number of values, the values, and 16 bytes."""
    for values in range((len(whole) - 16) // 8, 0, -1):
        place = len(whole) - 16 - 8 * values
        if place >= 4 and struct.unpack_from("i", whole, place - 4)[0] == values:
            return place
    raise ValueError("no atoms in this file")


deck.make_state()
deck.run("in.write", ranks=1)
whole = Path("whole").read_bytes()
deck.expect("the whole file is read", "RESULT energy" in read("whole"))

pair = whole.index(b"lubcontact\0") + len(b"lubcontact\0")
first = atoms(whole)
for place in (0, 10, 100, pair + 2, pair + 30, pair + 150, first - 200, first + 1000, len(whole) // 2, len(whole) - 1)[MINE]:
    judge(f"cut off after {place} bytes", whole[:place], "Invalid LAMMPS restart file", "byte ordering", "Incomplete or corrupted")

# the settings: length, checksum, 3 numbers, 7 choices; the coefficients: length, checksum, 2 flags, 9 numbers
DAMAGED = ["pair style lubcontact in the restart file is damaged"]
length, = struct.unpack_from("i", whole, pair)
settings, coeffs = pair + 12, pair + 12 + length
deck.expect_close("length of the settings", length, 3 * 8 + 7 * 4)
for place, mask in ((pair, 0x01), (pair + 3, 0xff), (pair + 3, 0x01), (pair + 8, 0x10), (settings, 0x01), (settings + 7, 0x80), (settings + 24, 0xff),
                    (settings + 27, 0x80), (settings + 51, 0x01), (coeffs, 0x01), (coeffs + 13, 0x01), (coeffs + 16, 0xff),
                    (coeffs + 20, 0x01), (coeffs + 83, 0x40))[MINE]:
    judge(f"pair style, byte {place - pair}", flipped(whole, place, mask), *DAMAGED)

flow = whole.index(b"deform/rheometer\0") + len(b"deform/rheometer\0") + 4
drag = whole.index(b"drag/background\0") + len(b"drag/background\0") + 4
judge("rheometer, its size", flipped(whole, flow + 1, 0x01), "fix deform/rheometer in the restart file is damaged, or was written by another version")
for place in (flow + 8 * 9, flow + 8 * 24 + 6, flow + 8 * 30)[MINE]:
    judge(f"rheometer, byte {place - flow}", flipped(whole, place, 0x40), "fix deform/rheometer in the restart file is damaged")
judge("drag", flipped(whole, drag + 5, 0x01), "fix drag/background in the restart file is damaged")

record = first    # of an atom with partners
while struct.unpack_from("d", whole, record + 8 * (SIZE_OF_ATOM + 1))[0] == 0:
    record += 8 * int(struct.unpack_from("d", whole, record)[0])
history = record + 8 * SIZE_OF_ATOM
HISTORY = ["pair history", "data of atom"]
for value, byte, mask in ((0, 6, 0x01), (0, 7, 0xff), (0, 7, 0x3f), (1, 6, 0x10), (1, 7, 0x80), (2, 0, 0x01), (3, 3, 0x01), (8, 7, 0x80),
                          (12, 6, 0xff))[MINE]:
    judge(f"history, byte {byte} of value {value}", flipped(whole, history + 8 * value + byte, mask), *HISTORY)
os.remove("damaged")
deck.finish()
