"""No invalid access, no uninitialized value, no leak in anything of the package, by valgrind's memcheck: a small system
with all effects, restart and clear. Errors without the package in their stack, as those of MPI_Init, do not count.
"""
import re
import shutil
import subprocess
import sys
from pathlib import Path

import deck

OURS = r"suspensionplugin|[Ll]ubcontact|Rheometer|BackgroundFluid|DragBackground|Partition|Microstructure"

if not shutil.which("valgrind"):
    print("SKIPPED: valgrind is not installed")
    sys.exit(77)    # ctest says skipped

deck.make_state(N=30)
command, environment = deck.command_line("in.tiny")
lmp = command.index("-in") - 1
command[lmp:lmp] = ["valgrind", "--keep-debuginfo=yes", "--num-callers=40", "--leak-check=full", "--show-leak-kinds=definite",
                    "--log-file=valgrind.log"]
done = subprocess.run(command, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
deck.expect("the deck runs under valgrind", "RESULT end" in done.stdout, done.stdout[-1000:] if done.returncode else "")
log = re.sub(r"^==\d+== ?", "", Path("valgrind.log").read_text(), flags=re.MULTILINE)
deck.expect("valgrind has judged", "ERROR SUMMARY" in log)
errors = [block for block in log.split("\n\n") if re.search(r"^ +at 0x", block, re.MULTILINE)]
ours = [block for block in errors if re.search(OURS, block)]
deck.expect(f"errors of the package, of {len(errors)} in all", not ours, len(ours))
for block in ours[:5]:
    print(block)
deck.finish()
