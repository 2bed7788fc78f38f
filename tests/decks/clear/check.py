"""clear, a second system, a change of effects between runs, and coefficients through write_data and restart."""
import deck

deck.make_state()
v = deck.run("in.clear").values
deck.expect_close("a second system repeats the first", v["second"], v["first"])
deck.expect("it goes on with other effects", v["third"] > 0)
deck.expect("data file: coefficients come back", v["fourth"] > 0)
deck.finish()
