"""What is put side by side, and what is searched, by the modules of bench/ that need no program."""
import json
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "bench"))
import boxes
import branches


def row(own, **found):
    """Changes at these places, named by letters, and what peers found."""
    return {"changes": [{"what": what, "at": {"mid": str(at), "rad": "0"}} for what, at in own],
            "peers": {way: {"found": [{"what": what, "at": at} for what, at in places]} for way, places in found.items()}}


def sides(of):
    return [(what, change and float(change["at"]["mid"]), theirs) for what, change, theirs in branches.beside(of)]


class Places(unittest.TestCase):
    def test_as_many_are_matched_in_order(self):
        """Also where all the peer's lie nearest to the first."""
        self.assertEqual(sides(row([("f", 2.0), ("f", 1.0)], scipy=[("f", 0.9), ("f", 0.8)])),
                         [("f", 1.0, {"scipy": 0.8}), ("f", 2.0, {"scipy": 0.9})])

    def test_fewer_are_matched_with_the_nearest_of_the_same_name(self):
        self.assertEqual(sides(row([("f", 1.0), ("f", 2.0), ("g", 1.9)], scipy=[("f", 1.9)], auto=[("g", 1.0)])),
                         [("f", 1.0, {}), ("g", 1.9, {"auto": 1.0}), ("f", 2.0, {"scipy": 1.9})])

    def test_what_only_a_peer_finds_is_shown(self):
        self.assertEqual(sides(row([("f", 1.0)], auto=[("f", 5.0), ("f", 1.1), ("fold", 3.0)])),
                         [("f", 1.0, {"auto": 1.1}), ("f", None, {"auto": 5.0}), ("fold", None, {"auto": 3.0})])

    def test_open_parts_are_counted_once(self):
        self.assertAlmostEqual(branches.length([(3, 4), (0, 2), (0.5, 0.6), (1, 2)]), 3)


class Boxes(unittest.TestCase):
    def test_the_largest_is_below_the_first_that_fails(self):
        self.assertEqual(boxes.largest(lambda k: k <= -5 or k == -3), -5)
        self.assertEqual(boxes.largest(lambda k: k <= -10), -10)
        self.assertEqual(boxes.largest(lambda k: True), boxes.LARGEST)
        self.assertIsNone(boxes.largest(lambda k: False))

    def test_only_the_orbit_that_begins_there_counts(self):
        def orbit(tau, rad, admissible, stability):
            return {"tau": {"mid": str(tau), "rad": str(rad)}, "admissible": admissible, "stability": stability}
        text = json.dumps({"orbits": [orbit(1, 0.1, True, "stable"), orbit(2, 0.1, True, "undecided"),
                                      orbit(3, 0.1, False, "stable"), orbit(4, 0.1, None, "unstable")]})
        says = lambda tau: tuple(boxes.proved(text, {"tau": tau}).values())
        self.assertEqual([says(x) for x in (1.05, 2, 3, 4, 5)],
                         [(True, True), (True, False), (False, False), (False, False), (False, False)])

    def test_only_what_is_named_is_an_interval(self):
        self.assertEqual(boxes.box({"chi": 0.5, "p": -2.0}, ["p"], -4), ["--chi=0.5", "--p=-2.0+-0.02"])


if __name__ == "__main__":
    unittest.main()
