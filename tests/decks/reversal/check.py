# ranks: 2
"""The example examples/reversal, shortened: contacts let go at once, films take over, contacts come back."""
import numpy as np

import deck

deck.run_example("reversal", N=300, before=2, after=1.5)
data = deck.read_stress()
turned = int(np.argmax(data["v_gamma_dot"] < 0))
since = data["v_gamma"].max() - data["v_gamma"]
old = data["v_sxy"][turned // 2:turned - 1].mean()
contact = -(data["v_contact_n"] + data["v_contact_t"])
early = (np.arange(len(since)) > turned) & (since > 0.02) & (since < 0.1)
late = (np.arange(len(since)) > turned) & (since > 1.0)
deck.expect("contacts carry less than a quarter of it just after the reversal",
            contact[early].mean() < 0.25 * -data["v_sxy"][early].mean(), f"{contact[early].mean():.2f}")
deck.expect("the viscosity falls below half", -data["v_sxy"][early].mean() < 0.5 * old, f"{-data['v_sxy'][early].mean():.1f} {old:.1f}")
deck.expect("films take over: normal lubrication at least as large as before",
            -data["v_film_n"][early].mean() > data["v_film_n"][turned // 2:turned - 1].mean())
deck.expect("contacts are back after a strain of one", contact[late].mean() > 3 * contact[early].mean())
deck.draw_example("reversal", "figure.png")
deck.finish()
