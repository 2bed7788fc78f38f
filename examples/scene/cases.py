"""Tables of studies: one row a case, appended as the runs end, so that a study can be stopped and extended."""
import argparse
import csv
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path


def read(table):
    """Rows of the table as dicts of strings; none if there is no table yet."""
    if not Path(table).exists():
        return []
    with open(table, newline="", encoding="ascii") as file:
        return list(csv.DictReader(file))


def run(cases, measure, table, fields, jobs=1):
    """Appends measure(case), a dict of fields, for each case, a dict of strings, that the table lacks."""
    names = list(cases[0]) if cases else []
    rows = read(table)
    done = {tuple(row[name] for name in names) for row in rows}
    missing = [case for case in cases if tuple(case.values()) not in done]
    if not missing:
        return
    with open(table, "a", newline="", encoding="ascii") as file:
        writer = csv.DictWriter(file, fields, lineterminator="\n")
        if not rows:
            writer.writeheader()
        with ThreadPoolExecutor(jobs) as pool:
            for row in pool.map(measure, missing):
                writer.writerow(row)
                file.flush()
                print("  ".join(f"{name} {value}" for name, value in row.items()), flush=True)


def parser(doc, table, phi, particles, strain):
    """Options that studies share, with defaults; table: the whole one."""
    options = argparse.ArgumentParser(description=doc, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--phi", nargs="+", default=phi)
    options.add_argument("--particles", default=particles)
    options.add_argument("--strain", default=strain)
    options.add_argument("--only", type=int, help="the first cases")
    options.add_argument("--jobs", type=int, default=1)
    options.add_argument("--table", default=str(table))
    options.add_argument("--draw", action="store_true")
    return options


def columns(rows, *names):
    """Columns of the rows as lists of floats."""
    return [[float(row[name]) for row in rows] for name in names]


def write_tables(readme, tables):
    """Writes the lines of each table into a README, between the lines <!-- name --> and <!-- end -->."""
    text = Path(readme).read_text(encoding="ascii")
    for name, lines in tables.items():
        start = text.index(f"<!-- {name} -->\n") + len(f"<!-- {name} -->\n")
        text = text[:start] + "\n".join(lines) + "\n" + text[text.index("<!-- end -->", start):]
    Path(readme).write_text(text, encoding="ascii")
