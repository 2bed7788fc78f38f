"""Results.csv against the laws of the literature: means of the replicas and their scatter, written to table.csv; jamming.

usage: tools/python.sh judge.py [results.csv]
"""
import csv
import sys
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[2] / "examples" / "scene"))
import rheology


def replicas(rows, *names):
    """Means over the replicas, and standard errors: the larger of their scatter and of their own errors."""
    values = np.array([[float(row[name]) for name in names] for row in rows])
    own = np.array([[float(row.get(name + "_error", "nan")) for name in names] for row in rows])
    n = len(rows)
    scatter = values.std(axis=0, ddof=1) / np.sqrt(n) if n > 1 else np.zeros(len(names))
    own = np.sqrt(np.nansum(own**2, axis=0)) / n
    return values.mean(axis=0), np.fmax(scatter, own)


def phi_m(iv, phi):
    """phi_m and b of phi = phi_m/(1 + b sqrt(Iv)), least squares in 1/phi."""
    slope, intercept = np.polyfit(np.sqrt(iv), 1 / np.array(phi), 1)
    return 1 / intercept, slope / intercept


def main():
    table = sys.argv[1] if len(sys.argv) > 1 else HERE / "results.csv"
    with open(table, newline="", encoding="ascii") as file:
        rows = list(csv.DictReader(file))
    cases = {}
    for row in rows:
        cases.setdefault((float(row["friction"]), float(row["Iv"])), []).append(row)
    lines = [["friction", "Iv", "phi", "phi of Chevremont, eq. 15", "phi of Boyer", "mu", "mu of Chevremont, eq. 14", "mu of Boyer",
              "contacts", "films", "replicas"]]
    for (friction, iv), mine in sorted(cases.items()):
        (phi, mu), (phi_error, mu_error) = replicas(mine, "phi", "mu")
        parts, _ = replicas(mine, "contact_n", "contact_t", "film_n", "film_t")
        lines.append([f"{friction:g}", f"{iv:g}", f"{phi:.4f} +- {phi_error:.4f}", f"{rheology.phi_chevremont(iv, friction):.4f}",
                      f"{rheology.phi_boyer(iv):.4f}", f"{mu:.3f} +- {mu_error:.3f}", f"{rheology.mu_chevremont(iv, friction):.3f}",
                      f"{rheology.mu_boyer(iv):.3f}", f"{parts[0] + parts[1]:.3f}", f"{parts[2] + parts[3]:.3f}", len(mine)])
    with (Path(table).parent / "table.csv").open("w", newline="", encoding="ascii") as file:
        csv.writer(file, lineterminator="\n").writerows(lines)

    print("\n| friction | phi_m, fit to Iv <= 0.1 | b | Chevremont 13 |\n|---|---|---|---|")
    for friction in sorted({key[0] for key in cases}):
        points = [(iv, replicas(mine, "phi")[0][0]) for (f, iv), mine in sorted(cases.items()) if f == friction and iv <= 0.1]
        found, b = phi_m(*np.array(points).T)
        print(f"| {friction:g} | {found:.4f} | {b:.2f} | {rheology.phi_m_chevremont(friction):.4f} |")

    print("\n| friction | Iv where contact = films | with the fluid |\n|---|---|---|")
    for friction in sorted({key[0] for key in cases}):
        ivs, logs = [], [[], []]
        for (f, iv), mine in sorted(cases.items()):
            if f == friction:
                p, _ = replicas(mine, "contact_n", "contact_t", "film_n", "film_t")
                ivs.append(np.log(iv))
                logs[0].append(np.log((p[2] + p[3]) / (p[0] + p[1])))
                logs[1].append(np.log((p[2] + p[3] + iv) / (p[0] + p[1])))
        crossing = [np.exp(np.interp(0.0, log, ivs)) if max(log) > 0 else np.nan for log in logs]
        print(f"| {friction:g} | {crossing[0]:.2f} | {crossing[1]:.2f} |")


if __name__ == "__main__":
    main()
