# ranks: 1 2
"""Restart files of another pair style, of other effects, of dry grains: an error where their history cannot serve, else the
state of first sight, in which every pair is as in a fresh start from the same positions.
"""
import deck

WET, COEFF = "lubcontact 1.0 cut 0.5", "1e4 5e3 roughness 0.01 friction coulomb 0.5"
DRY = "lubcontact 0 cut 0.1 squeeze no shear no roll no twist no"
GRAN = "gran/hooke/history 1e4 NULL 50 NULL 0.5 1"
HOOKE = "gran/hooke 1e4 NULL 50 NULL 0.5 0"
OTHER = "different effects than pair style lubcontact has now"

deck.make_state()


def read(fails=False, **variables):
    return deck.run("in.read", fails=fails, **variables)


def fresh(what, wrote, reads):
    """A file whose history means nothing to the style that goes on."""
    deck.run("in.write", style=wrote[0], coeff=wrote[1])
    v = read(style=reads[0], coeff=reads[1]).values
    w = deck.run("in.fresh", style=reads[0], coeff=reads[1]).values
    for name in ("stress", "later"):
        deck.expect_close(f"{what}: {name} as from the positions alone", v[name], w[name], rtol=1e-9)
    if "lubcontact" in reads[0]:
        deck.expect(f"{what}: pairs act", abs(v["stress"]) > 1e-2, v["stress"])


for case in (
        ("lubcontact from granular", (GRAN, ""), (WET, COEFF)),
        ("lubcontact from granular without history", (HOOKE, ""), (WET, COEFF)),
        ("films from frictionless dry grains", (DRY, "1e4 5e3 roughness 0.01"), (WET, COEFF)),
        ("frictionless dry grains from films", (WET, COEFF), (DRY, "1e4 5e3 roughness 0.01")),
        ("granular from lubcontact", (WET, COEFF), (GRAN, "")),
        ("lubcontact from a style without forces", ("zero 2.0", ""), (WET, COEFF)))[deck.RANKS - 1::2]:    # half of them on two ranks
    fresh(*case)

# histories of other effects: an error
for what, wrote, reads in (
        ("films from dry grains with friction", (DRY, COEFF), (WET, COEFF)),
        ("dry grains from films", (WET, COEFF), (DRY, COEFF)),
        ("adhesion from none", (WET, COEFF), (WET, COEFF + " adhesion 0.002")),
        ("none from adhesion", (WET, COEFF + " adhesion 0.002"), (WET, COEFF)),
        ("films that slide from the squeeze film alone", (WET + " shear no roll no twist no", COEFF), (WET, COEFF)))[deck.RANKS - 1::2]:
    deck.run("in.write", style=wrote[0], coeff=wrote[1])
    text = read(fails=True, style=reads[0], coeff=reads[1]).text
    deck.expect(f"{what}: refused", OTHER in text, next((s for s in text.splitlines() if s.startswith("ERROR")), "no error"))

# what has no history may change: laws of friction, repulsion, viscosity, range
deck.run("in.write", style=WET, coeff=COEFF)
v = read(style="lubcontact 2.0 shifted 0.4", coeff="2e4 5e3 roughness 0.01 friction clm shift 0.5 5 repulsion 1 0.02").values
deck.expect("other coefficients for the same history", v["later"] != 0)
deck.finish()
