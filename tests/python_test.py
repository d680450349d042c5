"""Tests of python/tsim.py; run by tests/library/python.sh, with NumPy and without."""
import array
import gc
import math
import os
import sys
import threading
import unittest

if os.environ.get("WITHOUT_NUMPY"):
    sys.modules["numpy"] = None
import tsim

try:
    import numpy
except ImportError:
    numpy = None

with_numpy = unittest.skipIf(numpy is None, "without NumPy")

PACKING = """
units si
boundary p f f
region box block 0 0.385 0 0.4 0 1 units box
create_box 2 box
lattice sc 0.055
region low block 0 0.385 0.05 0.35 0.05 0.4 units box
create_atoms 1 region low
set group all diameter 0.0523 density 2385
velocity all create 3.7e19 86028121
pair_style spring/dashpot
pair_coeff * * stiffness 2385 restitution 0.5
fix move all nve
fix g all gravity 9.81 vector 0.1 0 -1
fix floor all wall/gran primitive type 1 zplane 0.03
compute k all ke
compute where all property/atom id x vz
compute pairs all contacts
fix trace all vector 10 c_k
timestep 2e-4
"""
SINGLE = """
boundary f f f
region b block 0 9 0 9 0 9 units box
create_box 2 b
create_atoms 1 single 1 1 2.385 units box
fix m all nve
timestep 1e-3
"""


class Case(unittest.TestCase):
    script = PACKING

    def setUp(self):
        self.sim = tsim.Simulation()
        self.sim.commands(self.script)

    def tearDown(self):
        self.sim.close()


class Scripts(Case):
    def test_errors_know_their_place(self):
        with self.assertRaises(tsim.TsimError) as caught:
            self.sim.commands("print 1\nfix a all gravty 9.81\n", name="cell 3")
        error = caught.exception
        self.assertEqual((error.file, error.line, error.column, error.length),
                         ("cell 3", 2, 11, 6))
        self.assertEqual(error.code, tsim.Status.UNKNOWN)
        self.assertIn("did you mean 'gravity'?", error.message)
        self.assertTrue(str(error).endswith("          ^~~~~~"), str(error))
        self.sim.commands("print 'still alive'")

    def test_files(self):
        with self.assertRaises(tsim.TsimError) as caught:
            self.sim.file("no such file")
        self.assertEqual(caught.exception.code, tsim.Status.IO)

    def test_log_is_told(self):
        heard = []
        with tsim.Simulation(on_log=lambda level, text: heard.append((level, text))) as sim:
            sim.commands(SINGLE + "create_atoms 1 single 99 0 0 units box\nprint said\n")
        self.assertIn(("text", "said\n"), heard)
        self.assertEqual([level for level, _ in heard].count("warning"), 1)

    def test_log_function_that_fails(self):
        def fail(level, text):
            raise KeyError(text)
        with tsim.Simulation(on_log=fail) as sim:
            self.assertRaises(KeyError, sim.commands, "print said")
            sim.variables["a"] = 1

    def test_options(self):
        with tsim.Simulation(threads=2) as sim:
            self.assertEqual(sim.setting("threads"), 2)
        self.assertRaises(tsim.TsimError, tsim.Simulation, threads=5000)
        self.assertRaises(tsim.TsimError, tsim.Simulation, log="/dev/null/log")

    def test_quit(self):
        self.assertIsNone(self.sim.quit_status)
        self.sim.commands("quit 3")
        self.assertEqual(self.sim.quit_status, 3)

    def test_closed(self):
        self.sim.close()
        self.sim.close()
        self.assertRaises(ValueError, self.sim.value, "ke")
        self.assertRaises(ValueError, lambda: self.sim.x)


class Stepping(Case):
    def test_pieces_are_one_run(self):
        with tsim.Simulation() as whole:
            whole.commands(PACKING + "run 400\n")
            for _ in range(100):
                self.sim.step()
            self.sim.x  # from here on changes are looked for
            for _ in range(100):
                self.sim.step(3)
            for name in ("x", "y", "z", "vx", "vy", "vz", "fx", "fy", "fz"):
                self.assertEqual(list(self.sim.gather(name)), list(whole.gather(name)))

    def test_stop(self):
        @self.sim.on_step("end_of_step")
        def look(sim):
            if sim.clock.step == 7:
                sim.stop()
        self.assertRaises(tsim.Stopped, self.sim.commands, "run 100")
        self.assertEqual(self.sim.clock.step, 7)
        self.sim.off_step("end_of_step", look)
        self.sim.commands("run 3")
        self.assertEqual(self.sim.clock.step, 10)
        self.assertRaises(ValueError, self.sim.off_step, "end_of_step", look)
        self.assertRaises(ValueError, self.sim.on_step, "tea_break", look)

    def test_exception_in_a_step(self):
        @self.sim.on_step("before_force")
        def fail(sim):
            if sim.clock.step == 5:
                sim.value("nonsense(1)")
        with self.assertRaises(tsim.TsimError) as caught:
            self.sim.step(10)
        self.assertEqual(caught.exception.code, tsim.Status.UNKNOWN)
        self.sim.off_step("before_force", fail)
        self.sim.step(10)

    def test_two_threads(self):
        results = []

        def run():
            with tsim.Simulation() as sim:
                sim.commands(PACKING)
                sim.step(200)
                results.append(sim.value("ke"))
        threads = [threading.Thread(target=run) for _ in range(2)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(len(results), 2)
        self.assertEqual(results[0], results[1])


class Numbers(Case):
    def test_values(self):
        self.assertEqual(self.sim.value("2*PI"), 2 * math.pi)
        self.sim.step(30)
        trace = self.sim.fix("trace")
        self.assertEqual(len(trace), 4)
        self.assertEqual(trace[3], self.sim.value("c_k"))
        self.assertEqual(self.sim.compute("k"), self.sim.value("c_k"))
        where = self.sim.compute("where")
        self.assertEqual([row[1] for row in where], list(self.sim.read("x")))
        self.assertEqual(list(self.sim.evaluate("c_where[3]", "per_particle")),
                         list(self.sim.read("vz")))
        self.assertEqual(self.sim.outputs("c_where")[0].shape, "per_particle")
        self.assertRaises(tsim.TsimError, self.sim.compute, "nix")
        self.assertRaises(ValueError, self.sim.compute, "k", "square")

    def test_variables(self):
        variables = self.sim.variables
        variables["third"] = 1 / 3
        variables["name"] = "two words"
        variables.define("double", "equal", "2*v_third")
        variables.preset("given", "7")
        self.sim.commands("variable given index 1")
        self.assertEqual(variables["third"], 1 / 3)
        self.assertEqual(variables["double"], 2 / 3)
        self.assertEqual(variables["name"], "two words")
        self.assertEqual(variables["given"], 7)
        self.assertEqual(variables.text("given"), "7")
        self.assertEqual(sorted(variables), ["double", "given", "name", "third"])
        self.assertIn("third", variables)
        self.assertRaises(KeyError, lambda: variables["nix"])
        variables["long"] = "x" * 1000
        self.assertEqual(len(variables.text("long")), 1000)

    def test_state(self):
        box = self.sim.box
        self.assertEqual(box.hi, (0.385, 0.4, 1.0))
        self.assertEqual(box.periodic, (True, False, False))
        self.assertEqual(box.faces, ("pp", "ff", "ff"))
        self.sim.step(10)
        self.assertEqual(self.sim.clock.step, 10)
        self.assertAlmostEqual(self.sim.clock.time / 2e-3, 1, places=14)
        self.assertEqual(self.sim.live("fix")[2], ("floor", "wall/gran"))
        self.assertEqual(self.sim.setting("ntypes"), 2)
        self.assertEqual(self.sim.groups, ["all"])
        with tsim.Simulation() as empty:
            self.assertIsNone(empty.box)

    def test_what_there_is(self):
        self.assertIn("fix", tsim.kinds())
        self.assertIn("gravity", tsim.styles("fix"))
        self.assertIn("acceleration", tsim.help("fix", "gravity"))
        self.assertTrue(tsim.help("fix", "gravity", markdown=True).startswith("# fix gravity"))
        self.assertIn("magnitude", [a.name for a in tsim.arguments("fix", "gravity")])
        with self.assertRaisesRegex(LookupError, "did you mean 'gravity'"):
            tsim.help("fix", "gravty")
        self.assertRaises(LookupError, tsim.arguments, "fix", "gravty")
        self.assertRegex(tsim.version(), r"^\d+\.\d+\.\d+")


class Particles(Case):
    script = SINGLE

    def test_copies(self):
        self.sim.write("vz", 0.385)
        self.assertEqual(list(self.sim.read("vz")), [0.385])
        self.sim.scatter("vx", [2.385], ids=[1])
        self.assertEqual(list(self.sim.gather("vx", [1])), [2.385])
        self.assertRaises(ValueError, self.sim.write, "vz", [1, 2, 3])
        self.assertRaises(tsim.TsimError, self.sim.gather, "vx", [77])
        self.assertRaises(tsim.TsimError, self.sim.write, "id", 3)
        self.assertRaises(tsim.TsimError, self.sim.read, "vq")
        self.assertIn("diameter", self.sim.quantities())
        self.assertIn("xhold", self.sim.columns())

    def test_create_and_delete(self):
        ids = self.sim.create([[2, 2, 2], [3, 3, 3.0]], v=[[0, 0, 1], [0, 0, -1]], radius=0.2385,
                              density=[1000, 2000], type=2)
        self.assertEqual(list(ids), [2, 3])
        self.assertEqual(len(self.sim), 3)
        mass = self.sim.gather("mass", ids)
        self.assertAlmostEqual(mass[1] / mass[0], 2, places=14)
        self.sim.set_group("new", [t == 2 for t in self.sim.read("type")])
        self.assertEqual(list(self.sim.group("new")), [False, True, True])
        self.assertEqual(self.sim.value("count(new)"), 2)
        self.sim.delete(ids)
        self.assertEqual(len(self.sim), 1)
        self.assertRaises(tsim.TsimError, self.sim.create, [[99, 0, 0]])
        self.assertRaises(ValueError, self.sim.create, [1, 2])
        self.assertTrue(self.sim)

    def test_memory_is_shared(self):
        v = self.sim.view("v")
        v[0, 2] = 0.385
        self.assertEqual(self.sim.value("vz[1]"), 0.385)
        self.sim.step(1000)
        self.assertAlmostEqual(self.sim.value("z[1]"), 2.385 + 0.385, places=12)
        self.assertRaises((ValueError, TypeError), self.sim.mass.__setitem__, 0, 1.0)

    def test_views_keep_memory_alive(self):
        x = self.sim.view("x")
        raw = memoryview(x)
        self.sim.create([[5, 5, 5]] * 100)
        self.sim.step(1)
        self.sim.commands("clear")
        self.assertEqual(raw[0, 2], 2.385)
        sim = self.sim
        sim.close()
        del x, self.sim
        gc.collect()
        self.assertEqual(raw[0, 2], 2.385)
        self.sim = sim

    def test_forces_from_outside(self):
        self.sim.commands("fix g all gravity 9.81 vector 0 0 -1")

        @self.sim.on_step("after_force")
        def lift(sim):
            f, mass = sim.f, sim.mass
            for i in range(len(sim)):
                f[i, 2] += 9.81 * mass[i]
        self.sim.step(500)
        self.assertAlmostEqual(self.sim.value("z[1]"), 2.385, places=12)

    @with_numpy
    def test_arrays(self):
        sim = self.sim
        sim.create(numpy.array([[2, 2, 2], [3, 3, 3.0]]))
        sim.v[:, 2] += 0.25
        sim.v *= 2
        self.assertTrue((sim.v == [0, 0, 0.5]).all())
        sim.v = [1, 2, 3]
        self.assertEqual(sim.v.sum(), 18)
        self.assertIs(type(sim.v * 2), numpy.ndarray)
        self.assertIs(type(sim.v.copy()), numpy.ndarray)
        self.assertEqual(sim.x.shape, (3, 3))
        self.assertEqual(sim.tag.dtype, numpy.int32)
        self.assertEqual(sim.mask.dtype, numpy.uint32)
        self.assertRaises(ValueError, setattr, sim, "f", 0)  # only inside a step
        self.assertRaises(ValueError, setattr, sim, "radius", 1)
        self.assertTrue(numpy.allclose(numpy.concatenate([sim.x, sim.v]).mean(axis=0),
                                       (sim.x.mean(axis=0) + sim.v.mean(axis=0)) / 2))

    @with_numpy
    def test_stale_views(self):
        x = self.sim.x
        part, copy = x[:, 2], x[:, 2].copy()
        self.sim.create([[5, 5, 5]])
        for use in (lambda: x[0], lambda: part + 1, lambda: numpy.sum(part), lambda: part.max(),
                    lambda: list(x), lambda: repr(x), lambda: x.copy(), lambda: x.__setitem__(0, 1),
                    lambda: numpy.add(1, part), lambda: numpy.concatenate([part, part]),
                    lambda: numpy.add(1, 1, out=part[:1])):
            self.assertRaises(tsim.StaleView, use)
        self.assertEqual(copy[0], 2.385)
        x = self.sim.x
        self.sim.close()
        self.assertRaises(tsim.StaleView, lambda: x[0])

    def test_many(self):
        for k in range(300):
            sim = tsim.Simulation()
            if k % 50 == 0:
                sim.commands(SINGLE)
                kept = sim.view("x")
                sim.step(2)
            del sim
        self.assertEqual(kept[0, 0], 1.0)


if __name__ == "__main__":
    result = unittest.main(exit=False, verbosity=1).result
    bad = len(result.failures) + len(result.errors)
    print("%d passed, %d failed" % (result.testsRun - bad - len(result.skipped), bad))
    sys.exit(bad != 0)
