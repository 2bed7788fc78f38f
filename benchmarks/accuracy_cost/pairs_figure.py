"""Figure of pairs.py: four panels, error against work and against the exact hydrodynamics."""
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
def draw(rows, known, path): pass
