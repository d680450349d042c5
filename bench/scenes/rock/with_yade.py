# The block of bench/race by Yade: `yade -j1 -n -x with_yade.py STEPS OUT LOG`.
import sys, time
from math import pi
from yade import *
from yade import utils

steps, out, log = int(sys.argv[1]), sys.argv[2], open(sys.argv[3], "w")
# normal stiffness E R of two equal spheres, shear by normal stiffness 0.4, moments by shear stiffness times R^2
O.materials.append(CohFrictMat(
    young=2 * 1000 * pi / 4, poisson=0.4, density=1, frictionAngle=0.46, isCohesive=True, normalCohesion=1e9,
    shearCohesion=1e9, momentRotationLaw=True, alphaKr=0.625, alphaKtw=0.5, etaRoll=-1, etaTwist=-1))
for line in open("block"):
    b = [float(x) for x in line.split()]
    k = O.bodies.append(utils.sphere(b[3:6], b[2] / 2))
    O.bodies[k].state.vel, O.bodies[k].state.angVel = b[6:9], b[9:12]
O.dt = 0.002
make = Ip2_CohFrictMat_CohFrictMat_CohFrictPhys(setCohesionNow=True)
reach = Bo1_Sphere_Aabb(aabbEnlargeFactor=1.001)
touch = Ig2_Sphere_Sphere_ScGeom6D(interactionDetectionFactor=1.001)
O.engines = [
    ForceResetter(),
    InsertionSortCollider([reach], verletDist=0.075),
    InteractionLoop([touch], [make], [Law2_ScGeom6D_CohFrictPhys_CohesionMoment()]),
    NewtonIntegrator(damping=0),
]
O.engines[-1].dead = True
O.step()  # makes the bonds
O.engines[-1].dead = False
reach.aabbEnlargeFactor = touch.interactionDetectionFactor = 1
for i in O.interactions:
    i.phys.unp = i.geom.penetrationDepth  # free of force as it is
bonds = O.interactions.countReal()

begin = time.time()
O.run(steps, True)
log.write("Loop time of %g on 1 procs for %d steps with %d atoms, %d bonds\n" % (
    time.time() - begin, steps, len(O.bodies), bonds))
ke = spin = 0
with open(out, "w") as f:
    f.write("ITEM\n" * 9)
    for p in O.bodies:
        x, v, w = p.state.pos, p.state.vel, p.state.angVel
        ke += p.state.mass / 2 * v.dot(v)
        spin += p.state.inertia[0] / 2 * w.dot(w)
        f.write("%d %.15g %.15g %.15g %.15g %.15g %.15g\n" % (p.id + 1, x[0], x[1], x[2], v[0], v[1], v[2]))
log.write("0 %d 1 1\n%d %d %.15g %.15g\n" % (len(O.bodies), steps, len(O.bodies), ke, spin))
log.close()
