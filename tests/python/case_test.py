# SPDX-License-Identifier: AGPL-3.0-or-later
import pathlib
import tempfile
import tomllib
import unittest

import etendue

import small


class Cases(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.file = pathlib.Path(self.folder.name) / "room.toml"
        self.file.write_text(small.TEXT, encoding="utf-8")

    def test_are_the_tree_of_the_file(self):
        self.assertEqual(etendue.load(self.file), tomllib.loads(small.TEXT))

    def test_take_overrides(self):
        case = etendue.load(self.file, ["solve.tolerance=1e-3"])
        self.assertEqual(case["solve"]["tolerance"], 1e-3)
        self.assertEqual(case.resolved()["solve"]["tolerance"], 1e-3)

    def test_have_defaults_when_resolved(self):
        self.assertEqual(etendue.load(self.file).resolved()["solve"]["max_sweeps"], 500)

    def test_copies_change_apart(self):
        case = etendue.load(self.file)
        other = case.copy()
        other["media"]["air"]["absorption"] = 9
        self.assertEqual(case["media"]["air"]["absorption"], [0.1, 0.2])

    def test_files_that_are_wrong_are_told_with_all_lines(self):
        self.file.write_text(small.TEXT + "\n[solve]\ntolerance = -1\nfaster = true\n", encoding="utf-8")
        lines = len(small.TEXT.splitlines())
        with self.assertRaises(etendue.InputError) as caught:
            etendue.load(self.file)
        self.assertEqual(sorted(line for _, line, _ in caught.exception.faults), [lines + 3, lines + 4])
        self.assertIn("room.toml", str(caught.exception))
        self.assertIsInstance(caught.exception, ValueError)

    def test_dictionaries_that_are_wrong_are_told_with_their_keys(self):
        case = etendue.load(self.file)
        case["media"]["air"]["absorption"] = -1
        with self.assertRaises(etendue.InputError) as caught:
            etendue.check(case)
        self.assertIn("absorption", str(caught.exception))

    def test_files_that_are_not_there(self):
        with self.assertRaises(etendue.FileError):
            etendue.load(self.file.with_name("none.toml"))


if __name__ == "__main__":
    unittest.main()
