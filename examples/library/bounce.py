"""A ball that bounces: the restitution of every hit, seen from Python.

    python3 bounce.py [PLOT]

Needs only Python; PLOT (.png or .svg) also NumPy and Matplotlib.
"""
import math
import sys

import tsim

RADIUS, HEIGHT, RESTITUTION, GRAVITY, DURATION = 0.02385, 0.385, 0.8, 9.81, 1.5

BOX = """
units si
boundary f f f
region box block -0.1 0.1 -0.1 0.1 0 1 units box
create_box 1 box
"""
PHYSICS = """
pair_style spring/dashpot
pair_coeff * * stiffness 1e5 restitution ${e}
fix move all nve
fix weight all gravity ${g} vector 0 0 -1
fix floor all wall/gran primitive type 1 zplane 0.0
timestep 1e-5
"""


def bounce(duration):
    """Times, heights above rest, and the speeds before and after each hit."""
    times, heights, hits = [], [], []
    with tsim.Simulation() as sim:
        sim.variables["e"], sim.variables["g"] = RESTITUTION, GRAVITY
        sim.commands(BOX, name="box")
        sim.create([[0, 0, RADIUS + HEIGHT]], radius=RADIUS, density=2385)
        sim.commands(PHYSICS, name="physics")
        before = None

        @sim.on_step("end_of_step")
        def watch(sim):
            nonlocal before
            z, vz = sim.x[0, 2] - RADIUS, sim.v[0, 2]
            if z < 0 and before is None:
                before = vz
            elif z > 0 and before is not None:
                hits.append((before, vz))
                before = None

        while sim.clock.time < duration:
            sim.step(200)
            times.append(sim.clock.time)
            heights.append(sim.x[0, 2] - RADIUS)
    return times, heights, hits


def leaps():
    """When the ball leaves the floor, and how fast, if hits take no time."""
    speed = math.sqrt(2 * GRAVITY * HEIGHT)
    t, found = speed / GRAVITY, []
    while t < DURATION:
        speed *= RESTITUTION
        found.append((t, speed))
        t += 2 * speed / GRAVITY
    return found


def plot(path, times, heights):
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(figsize=(6.4, 3.2), layout="constrained")
    axes.plot(times, heights, color="#1f5a8c", label="tsim")
    tops = [(0, HEIGHT)] + [(t + v / GRAVITY, v ** 2 / (2 * GRAVITY)) for t, v in leaps()]
    tops = [top for top in tops if top[0] < DURATION]
    axes.plot(*zip(*tops), "o", color="#c2501e", mfc="none", label=r"$h\,e^{2k}$")
    axes.set(xlabel="time (s)", ylabel="height (m)", xlim=(0, times[-1]), ylim=(0, None))
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)
    axes.legend(frameon=False)
    figure.savefig(path, dpi=150)


def result(name, value, reference, tolerance):
    ok = abs(value - reference) <= tolerance * abs(reference)
    print("RESULT %s %.6g %.6g %.3g %s" % (name, value, reference, tolerance, "ok" if ok else "off"))
    return ok


def main(arguments):
    times, heights, hits = bounce(DURATION)
    good = result("hits", len(hits), len(leaps()), 0)
    for k, (before, after) in enumerate(hits[:3]):
        good &= result("restitution_%d" % (k + 1), -after / before, RESTITUTION, 5e-3)
    good &= result("first_speed", -hits[0][0], math.sqrt(2 * GRAVITY * HEIGHT), 1e-3)
    if arguments:
        plot(arguments[0], times, heights)
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
