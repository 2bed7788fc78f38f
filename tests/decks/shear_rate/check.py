# ranks: 2
"""The example examples/shear_rate, shortened: it runs, its parts add up, its viscosity is in the known range."""
import deck

deck.run_example("shear_rate", N=400, strain=3)
data = deck.read_stress()
parts = ["v_contact_n", "v_contact_t", "v_film_n", "v_film_t", "v_inertia"]
deck.expect_close("parts and fluid add up", data["v_sxy"], 1 + sum(data[p] for p in parts), rtol=1e-4)
kept = {name: column[data["v_gamma"] > 1.0] for name, column in data.items()}
eta_r = kept["v_sxy"].mean()
# codes give 28 to 55 at phi = 0.5, mu = 0.5 with 10-15 % scatter each; 400 particles over two strain units
deck.expect("relative viscosity between 25 and 45", 25 < eta_r < 45, f"{eta_r:.1f}")
deck.expect("contacts carry most of it", (kept["v_contact_n"] + kept["v_contact_t"]).mean() > 0.5 * eta_r)
deck.expect("particles push: normal stress is compressive", max(kept[s].mean() for s in ("v_sxx", "v_syy", "v_szz")) < 0)
deck.expect("inertia is negligible", abs(kept["v_inertia"].mean()) < 0.01 * eta_r)
deck.draw_example("shear_rate", "figure.png", "particles.png", "overview.png", options=["--from", "1"])
deck.finish()
