# The block of bench/race by ESyS-Particle, with one worker: `mpirun -np 2 esysparticle with_esys.py STEPS OUT LOG`.
import os, sys, time
from esys.lsm import *
from esys.lsm.geometry import ConnectionFinder, SimpleSphere
from esys.lsm.util import Vec3, BoundingBox
from math import pi

sys.excepthook = lambda *what: (sys.__excepthook__(*what), os._exit(1))  # else the worker waits for ever
steps, out, log = int(sys.argv[1]), sys.argv[2], open(sys.argv[3], "w")
ball = [line.split() for line in open("block")]
sim = LsmMpi(numWorkerProcesses=1, mpiDimList=[1, 1, 1])
sim.initNeighbourSearch(particleType="RotSphere", gridSpacing=1.4, verletDist=0.15)
sim.setTimeStepSize(0.002)
high = [max(float(b[k]) for b in ball) + 5 for k in (3, 4, 5)]
sim.setSpatialDomain(BoundingBox(Vec3(-5, -5, -5), Vec3(*high)))
spheres, places = [], []
for b in ball:
    at, v = [float(x) for x in b[3:6]], [float(x) for x in b[6:12]]
    p = RotSphere(id=int(b[0]), posn=Vec3(*at), radius=float(b[2]) / 2, mass=pi / 6)
    p.setLinearVelocity(Vec3(*v[0:3]))
    p.setAngularVelocity(Vec3(*v[3:6]))
    spheres.append(p)
    places.append(SimpleSphere(centre=Vec3(*at), radius=float(b[2]) / 2, id=int(b[0]), tag=0))
sim.createParticles(spheres)
sim.createConnections(ConnectionFinder(maxDist=0.001, bondTag=0, pList=places))
sim.setParticleDensity(tag=0, mask=-1, Density=1)
area, bending = pi / 4, pi / 64  # of a section of radius 0.5
sim.createInteractionGroup(RotBondPrms(
    name="bonds", normalK=1000 * area, shearK=400 * area, bendingK=1000 * bending, torsionK=2 * 400 * bending,
    normalBrkForce=1e6, shearBrkForce=1e6, bendingBrkForce=1e6, torsionBrkForce=1e6, tag=0, scaling=False))
sim.createInteractionGroup(RotFrictionPrms(
    name="friction", normalK=2000, dynamicMu=0.5, staticMu=0.5, shearK=2000 * 2 / 7, scaling=False))
sim.createExclusion("bonds", "friction")

sim.createCheckPointer(CheckPointPrms(
    fileNamePrefix="snap", beginTimeStep=steps, endTimeStep=steps, timeStepIncr=steps))
begin = time.time()
sim.setNumTimeSteps(steps)
sim.run()
log.write("Loop time of %g on 1 procs for %d steps with %d atoms\n" % (time.time() - begin, steps, len(ball)))
log.write("0 %d 0 0\n%d %d 0 0\n" % (len(ball), steps, len(ball)))
log.close()
