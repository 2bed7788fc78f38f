# ranks: 1
from pathlib import Path

import numpy as np

from deck import expect, expect_close, finish, read_dump, run

OUTPUT = """thermo_style custom step time f_shear[1] f_shear[2] f_shear[3] f_shear[4] f_shear[5] f_shear[9] f_shear[10] v_sxy v_syy ke
thermo_modify norm no format float %.17g
"""


def stages(text, **variables):
    Path("stages.lmp").write_text(text)
    return [t for t in run("in.steps", **variables).tables() if "f_shear[1]" in t]


def rates(**v):
    """After a step of the rate the stress over the rate goes on as if there had been no step."""
    start = "fix shear all deform/rheometer rate 1 volume\n" + OUTPUT + "thermo 20\nrun $(ceil(0.1/dt))\nwrite_data mid.data\nthermo $(round(1e-3/dt))\n"
    def then(rate, strain, n=40):
        return f"fix_modify shear rate {rate}\nthermo $(ceil({strain}/{rate}/dt/{n}))\nrun $(ceil({strain}/{rate}/dt))\n"
    tables = stages(start + then(1, 0.03), **v)
    steady = tables[-1]
    tables = stages(start + then(1e-3, 0.004) + then(1, 0.01), **v)
    low, high = tables[-2:]
    for t, rate in (low, 1e-3), (high, 1):
        for k in range(0, len(t["Step"]), 4):
            s = np.interp(t["f_shear[1]"][k], steady["f_shear[1]"], steady["v_sxy"])
            p = np.interp(t["f_shear[1]"][k], steady["f_shear[1]"], steady["v_syy"])
            print(rate, t["f_shear[1]"][k], t["v_sxy"][k] / rate, s, t["v_syy"][k] / rate, p)


rates(g=1e4, density=0.05, coeffs="roughness 0")
finish()
