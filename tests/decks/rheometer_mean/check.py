"""Means of pressure and stress over the last unit of strain, and their deviations, against numpy."""
import numpy as np

import deck


def compare(what, table, first):
    """Columns: step, path, pressure, stress, means, deviations, span. first: row from which on the values count."""
    step, path, pressure, stress, *given, span = list(table.values())
    # the steps are equal, so that each value of the span has the same weight
    for n in np.linspace(first + 1, len(step) - 1, 12).astype(int):
        begin = max(first, int(np.argmin(np.abs(path - (path[n] - span[n])))) + 1)
        for name, values, mean, deviation in (("pressure", pressure, given[0], given[2]), ("stress", stress, given[1], given[3])):
            expected = values[begin:n + 1]
            deck.expect_close(f"{what}, path {path[n]:.3f}: mean {name} of {len(expected)}", mean[n], expected.mean(), rtol=1e-9)
            deck.expect_close("  its deviation", deviation[n], expected.std(), rtol=1e-6, atol=1e-7 * abs(expected).max())
    since = path - path[first - 1]
    deck.expect(f"{what}: spans all of the first unit of strain", np.allclose(span[first:][since[first:] < 1], since[first:][since[first:] < 1]))
    deck.expect("  and of later ones the last", np.all((span[since > 1.1] > 0.999) & (span[since > 1.1] < 1.1 + 11 * np.diff(path).max())))


deck.make_state()
first, second = deck.run("in.cell").tables()
compare("cell", first, 1)
deck.expect("cell: more than a unit of strain", first["f_cell[9]"][-1] > 2)
deck.expect("cell: before a step the value itself", first["f_cell[11]"][0] == first["f_cell[4]"][0] and first["f_cell[15]"][0] == 0)
compare("cell, new target", second, 1)
# a rate that changes: the weight is time, and strain counts in both directions
table = deck.run("in.cell", drive="oscillate 0 10 30", steps=600).tables()[0]
compare("oscillation", table, 1)

deck.run("../plates/state.lmp", ranks=1)
first, second = deck.run("in.plates").tables()
compare("plates", first, 1)
compare("plates, new target", second, 1)
deck.finish()
