# ranks: 1 2 4
"""suspension_scene measure changes nothing, to the last bit, and measures what the run itself gives."""
import deck

deck.make_state()
deck.run("in.scene_measure")
deck.finish()
