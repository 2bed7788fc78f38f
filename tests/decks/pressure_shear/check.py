# ranks: 2
"""The example examples/pressure_shear, shortened: pressure held, volume fraction and friction near the laws."""
import deck

deck.run_example("pressure_shear", N=400, strain=5)
data = deck.read_stress()
kept = {name: column[data["v_gamma"] > 1.5] for name, column in data.items()}
# over 3.5 strain units the mean can miss by (change of ln V)/3.5 = 0.3 %, on top of the servo's lag
deck.expect_close("pressure", -kept["v_syy"].mean(), 1.0, atol=0.02)
phi, mu = kept["v_phi_now"].mean(), kept["v_sxy"].mean()
# phi(0.1): Boyer 0.4445, Chevremont 0.4358; mu(0.1): Boyer 1.244, Chevremont 1.078; 400 particles scatter by 1 and 4 %
deck.expect("volume fraction between 0.43 and 0.46", 0.43 < phi < 0.46, f"{phi:.4f}")
deck.expect("friction between 1.05 and 1.3", 1.05 < mu < 1.3, f"{mu:.3f}")
deck.draw_example("pressure_shear", "figure.png", "particles.png", options=["--from", "1.5"])
deck.finish()
