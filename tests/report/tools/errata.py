#!/usr/bin/env python3
"""Whether the errata are as a journal prints them: by place, formulas and numbers alone, without the ids of claims.

    errata.py ERRATA.tex
"""

import sys
from pathlib import Path

text = Path(sys.argv[1]).read_text()

for part in (r"\entry{(45)}", r"\entry{(47), $c_1$}", "should read", "$7.747$", r"\omega - \omega_1 \neq 0",
             # A letter: who writes it is left open, what was read is said, the paper is quoted.
             "Your name", "The text read is that of HAL",
             "``non-sticking periodic orbits are obtained only for $V = 0$''",
             "To be compared with the printed page", "2 of the 4 admissible orbits at the data of Fig. 2",
             r"\formula{Z(t) = \Gamma(T - t_1) E Z_0}", "(Lost in the text read: the minus sign.)"):
    assert part in text, part

# In the order of the paper.
places = ["Abstract and", "(4)", "Section 4, b", "(16)", "Section 4, e", "Section 5, after (18)", "(19)", "Section 5, e",
          "Section 6, a", "(37)", "Section 6, e", "Section 7", "(45)", "(47)", "Appendix 5"]
at = [text.find(r"\entry{" + place) for place in places]
assert -1 not in at and at == sorted(set(at)), list(zip(places, at))

# No hypothesis is told twice, no claim named.
for part in (r"\cos\frac{T}{2} \neq 0", "(16.back)", "(A5.longer)", "37.sharp", "S.tau", "does not matter"):
    assert part not in text, part
