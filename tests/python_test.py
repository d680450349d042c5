"""Tests of python/tsim; run by tests/library/python.sh, with NumPy and without."""
import array
import gc
import io
import math
import os
import re
import sys
import tempfile
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


def rows(values):
    """Numbers as lists that can be compared."""
    return [list(row) if hasattr(row, "__len__") else row for row in values]


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
            for name in ("y", "z", "vx", "vy", "vz", "fx", "fy", "fz"):
                self.assertEqual(list(self.sim.gather(name)), list(whole.gather(name)))
            self.assertEqual(rows(self.sim.gather("x")), rows(whole.gather("x")))

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
        self.assertEqual([row[1] for row in where], [row[0] for row in self.sim.read("x")])
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
        first = self.sim.tag[0]
        for wraps in (2**32 + int(first), -2**31 - 1, 2**31):
            with self.assertRaisesRegex(ValueError, "identities .* not %d" % wraps):
                self.sim.delete([wraps])
            self.assertRaises(ValueError, self.sim.gather, "x", [wraps])
            self.assertRaises(ValueError, self.sim.scatter, "vx", 1.0, [wraps])
        self.assertRaises(ValueError, self.sim.create, [[0.1, 0.1, 0.9]], type=2**32 + 1)
        self.assertIn(first, list(self.sim.tag))
        self.assertRaises(ValueError, self.sim.step, 1.5)
        self.assertRaises(ValueError, self.sim.value, "ke\0x")
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


class Vectors(Case):
    def test_three_numbers_for_each(self):
        sim = self.sim
        sim.step(50)
        for name, parts in (("x", "x y z"), ("v", "vx vy vz"), ("f", "fx fy fz"),
                            ("image", "ix iy iz")):
            whole = rows(sim.gather(name))
            self.assertEqual((len(whole), len(whole[0])), (len(sim), 3))
            for k, part in enumerate(parts.split()[1:], 1):
                self.assertEqual([row[k] for row in whole], list(sim.gather(part)))
        # by identity, whatever the order in memory
        memory = {int(tag): list(row) for tag, row in zip(sim.tag, sim.x.tolist())}
        self.assertEqual(rows(sim.gather("x")), [memory[k] for k in sorted(memory)])
        self.assertEqual(rows(sim.gather("x", [7, 3])), [memory[7], memory[3]])
        self.assertEqual(rows(sim.read("x")), sim.x.tolist())

    def test_written(self):
        sim = self.sim
        v = [[0.5 * k, -k, 2.385] for k in range(len(sim))]
        sim.scatter("v", v)
        self.assertEqual(rows(sim.gather("v")), v)
        sim.write("v", [1, 2, 3])
        self.assertEqual(rows(sim.read("v")), [[1, 2, 3]] * len(sim))
        sim.scatter("v", [[4, 5, 6]], ids=[9])
        self.assertEqual(rows(sim.gather("v", [9, 8])), [[4, 5, 6], [1, 2, 3]])
        self.assertRaises(ValueError, sim.write, "v", [1, 2])
        # all or none: a position that is no number
        x = rows(sim.gather("x"))
        self.assertRaises(tsim.TsimError, sim.scatter, "x",
                          [[0.1, 0.1, float("nan")]] + x[1:])
        self.assertEqual(rows(sim.gather("x")), x)


class Tables(Case):
    def test_log(self):
        self.assertEqual(len(self.sim.thermo), 0)
        self.sim.commands("thermo_style custom step ke v_a\nthermo 10\nvariable a equal step/3\nrun 35")
        log = self.sim.thermo
        self.assertEqual(list(log["Step"]), [0, 10, 20, 30, 35])
        self.assertEqual(log.row()["a"], 35 / 3)  # all digits
        self.assertEqual(log.row()[log.names[1]], self.sim.value("ke"))
        self.sim.commands("run 5")  # the same table: its first row is there already
        self.assertEqual(list(self.sim.thermo["Step"]), [0, 10, 20, 30, 35, 40])
        self.sim.step(25)           # rows at the intervals alone
        self.assertEqual(list(self.sim.thermo["Step"]), [0, 10, 20, 30, 35, 40, 50, 60])
        self.sim.commands("thermo_style custom step atoms\nrun 0")
        self.assertEqual(len(self.sim.thermo_tables), 2)
        self.assertEqual(self.sim.thermo.row(0), {"Step": 65, self.sim.thermo.names[1]: 294})
        with self.assertRaisesRegex(KeyError, "did you mean 'Step'"):
            log["step"]
        self.assertEqual(rows(log.array)[1][0], 10)
        self.assertIn("<th>Step</th>", log._repr_html_())

    def test_same_results_with_rows_told(self):
        with tsim.Simulation() as other:
            other.commands(PACKING)
            tsim._lib.tsim_on_row(other._pointer, type(other._rows._call)(), None)
            other.step(200)
            self.sim.step(200)
            self.assertEqual(len(other.thermo), 0)
            self.assertEqual(rows(self.sim.gather("x")), rows(other.gather("x")))

    def test_files(self):
        with tempfile.TemporaryDirectory() as folder:
            log, mean = os.path.join(folder, "log"), os.path.join(folder, "mean.txt")
            self.sim.commands("log %s\nfix mean all ave/time 5 2 10 c_k file %s\nthermo 10\n"
                              "run 20\nrun 20\nunfix mean\nlog none" % (log, mean))
            tables = tsim.read_tables(log)
            self.assertEqual([t.title for t in tables], ["run 1", "run 2"])
            self.assertEqual(list(tsim.read_table(log)["Step"]), [0, 10, 20, 30, 40])
            means = tsim.read_table(mean)
            self.assertEqual(len(means), 4)
            self.assertEqual(means.names[-1], "c_k")
            with self.assertRaises(tsim.TsimError) as caught:
                tsim.read_table(os.path.join(folder, "none"))
            self.assertEqual(caught.exception.code, tsim.Status.IO)
            with open(log, "w") as file:
                file.write("no numbers here\n")
            self.assertRaises(tsim.TsimError, tsim.read_tables, log)

    def test_outputs(self):
        self.sim.step(1500)
        pairs = self.sim.table("c_pairs")
        self.assertEqual(len(pairs), int(self.sim.compute("pairs")))
        self.assertEqual(pairs.names[:3], ["i", "j", "overlap"])
        self.assertEqual(list(pairs["overlap"]),
                         [row[2] for row in self.sim.compute("pairs", "local")])
        grains = self.sim.table("id", "radius", "x", "c_where[3]")
        self.assertEqual(grains.names, ["id", "radius", "x", "y", "z", "c_where[3]"])
        self.assertEqual(list(grains["id"]), sorted(self.sim.read("id")))
        self.assertEqual(list(grains["c_where[3]"]), list(self.sim.gather("vz")))
        touching = self.sim.table("c_pairs", shape="per_particle")
        self.assertEqual(len(touching), len(self.sim))
        self.assertEqual(self.sim.table("c_k").array[0][0], self.sim.compute("k"))
        self.assertRaises(ValueError, self.sim.table, "c_pairs", shape="array")
        self.assertRaises(ValueError, self.sim.table)
        self.assertRaises(tsim.TsimError, self.sim.table, "c_nix")

    def test_frames(self):
        try:
            import pandas
        except ImportError:
            self.skipTest("without pandas")
        if numpy is None:
            self.skipTest("without NumPy")
        self.sim.commands("thermo 10\nrun 20")
        frame = self.sim.thermo.frame("Step")
        self.assertIsInstance(frame, pandas.DataFrame)
        self.assertEqual(list(frame.index), [0, 10, 20])
        self.assertEqual(self.sim.table("id", "vz").frame().shape, (294, 2))


class Pictures(Case):
    def test_picture(self):
        picture = self.sim.picture(size=(120, 90))
        self.assertEqual(bytes(picture[:8]), b"\x89PNG\r\n\x1a\n")
        self.assertEqual(picture.size, (120, 90))
        self.assertEqual(picture._repr_png_(), bytes(picture))
        self.assertNotEqual(picture, self.sim.picture("vz", size=(120, 90)))
        with tempfile.TemporaryDirectory() as folder:
            picture.save(os.path.join(folder, "now.png"))
            self.assertEqual(os.path.getsize(os.path.join(folder, "now.png")), len(picture))
        self.assertRaises(tsim.TsimError, self.sim.picture, "colourful")

    def test_what_notebooks_show(self):
        self.assertIn("data:image/png;base64,", self.sim._repr_html_())
        self.assertIn("gravity", self.sim._repr_html_())
        self.assertEqual(repr(self.sim), "<tsim.Simulation: 294 particles, step 0, time 0>")
        with tsim.Simulation() as empty:
            self.assertEqual(empty._repr_html_(), "&lt;tsim.Simulation without a box&gt;")
        self.assertIn("closed", repr(empty))

    def test_results_are_the_same(self):
        with tsim.Simulation() as other:
            other.commands(PACKING)
            other.step(100)
            for _ in range(10):
                self.sim.step(10)
                self.sim._repr_html_()
            self.assertEqual(rows(self.sim.gather("x")), rows(other.gather("x")))

    def test_progress(self):
        from tsim import _pictures
        out, sys.stderr = sys.stderr, io.StringIO()
        before = _pictures.Progress.PATIENCE
        _pictures.Progress.PATIENCE = 0
        try:
            self.sim.step(3000, progress=True)
            told = sys.stderr.getvalue()
        finally:
            sys.stderr, _pictures.Progress.PATIENCE = out, before
        self.assertIn("33.3 %", told)
        self.assertTrue(told.endswith("\r"))
        self.assertFalse(_pictures.in_notebook())

    def test_notebook(self):
        try:
            import IPython
        except ImportError:
            self.skipTest("without IPython")
        from tsim import _pictures
        shown = []

        class Shell:
            kernel = True

        class Handle:
            def update(self, what):
                shown.append(what.data)

        def display(what, display_id):
            shown.append(what.data)
            return Handle()
        from IPython import display as module
        saved = IPython.get_ipython, module.display, _pictures.Progress.PATIENCE
        IPython.get_ipython, module.display, _pictures.Progress.PATIENCE = Shell, display, 0
        try:
            self.sim.step(2500)
            with tsim.Simulation() as told:  # its output is listened to
                told.commands(PACKING)
                with told._progress():
                    told._bar.line("25.0 %, step 5 of 20")
        finally:
            IPython.get_ipython, module.display, _pictures.Progress.PATIENCE = saved
        self.assertIn('<progress value="0.4000" max="1"></progress> step 1000', shown)
        self.assertIn('<progress value="0.2500" max="1"></progress> 25.0 %, step 5 of 20', shown)
        self.assertEqual(shown[-1], "")


# public methods of the class `lammps` of LAMMPS' Python module of January 2022, and of its `numpy`
METHODS = """
accelerator_config available_ids available_plugins available_styles close command commands_list commands_string
create_atoms decode_image_flags encode_image_flags extract_atom extract_atom_datatype extract_box extract_compute
extract_fix extract_global extract_global_datatype extract_setting extract_variable file finalize
find_compute_neighlist find_fix_neighlist find_pair_neighlist fix_external_get_force fix_external_set_energy_global
fix_external_set_energy_peratom fix_external_set_vector fix_external_set_vector_length fix_external_set_virial_global
fix_external_set_virial_peratom force_timeout gather gather_atoms gather_atoms_concat gather_atoms_subset gather_bonds
gather_concat gather_subset get_gpu_device_info get_mpi_comm get_natoms get_neighlist get_neighlist_element_neighbors
get_neighlist_size get_os_info get_thermo has_exceptions has_ffmpeg_support has_gpu_device has_gzip_support has_id
has_jpeg_support has_mpi_support has_png_support has_style installed_packages is_running numpy reset_box scatter
scatter_atoms scatter_atoms_subset scatter_subset set_fix_external_callback set_variable version
""".split()
NUMPY_METHODS = """
extract_atom extract_compute extract_fix extract_variable fix_external_get_force fix_external_set_energy_peratom
fix_external_set_virial_peratom gather_bonds get_neighlist get_neighlist_element_neighbors
""".split()


class Lammps(Case):
    """The names of LAMMPS and LIGGGHTS."""

    def test_all_names(self):
        self.assertEqual([len(METHODS), len(NUMPY_METHODS)], [68, 10])
        self.assertEqual([name for name in METHODS if not callable(getattr(self.sim, name, None))
                          and not isinstance(getattr(tsim.lammps, name, None), property)], [])
        self.assertEqual([name for name in NUMPY_METHODS if not callable(getattr(self.sim.numpy, name, None))], [])
        manual = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "doc", "python.md")
        with open(manual, encoding="utf-8") as file:
            words = set(re.findall(r"\w+", file.read()))
        self.assertEqual(sorted(set(METHODS + NUMPY_METHODS) - words), [])

    def setUp(self):
        self.sim = tsim.lammps(cmdargs=["-log", "none", "-screen", "none", "-var", "n", "3",
                                        "-nocite"])
        self.sim.commands_string(PACKING)

    def test_scripts(self):
        lmp = self.sim
        self.assertEqual(lmp.extract_variable("n"), 3)
        lmp.command("variable a equal 2*3")
        lmp.commands_list(["variable b string text", "variable c atom x+1", "variable d vector [1,2,3]"])
        self.assertEqual(lmp.extract_variable("a"), 6)
        self.assertEqual(lmp.extract_variable("b"), "text")
        self.assertEqual(list(lmp.extract_variable("d")), [1, 2, 3])
        c = lmp.extract_variable("c", "all", tsim.LMP_VAR_ATOM)
        self.assertEqual(list(c), [row[0] + 1 for row in lmp.read("x")])
        lmp.set_group("few", [k < 3 for k in range(len(lmp))])
        c = lmp.extract_variable("c", "few")
        self.assertEqual([value != 0 for value in c], [k < 3 for k in range(len(lmp))])
        self.assertRaises(tsim.TsimError, lmp.extract_variable, "nix")
        lmp.set_variable("b", "other")
        self.assertEqual(lmp.extract_variable("b"), "other")
        lmp.set_internal_variable("third", 1 / 3)
        self.assertEqual(lmp.eval("v_third"), 1 / 3)
        with self.assertRaises(tsim.TsimError) as caught:
            lmp.command("fix a all gravty 9.81")
        self.assertEqual((caught.exception.file, caught.exception.line), ("command", 1))
        lmp.cmd.run(10)
        self.assertEqual(lmp.extract_global("ntimestep"), 10)
        self.assertEqual(lmp.last_thermo()["Step"], 10)
        self.assertEqual(lmp.get_thermo("ke"), lmp.value("ke"))
        self.assertRaises(ValueError, tsim.lammps, cmdargs=["-nonsense"])
        self.assertRaises(ValueError, tsim.lammps, comm=1)
        self.assertRaises(RuntimeError, lmp.error, 0, "bad")
        self.assertIsInstance(lmp.version(), int)
        self.assertFalse(lmp.is_running())

    def test_globals(self):
        lmp = self.sim
        self.assertEqual(lmp.get_natoms(), 294)
        self.assertEqual(lmp.extract_global("natoms"), 294)
        self.assertEqual(lmp.extract_global("boxxhi"), 0.385)
        self.assertEqual(lmp.extract_global("boxhi"), [0.385, 0.4, 1.0])
        self.assertEqual(lmp.extract_global("dt"), 2e-4)
        self.assertEqual(lmp.extract_global_datatype("dt"), tsim.LAMMPS_DOUBLE)
        self.assertEqual(lmp.extract_global_datatype("nix"), -1)
        self.assertRaises(ValueError, lmp.extract_global, "nix")
        self.assertEqual(lmp.extract_setting("ntypes"), 2)
        self.assertEqual(lmp.extract_setting("world_size"), 1)
        self.assertRaises(tsim.TsimError, lmp.extract_setting, "nix")
        for name in ("xy", "nbonds", "nmax", "triclinic", "periodicity", "atime"):
            lmp.extract_global(name)
        self.assertEqual(lmp.extract_box(), [[0, 0, 0], [0.385, 0.4, 1.0], 0, 0, 0, [1, 0, 0], 0])
        lmp.reset_box([0, 0, 0], [0.385, 0.5, 1.0])
        self.assertEqual(lmp.box.hi, (0.385, 0.5, 1.0))
        self.assertRaises(ValueError, lmp.reset_box, [0, 0, 0], [1, 1, 1], 0.1)

    def test_atoms(self):
        lmp = self.sim
        lmp.command("run 50")
        self.assertEqual(lmp.extract_atom("x").tolist(), lmp.view("x").tolist())
        self.assertEqual(list(lmp.extract_atom("id")), list(lmp.tag))
        self.assertEqual(list(lmp.extract_atom("rmass")), list(lmp.read("mass")))
        self.assertEqual(lmp.extract_atom_datatype("x"), tsim.LAMMPS_DOUBLE_2D)
        self.assertEqual(lmp.extract_atom_datatype("id"), tsim.LAMMPS_INT)
        self.assertEqual(lmp.extract_atom_size("v", tsim.LMP_SIZE_COLS), 3)
        with self.assertRaisesRegex(ValueError, "'mass' is not known.*rmass"):
            lmp.extract_atom("mass")  # of types there
        x = lmp.gather_atoms("x", 1, 3)
        self.assertEqual(list(x), [value for row in lmp.gather("x", 1, 3).reshape(-1, 3)
                                   for value in row] if numpy is not None else list(x))
        self.assertEqual(list(x[3:6]), rows(tsim.Simulation.gather(lmp, "x", [2]))[0])
        self.assertEqual(list(lmp.gather_atoms("id", 0, 1)), list(range(1, 295)))
        self.assertEqual(list(lmp.gather_atoms_concat("id", 0, 1)), list(lmp.tag))
        self.assertEqual(list(lmp.gather_atoms_subset("id", 0, 1, 2, [9, 4])), [9, 4])
        lmp.command("group pair id 4 9")
        bits = list(lmp.gather_atoms("mask", 0, 1))
        self.assertEqual([k + 1 for k in range(294) if bits[k] != bits[0]], [4, 9])
        self.assertEqual(bits[3], lmp.gather_atoms_subset("mask", 0, 1, 1, [9])[0])
        self.assertEqual(list(lmp.gather_atoms_concat("mask", 0, 1)), list(lmp.view("mask")))
        packed = list(lmp.gather_atoms("image", 0, 1))
        self.assertEqual(lmp.decode_image_flags(packed[6]), list(lmp.gather_atoms("image", 0, 3))[18:21])
        self.assertRaises(ValueError, lmp.gather_atoms, "x", 1, 1)
        self.assertRaises(ValueError, lmp.gather_atoms, "x", 0, 3)
        self.assertRaises(ValueError, lmp.gather_atoms, "id", 1, 1)
        self.assertRaises(ValueError, lmp.gather_atoms_subset, "x", 1, 3, 2, [1])
        v = [0.125 * k for k in range(3 * 294)]
        lmp.scatter_atoms("v", 1, 3, v)
        self.assertEqual(list(lmp.gather_atoms("v", 1, 3)), v)
        lmp.scatter_atoms_subset("v", 1, 3, 1, [5], [7, 8, 9])
        self.assertEqual(list(lmp.gather_atoms_subset("v", 1, 3, 1, [5])), [7, 8, 9])
        self.assertRaises(ValueError, lmp.scatter_atoms, "v", 1, 3, v[1:])
        tags = list(lmp.tag)
        self.assertEqual(lmp.map_atom(tags[17]), 17)
        self.assertIsNone(lmp.map_atom(99999))
        ids = list(lmp.gather("id", 0, 1))
        where = lmp.gather("c_where", 1, 3)
        self.assertEqual([where[3 * k] for k in range(3)], ids[:3])

    def test_outputs(self):
        lmp = self.sim
        lmp.command("run 1500")
        glob, atom, local = tsim.LMP_STYLE_GLOBAL, tsim.LMP_STYLE_ATOM, tsim.LMP_STYLE_LOCAL
        scalar, vector, table = tsim.LMP_TYPE_SCALAR, tsim.LMP_TYPE_VECTOR, tsim.LMP_TYPE_ARRAY
        self.assertEqual(lmp.extract_compute("k", glob, scalar), lmp.value("c_k"))
        self.assertEqual(rows(lmp.numpy.extract_compute("where", atom, table)),
                         rows(lmp.compute("where")))
        pairs = lmp.extract_compute("pairs", local, table)
        self.assertEqual(lmp.extract_compute("pairs", local, tsim.LMP_SIZE_ROWS), len(pairs))
        self.assertEqual(lmp.extract_compute("pairs", local, tsim.LMP_SIZE_COLS), len(pairs[0]))
        self.assertRaises(ValueError, lmp.extract_compute, "where", atom, vector)
        self.assertRaises(ValueError, lmp.extract_compute, "where", 7, vector)
        self.assertRaises(tsim.TsimError, lmp.extract_compute, "nix", glob, scalar)
        trace = lmp.fix("trace")
        self.assertEqual(lmp.extract_fix("trace", glob, vector, 3), trace[3])
        self.assertEqual(lmp.numpy.extract_fix("trace", glob, vector, 0), trace[0])
        self.assertTrue(lmp.has_id("fix", "trace"))
        self.assertFalse(lmp.has_id("compute", "trace"))
        self.assertIn("all", lmp.available_ids("group"))
        self.assertTrue(lmp.has_style("fix", "gravity"))
        self.assertFalse(lmp.has_style("fix", "gravty"))
        self.assertRaises(ValueError, lmp.has_style, "fixes", "gravity")
        for name in ("has_exceptions", "has_png_support", "has_gzip_support"):
            self.assertTrue(getattr(lmp, name))
        self.assertFalse(lmp.has_mpi_support)
        self.assertIn("gsl", lmp.installed_packages)

    def near(self, skin):
        """Pairs nearer than the skin by a search among all, x being periodic: ids, and how often."""
        lmp = self.sim
        x, radius, length = rows(lmp.read("x")), list(lmp.read("radius")), lmp.box.hi[0] - lmp.box.lo[0]
        found = {}
        for i in range(len(x)):
            for j in range(i + 1):
                for turn in (-1, 0, 1):
                    d = [x[i][0] - x[j][0] + turn * length, x[i][1] - x[j][1], x[i][2] - x[j][2]]
                    inside = sum(c * c for c in d) < (radius[i] + radius[j] + skin)**2
                    if inside and (i != j or turn > 0):
                        pair = tuple(sorted((i, j)))
                        found[pair] = found.get(pair, 0) + 1
        return found

    def listed(self):
        pairs = {}
        for i, n, partners in self.sim.get_neighlist(0):
            self.assertEqual(n, len(partners))
            for j in partners:
                pair = tuple(sorted((i, j)))
                pairs[pair] = pairs.get(pair, 0) + 1
        return pairs

    def test_neighbour_lists(self):
        lmp = self.sim
        with self.assertRaisesRegex(tsim.TsimError, "run 0"):
            lmp.get_neighlist(0)
        lmp.command("compute n all neighbor/atom")  # the list has the given skin
        for skin in (0.0238, 0.05):
            lmp.commands_string("neighbor %g bin\nset atom 1*9 diameter 0.09\nrun 0" % skin)
            brute = self.near(skin)
            self.assertGreater(len(brute), 600)
            self.assertEqual(self.listed(), brute)
        lmp.commands_string("set group all diameter 0.0523\nrun 300")
        self.assertEqual(lmp.get_neighlist_size(0), 294)
        rows_of = lmp.get_neighlist(0)
        self.assertEqual((len(rows_of), rows_of.size), (294, 294))
        self.assertEqual(rows_of[7], lmp.get_neighlist_element_neighbors(0, 7))
        self.assertEqual(rows_of.find(7), rows_of.get(7)[1:])
        self.assertEqual(rows_of.find(294), (-1, None))
        self.assertRaises(IndexError, rows_of.get, 294)
        self.assertRaises(IndexError, rows_of.get, -1)
        self.assertIn("294 particles", str(rows_of))
        i, partners = lmp.numpy.get_neighlist_element_neighbors(0, 7) if numpy is not None else rows_of[7][::2]
        self.assertEqual((i, list(partners)), (7, rows_of[7][2]))
        self.assertRaises(ValueError, lmp.get_neighlist, 1)
        self.assertEqual(lmp.get_neighlist_size(1), -1)
        seen = []

        def look(sim):
            seen.append(sum(n for _, n, _ in sim.get_neighlist(0)))
        lmp.on_step("after_force", look)
        lmp.step(2)
        self.assertGreaterEqual(len(seen), 2)  # also for the first forces
        self.assertGreater(seen[0], 600)
        lmp.create([[0.1, 0.1, 0.9]], radius=0.01)
        self.assertRaises(tsim.TsimError, lmp.get_neighlist_size, 0)

    def test_small_periodic_boxes(self):
        lmp = self.sim
        lmp.commands_string("""
            clear
            boundary p f f
            region b block 0 0.11 0 1 0 1 units box
            create_box 1 b
            create_atoms 1 single 0.02 0.5 0.5 units box
            create_atoms 1 single 0.09 0.5 0.5 units box
            set group all diameter 0.05 density 2385
            pair_style spring/dashpot
            pair_coeff * * stiffness 2385 restitution 0.5
            neighbor 0.0238 bin
            compute n all neighbor/atom
            fix m all nve
            run 0""")
        self.assertEqual(self.listed(), self.near(0.0238))
        self.assertEqual(self.listed(), {(0, 1): 2})  # once directly, once across the face

    def test_finding_neighbour_lists(self):
        lmp = self.sim
        self.assertEqual(lmp.find_pair_neighlist("spring/dashpot"), 0)
        self.assertEqual(lmp.find_pair_neighlist("spring"), -1)
        self.assertEqual(lmp.find_pair_neighlist("spring", exact=False), 0)
        self.assertEqual(lmp.find_pair_neighlist("spring/dashpot", nsub=2), -1)
        self.assertEqual(lmp.find_pair_neighlist("spring/dashpot", reqid=1), -1)
        self.assertEqual(lmp.find_compute_neighlist("pairs"), 0)
        self.assertEqual([lmp.find_compute_neighlist(name) for name in ("k", "nix")], [-1, -1])
        self.assertEqual([lmp.find_fix_neighlist(name) for name in ("g", "nix")], [-1, -1])
        lmp.commands_string("clear\nboundary f f f\nregion b block 0 1 0 1 0 1 units box\ncreate_box 1 b\nrun 0")
        self.assertEqual(lmp.find_pair_neighlist("spring/dashpot"), -1)
        with self.assertRaisesRegex(tsim.TsimError, "no contact list"):
            lmp.get_neighlist(0)

    def test_create(self):
        lmp = self.sim
        n = len(lmp)
        self.assertEqual(lmp.create_atoms(2, None, [1, 2], [0.1, 0.1, 0.8, 0.2, 0.2, 0.8]), 2)
        self.assertEqual(lmp.create_atoms(1, [n + 3], [1], [0.1, 0.2, 0.9], [1, 2, 3],
                                          [lmp.encode_image_flags(1, 0, 0)]), 1)
        self.assertEqual(list(lmp.gather_atoms_subset("v", 1, 3, 1, [n + 3])), [1, 2, 3])
        self.assertEqual(list(lmp.gather_atoms_subset("image", 0, 3, 1, [n + 3])), [1, 0, 0])
        self.assertRaises(ValueError, lmp.create_atoms, 1, [7], [1], [0.3, 0.1, 0.9])
        self.assertEqual(len(lmp), n + 3)
        self.assertEqual(lmp.decode_image_flags(lmp.encode_image_flags(-3, 4, 511)), [-3, 4, 511])
        self.assertRaises(ValueError, lmp.encode_image_flags, 512, 0, 0)

    def test_external_forces(self):
        lmp = tsim.lammps(cmdargs=["-screen", "none"])
        lmp.commands_string(SINGLE + "fix g all gravity 9.81 vector 0 0 -1")

        def lift(mass, step, n, tag, x, f):
            for k in range(n):
                f[k][2] += 9.81 * mass
        lmp.set_fix_external_callback("up", lift, lmp.read("mass")[0])
        lmp.command("run 500")
        self.assertAlmostEqual(lmp.value("z[1]"), 2.385, places=12)
        lmp.set_fix_external_callback("up", None)
        lmp.command("run 10")
        self.assertLess(lmp.value("vz[1]"), -0.09)
        lmp.close()

    def test_fix_external(self):
        lmp = tsim.lammps(cmdargs=["-screen", "none"])
        lmp.commands_string(SINGLE + "group none empty\nfix up all external pf/callback 2 1\n"
                            "fix held none external pf/array 1\nfix_modify up energy yes\ncompute pe all pe")
        self.assertRaisesRegex(tsim.TsimError, "no program gives the forces", lmp.command, "run 1")
        steps, first = [], lmp.extract_global("ntimestep")

        def push(caller, step, n, tag, x, f):
            steps.append(step - first)
            for k in range(n):
                f[k][2] = 1e-3 * len(steps)
            lmp.fix_external_set_energy_global("up", 5.0)
        lmp.set_fix_external_callback("up", push)
        lmp.command("run 5")
        # it is called in each second step, and what it gave acts in the step without a call, too
        self.assertEqual(steps, [0, 2, 4])
        self.assertEqual(list(lmp.gather_atoms("f", 1, 3)), [0, 0, 3e-3])
        self.assertEqual([lmp.get_thermo("c_pe"), lmp.value("f_up")], [5, 5])
        for row in lmp.fix_external_get_force("held"):
            row[0] = 2.0
        lmp.command("run 1")
        self.assertEqual(lmp.gather_atoms("f", 1, 3)[0], 0)  # its group is empty
        lmp.commands_string("unfix held\nfix held all external pf/array 1")
        for row in lmp.numpy.fix_external_get_force("held"):
            row[0] = 2.0
        lmp.command("run 1")
        self.assertEqual(lmp.gather_atoms("f", 1, 3)[0], 2)
        lmp.command("create_atoms 1 single 0.4 0.4 2.4 units box")
        lmp.command("run 1")  # the array belongs to the particle it was taken for
        self.assertEqual([lmp.gather_atoms("f", 1, 3)[k] for k in (0, 3)], [2, 0])
        lmp.fix_external_set_vector_length("up", 3)
        lmp.fix_external_set_vector("up", 2, 7.5)
        self.assertEqual([lmp.value("f_up[%d]" % k) for k in (1, 2, 3)], [0, 7.5, 0])
        lmp.fix_external_set_energy_peratom("up", [1, 2])
        self.assertEqual(list(lmp.evaluate("f_up[4]", "per_particle")), [1, 2])
        self.assertRaisesRegex(ValueError, "which has 3", lmp.fix_external_set_vector, "up", 4, 1)
        self.assertRaisesRegex(tsim.TsimError, "1 numbers given as 'energies', expected 2",
                               lmp.fix_external_set_energy_peratom, "up", [1])
        self.assertRaisesRegex(tsim.TsimError, "takes no numbers", lmp.fix_external_set_energy_global, "m", 1)
        self.assertRaisesRegex(tsim.TsimError, "no fix 'nix'", lmp.fix_external_set_energy_global, "nix", 1)
        self.assertRaises(NotImplementedError, lmp.fix_external_set_virial_global, "up", [0] * 6)
        self.assertRaises(NotImplementedError, lmp.fix_external_set_virial_peratom, "up", [[0] * 6] * 2)
        lmp.close()


if __name__ == "__main__":
    result = unittest.main(exit=False, verbosity=1).result
    bad = len(result.failures) + len(result.errors)
    print("%d passed, %d failed" % (result.testsRun - bad - len(result.skipped), bad))
    sys.exit(bad != 0)
