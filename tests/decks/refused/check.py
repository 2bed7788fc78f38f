"""Every refused argument: the message says what, the value found and the cure, and underlines the word."""
import deck

STYLE, COEFF = "lubcontact 1.0 cut 0.5", "* * 1e4 5e3"
CASES = [    # what is wrong, message, underlined word or None
    ({"style": "lubcontact"}, "missing argument: eta default|cut|shifted|voronoi|residual; write: pair_style lubcontact eta ", None),
    ({"style": "lubcontact 1.41"}, "missing argument: default|cut|shifted|voronoi|residual; write: pair_style lubcontact eta default|", None),
    ({"style": "lubcontact 1.0 cut"}, "missing argument: hc; write: cut hc", None),
    ({"style": "lubcontact -1.0 cut 0.5"}, "viscosity must be >= 0, but is -1", "-1.0"),
    ({"style": "lubcontact one cut 0.5"}, "instead of 'one'", None),
    ({"style": "lubcontact v_none cut 0.5"}, "Variable none for the viscosity of pair style lubcontact does not exist", None),
    ({"style": "lubcontact v_style cut 0.5"}, "is not equal-style", None),
    ({"style": "lubcontact 1.0 default 0.5 roll no"}, "range default takes no number, but found 0.5: write cut 0.5", "0.5"),
    ({"style": "lubcontact 1.0 default 0.5"}, "write cut 0.5", "0.5"),
    ({"style": "lubcontact 1.0 near 0.5"}, "range must be default or cut or shifted or voronoi or residual, but is near", "near"),
    ({"style": "lubcontact 1.0 cut 0"}, "range must be > 0 effective radii, but is 0", "0"),
    ({"style": "lubcontact 1.0 residual 2.1"}, "range residual must be <= 2 effective radii, beyond which nothing is left, but is 2.1", "2.1"),
    ({"style": "lubcontact 1.0 residual 1 radius mean"}, "range residual needs radius harmonic", None),
    ({"style": "lubcontact 1.0 residual 1 rollcoeff 0.6"}, "rollcoeff cannot act with range residual", None),
    ({"style": "lubcontact 1.0 residual 1 squeeze no"}, "range residual needs the squeeze film: without films use range cut", None),
    ({"style": "lubcontact 1.0 voronoi 0.5", "extra": "neighbor 0.3 multi\ncomm_modify mode multi"}, "use: comm_modify mode single", None),
    ({"style": STYLE + " gap newton"}, "gap must be exponential or euler, but is newton", "newton"),
    ({"style": STYLE + " radius big"}, "radius must be mean or harmonic, but is big", "big"),
    ({"style": STYLE + " rollcoeff -1"}, "rollcoeff must be >= 0, but is -1", "-1"),
    ({"style": STYLE + " squeeze perhaps"}, "perhaps", None),
    ({"style": STYLE + " shear"}, "missing argument: yes|no; write: shear yes|no", None),
    ({"style": STYLE + " gap"}, "missing argument: exponential|euler; write: gap exponential|euler", None),
    ({"style": STYLE + " viscosity"}, "Unknown pair_style lubcontact keyword: viscosity", "viscosity"),
    ({"style": STYLE + " viscosity 2"}, "Unknown pair_style lubcontact keyword: viscosity", "viscosity"),
    ({"style": STYLE + " roll no rollcoeff 1.5"}, "rollcoeff cannot act with roll no", None),
    ({"style": STYLE + " squeeze no gap euler"}, "gap cannot act with squeeze no", None),
    ({"coeff": "* *"}, "missing argument: g kt; write: pair_coeff I J g kt ...", None),
    ({"coeff": "* * 1e4"}, "missing argument: kt; write: pair_coeff I J g kt ...", None),
    ({"coeff": "* * common.lubcontact"}, "missing argument: name1; write: pair_coeff * * file name1 ...", None),
    ({"coeff": COEFF + " roughnes"}, "Unknown pair_coeff lubcontact keyword: roughnes", "roughnes"),
    ({"coeff": "* * 0 5e3"}, "stiffness g must be > 0, but is 0", "0"),
    ({"coeff": "* * 1e4 -1"}, "stiffness kt must be > 0, but is -1", "-1"),
    ({"coeff": COEFF + " roughness -1e-3"}, "roughness must be >= 0, but is -1e-3", "-1e-3"),
    ({"coeff": COEFF + " roughness 0.7"}, "roughness must be below the range 0.5, but is 0.7", "0.7"),
    ({"coeff": COEFF + " asperity 0"}, "asperity stiffness must be > 0, but is 0", "0"),
    ({"coeff": COEFF + " friction"}, "missing argument: none|coulomb|clm|brizmer; write: friction none|coulomb|clm|brizmer", None),
    ({"coeff": COEFF + " friction coulomb"}, "missing argument: mu; write: friction coulomb mu", None),
    ({"coeff": COEFF + " friction coulomb -0.5"}, "coefficient of friction must be >= 0, but is -0.5", "-0.5"),
    ({"coeff": COEFF + " friction rubber"}, "friction must be none, coulomb mu, or clm step, clm shift, clm ramp or brizmer with mu and the critical load, but is rubber", "rubber"),
    ({"coeff": COEFF + " friction clm"}, "but is clm", "clm"),
    ({"coeff": COEFF + " friction clm soft 0.5 1"}, "but is clm soft", "soft"),
    ({"coeff": COEFF + " friction clm step 0.5"}, "missing argument: F; write: friction clm step mu F", None),
    ({"coeff": COEFF + " friction clm shift -0.5 1"}, "coefficient of friction must be >= 0, but is -0.5", "-0.5"),
    ({"coeff": COEFF + " friction clm ramp 0.5 -2"}, "critical load must be >= 0, but is -2", "-2"),
    ({"coeff": COEFF + " friction brizmer 0.27"}, "missing argument: F; write: friction brizmer mu F", None),
    ({"coeff": COEFF + " friction brizmer 0 1"}, "coefficient of friction must be > 0, but is 0", "0"),
    ({"coeff": COEFF + " adhesion"}, "missing argument: delta; write: adhesion delta", None),
    ({"coeff": COEFF + " roughness 0.01 adhesion -3"}, "adhesion must be >= 0, but is -3", "-3"),
    ({"coeff": COEFF + " adhesion 0.01"}, "give them a roughness > 0", "0.01"),
    ({"coeff": COEFF + " roughness 0.1 adhesion 0.3"},
     "Adhesive contacts of types 1 1 break at 0.7 effective radii, beyond the range 0.5", None),
    ({"coeff": COEFF + " repulsion 1"}, "missing argument: lambda; write: repulsion F0 lambda", None),
    ({"coeff": COEFF + " restitution"}, "missing argument: e; write: restitution e", None),
    ({"coeff": COEFF + " restitution 0"}, "coefficient of restitution must be > 0, but is 0", "0"),
    ({"coeff": COEFF + " restitution 1.1"}, "coefficient of restitution must be <= 1, but is 1.1", "1.1"),
    ({"coeff": COEFF + " restitution 0.5", "extra": "variable f equal 1.1\nfix a all adapt 1 pair lubcontact restitution * * v_f"},
     "are out of range", None),
    ({"extra": "variable f equal 0.5\nfix a all adapt 1 pair lubcontact restitution * * v_f"},
     "there is no restitution that could be changed: give it to pair_coeff first", None),
    ({"style": "lubcontact 0 cut 0.5 squeeze no shear no roll no twist no", "coeff": COEFF + " restitution 0.5",
      "extra": "minimize 0 0 10 10"}, "and no restitution", None),
    ({"style": "lubcontact 1.0 residual 1", "coeff": COEFF + " restitution 0.5"}, "cannot act beside range residual", None),
    ({"coeff": COEFF + " restitution 0.5", "extra": "unfix move\nfix move all overdamped/sphere 1 shear 1"},
     "restitution needs particles with inertia", None),
    ({"coeff": COEFF + " friction coulomb 0.5"}, "friction cannot act: surfaces of roughness 0 never touch through a squeeze film; "
     "give pair_coeff a roughness > 0, or no friction", None),
    ({"coeff": COEFF + " friction coulomb 0.5", "extra": "minimize 0 0 10 10"}, "supports minimization only", None),
    ({"coeff": "1 1 1e4 5e3 friction coulomb 0.5\npair_coeff 2 2 1e4 5e3 friction clm step 0.1 1\npair_coeff 1 2 1e4 5e3"},
     "friction cannot act", None),
    ({"coeff": "1 1 1e4 5e3 friction coulomb 0.5\npair_coeff 2 2 1e4 5e3 friction coulomb 0.1"}, "friction cannot act", None),    # mixed
    ({"style": "hybrid/scaled 0.5 lubcontact 1.0 cut 0.5 0.5 zero 2.0", "coeff": "* * lubcontact 1e4 5e3\npair_coeff * * zero"},
     "cannot be scaled: its stress by origin, its power and the limit of its time step are those of the full force; use: pair_style "
     "hybrid/overlay", None),
    ({"coeff": COEFF + " repulsion -1 0.1"}, "repulsion must be >= 0, but is -1", "-1"),
    ({"coeff": COEFF + " repulsion 1 0"}, "screening length must be > 0, but is 0", "0"),
    ({"coeff": "1 1 1e4 5e3 friction coulomb 0.5\npair_coeff 2 2 1e4 5e3 friction clm step 0.5 1"},
     "Types 1 and 2 of pair style lubcontact have different laws of friction, coulomb and clm step: choose one with pair_coeff "
     "1 2", None),
    ({"extra": "variable f equal 1\nfix a all adapt 1 pair lubcontact friction * * v_f"},
     "give pair_coeff friction coulomb 0 first", None),
    ({"coeff": COEFF + " friction coulomb 0.5", "extra": "variable f equal 1\nfix a all adapt 1 pair lubcontact critical * * v_f"},
     "give pair_coeff friction clm first", None),
    ({"coeff": COEFF + " roughness 0.01 friction brizmer 0.5 1", "extra": "variable f equal 0\nfix a all adapt 1 pair lubcontact friction * * v_f"},
     "coefficient of friction brizmer must be > 0", None),
    ({"extra": "variable f equal 1\nfix a all adapt 1 pair lubcontact repulsion * * v_f"},
     "give pair_coeff repulsion 0 with a screening length first", None),
    ({"coeff": COEFF + " repulsion 1 0.1", "extra": "variable f equal -1\nfix a all adapt 1 pair lubcontact repulsion * * v_f"},
     "are out of range", None),
    ({"coeff": COEFF + " roughness 0.01 adhesion 0.01", "extra": "variable f equal 0\nfix a all adapt 1 pair lubcontact roughness * * v_f"},
     "types 1 1: adhesion acts between asperities, but their roughness is 0: give them one > 0", None),
    ({"style": "lubcontact 0 cut 0.5 squeeze no shear no roll no twist no", "coeff": COEFF + " roughness 0.01 adhesion 0.01",
      "extra": "minimize 0 0 10 10"}, "no adhesion and no", None),
    ({"coeff": COEFF + " rougness 0.1"}, "Unknown pair_coeff lubcontact keyword: rougness", "rougness"),
    ({"coeff": "1 1 1e4 5e3"}, "All pair coeffs are not set", None),
    ({"ghost": "print skipped"}, "add: comm_modify vel yes", None),
    ({"atoms": "atomic"}, "use: atom_style sphere", None),
    ({"length": 4.9}, "enlarge the box, replicate it, or shorten the range", None),
    ({"overlap": 0.8}, "overlap by 1.2 effective radii", None),
    ({"extra": "minimize 0 0 10 10"}, "supports minimization only for frictionless elastic contact", None),
    ({"extra": "compute s all stress/partition now"}, "Unknown compute stress/partition argument: now", "now"),
    ({"extra": "group one id 1\ncompute s one stress/partition"}, "use group all instead of one", "one"),
    ({"style": "zero 2.0", "coeff": "* *", "extra": "compute s all stress/partition"},
     "which is not defined", None),
    ({"extra": "fix d all drag/background"}, "missing argument: eta; write: fix ID group drag/background eta ...", None),
    ({"extra": "fix d all drag/background 1 couette 0 0 5"}, "missing argument: v_high; write: couette y_low v_low y_high v_high", None),
    ({"extra": "fix d all drag/background 1 hindrance phi"}, "missing argument: f; write: hindrance phi f", None),
    ({"extra": "fix d all overdamped/sphere 1 shape"}, "missing argument: sphere|disc; write: shape sphere|disc", None),
    ({"extra": "fix p all rheometer/plates all"}, "missing argument: upper; write: fix ID group rheometer/plates lower upper ...", None),
    ({"extra": "change_box all triclinic\nfix s all deform/rheometer"},
     "missing argument: rate|iv|stress|oscillate; write: fix ID group deform/rheometer rate|", None),
    ({"extra": "change_box all triclinic\nfix s all deform/rheometer volume oscillate 0 1"},
     "missing argument: w; write: oscillate g0 g1 w", None),
    ({"extra": "compute m all microstructure forces 10"}, "missing argument: hi; write: forces N hi", None),
    ({"extra": "compute m all microstructure angle 10 plane"}, "missing argument: xy|xz|yz; write: plane xy|xz|yz", None),
    ({"extra": "suspension_scene viscosity"}, "missing argument: value; write: viscosity value", None),
    ({"extra": "suspension_scene measure"}, "missing argument: N; write: measure N ...", None),
    ({"extra": "run_style respa 2 2 pair 1"}, "Pair style lubcontact does not work with run_style respa; use: run_style verlet", None),
    ({"extra": "comm_style tiled"}, "LAMMPS cannot send the history of ghosts back between tiles; add before the box is made: newton off", None),
    ({"extra": "fix d all drag/background -1"}, "viscosity must be >= 0, but is -1", "-1"),
    ({"extra": "fix d all drag/background 1 flow 1"}, "Unknown fix drag/background keyword: flow", "flow"),
]

TEMPLATE = (deck.CASE / "in.refused").read_text()


def run(variables, fails):
    """The deck with the values written into it: LAMMPS cannot underline a word that came from a variable."""
    text = TEMPLATE
    for name, value in variables.items():
        text = text.replace(f"${{{name}}}", str(value))
    deck.Path("in.now").write_text(text)
    return deck.run(str(deck.Path.cwd() / "in.now"), fails=fails, **{k: str(v) for k, v in variables.items() if k == "overlap"}).text


for variables, message, word in CASES:
    deck.expect_error(str(variables), run(variables, fails=True), message, word)

for more, warned in (" asperity 2e4", True), (" asperity 1e4", False), (" asperity 2e4 roughness 0.01", False):
    text = run({"coeff": COEFF + more}, fails=False)
    deck.expect(f"warning of{more}: {warned}", ("asperity has no effect because the roughness is 0" in text) == warned)
text = run({"coeff": "* * 1e12 1e12"}, fails=False)
deck.expect("a time step over the limit warns", "stability limit of the contact springs" in text)
text = run({"style": "lubcontact 1.0 default roll no"}, fails=False)
deck.expect("the default range is told", "range          cut 0.5 effective radii" in text and "rolling film   no" in text)
for length, warned in (0.07, False), (0.08, True):    # exp(-0.5/length) against 1e-3
    text = run({"coeff": f"* * 1e4 5e3 repulsion 1 {length}"}, fails=False)
    deck.expect(f"repulsion of length {length} warns: {warned}", ("where it drops to zero: extend the range" in text) == warned)
deck.expect("the table is printed once", text.count("what this run simulates") == 1)
deck.finish()
