# ranks: 1 2
"""What fix drag/background and fix overdamped/sphere refuse of the particles there are, they refuse of those that are poured and of
those that a dynamic group takes in later.
"""
import deck

D, O = "fix d all drag/background", "fix o all overdamped/sphere"
MOVE, FALL = "fix move all nve/sphere", "fix weight all gravity 1 vector 0 0 -1"
POUR = "fix pour all pour 4 1 4711 region top diam one 2 dens 1 1 vol 0.2 100"
DEPOSIT = "fix in all deposit 4 1 1 4711 region top"
PUSH = "fix push all addforce 1 0 0"
WET, ENTER = "group wet dynamic all region left every 1", "velocity all set -1 0 0"
BOTH_MOVE = "Fix move nve/sphere and fix overdamped/sphere both move"
INSERTED, JOINED = "particles inserted by fix pour", "a particle new in its group"
LATE = [    # lines, particles at the start, message
    ([MOVE, FALL, POUR, D + " 1", PUSH], 0, f"the drag of {INSERTED}: define fix d after fix push"),
    ([MOVE, D + " 1", FALL, POUR], 0, f"the drag of {INSERTED}: define fix d after fix weight"),
    ([MOVE, FALL, D + " 1", "fix floor all wall/gran hooke 1e4 NULL 50 NULL 0 0 zplane 0 NULL", POUR], 0, "define fix d after fix floor"),
    (["group wet empty", MOVE, FALL, "fix d wet drag/background 1", "fix push wet addforce 1 0 0", POUR.replace("all", "wet")], 0,
     "define fix d after fix push"),
    ([MOVE, D + " 1", PUSH, DEPOSIT], 0, "particles inserted by fix in: define fix d after fix push"),
    ([MOVE, FALL, POUR, D + " 1", "fix e all drag/background 2"], 0, f"Fixes d and e both act on the same particles, {INSERTED}"),
    ([FALL, POUR, O + " 1", MOVE], 0, f"{BOTH_MOVE} {INSERTED}"),
    ([FALL, POUR, D + " 1", O + " 1"], 0, f"acts on {INSERTED} of fix o"),
    ([WET, "fix o wet overdamped/sphere 1", MOVE], 2, f"{BOTH_MOVE} {JOINED}"),
    ([WET, MOVE, "fix d wet drag/background 1", PUSH], 2, f"the drag of {JOINED}: define fix d after fix push"),
    ([WET, MOVE, D + " 1", "fix push wet addforce 1 0 0"], 2, f"the drag of {JOINED}: define fix d after fix push"),
    # at the start the second particle is not in it
    ([WET, ENTER, "group two id 2", MOVE, "fix d wet drag/background 0", "fix push two addforce 1e-9 0 0"], 2, f"the drag of {JOINED}"),
    ([WET, ENTER, "group two id 2", "fix move two nve/sphere", "fix o wet overdamped/sphere 1"], 2, f"{BOTH_MOVE} {JOINED}"),
]
FINE = [    # the right order; groups that nothing joins
    ([MOVE, FALL, POUR, D + " 1"], 0),
    ([FALL, POUR, O + " 1"], 0),
    (["group dry empty", MOVE, FALL, POUR, "fix d dry drag/background 1", PUSH], 0),
    ([WET, "variable right atom x>4", "group dry dynamic all var right every 1", MOVE, "fix d wet drag/background 1",
      "fix push dry addforce 1e-9 0 0"], 2),
]


def run(lines, n, steps, fails):
    text = TEMPLATE
    for name, value in {"fix": "\n".join(lines), "n": n, "steps": steps}.items():
        text = text.replace(f"${{{name}}}", str(value))
    deck.Path("in.now").write_text(text)
    return deck.run(str(deck.Path.cwd() / "in.now"), fails=fails).text


TEMPLATE = (deck.CASE / "in.late").read_text()
for lines, n, message in LATE:
    deck.expect_error("; ".join(lines), run(lines, n, 300, True), message)
for lines, n in FINE:
    run(lines, n, 100, False)
deck.finish()
