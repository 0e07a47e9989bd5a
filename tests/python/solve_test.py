# SPDX-License-Identifier: AGPL-3.0-or-later
import os
import signal
import threading
import time
import tomllib
import unittest

import etendue

import small


def case(**changes):
    tree = tomllib.loads(small.TEXT)
    for path, value in changes.items():
        table, key = path.split("__")
        tree.setdefault(table, {})[key] = value
    return tree


class Solves(unittest.TestCase):
    def test_tell_their_progress(self):
        states = []
        solution = etendue.solve(case(), progress=states.append)
        self.assertEqual(states[0]["stage"], "meshing")
        sweeps = [state["sweep"] for state in states if state["stage"] == "sweeps"]
        self.assertEqual(sweeps, sorted(sweeps))
        self.assertEqual(len(states[-1]["residual"]) if states[-1]["stage"] == "sweeps" else 2, 2)
        self.assertTrue(solution.converged)

    def test_end_where_progress_says_so(self):
        solution = etendue.solve(case(solve__tolerance=1e-12), progress=lambda state: state["sweep"] < 2)
        self.assertFalse(solution.converged)

    def test_raise_what_progress_raises(self):
        def fail(state):
            if state["sweep"] > 1:
                raise KeyError("mine")

        with self.assertRaises(KeyError):
            etendue.solve(case(), progress=fail)

    def test_end_at_ctrl_c(self):
        # A process in the background is started with the signal ignored.
        signal.signal(signal.SIGINT, signal.default_int_handler)
        tree = case(mesh__edge_length=0.07, directions__order=12)
        threading.Timer(1.0, os.kill, (os.getpid(), signal.SIGINT)).start()
        begun = time.monotonic()
        with self.assertRaises(KeyboardInterrupt):
            for _ in range(1000):
                etendue.solve(tree)
        self.assertLess(time.monotonic() - begun, 30)

    def test_in_two_threads_are_right(self):
        alone = etendue.solve(case(), threads=1).fluence
        found = [None] * 4

        def work(k):
            found[k] = etendue.solve(case(), threads=1).fluence

        threads = [threading.Thread(target=work, args=(k,)) for k in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for fluence in found:
            self.assertTrue((fluence == alone).all())

    def test_let_other_threads_run(self):
        counted = 0
        done = threading.Event()

        def count():
            nonlocal counted
            while not done.is_set():
                counted += 1
                time.sleep(0.001)

        counter = threading.Thread(target=count)
        counter.start()
        etendue.solve(case(directions__order=12), threads=1)
        done.set()
        counter.join()
        self.assertGreater(counted, 10)

    def test_commands_do_what_the_program_does(self):
        code, out, err = etendue.command("--version")
        self.assertEqual((code, err), (0, ""))
        self.assertIn(etendue.__version__, out)
        self.assertEqual(etendue.command("check", "none.toml")[0], 3)


if __name__ == "__main__":
    unittest.main()
