# The clumps of clumps_liggghts.in in YADE: clumps and Hertz-Mindlin with the same constants.
# Environment: START (its dump), SETTLE, COUNT (steps), SIDE (m).
import os, time
from yade import utils

settle, count = int(os.environ['SETTLE']), int(os.environ['COUNT'])
side = float(os.environ['SIDE'])
rock = O.materials.append(FrictMat(young=1e7, poisson=0.25, frictionAngle=0.4636, density=2500))

clumps = {}
with open(os.environ['START']) as dump:
    for line in dump.readlines()[9:]:
        words = line.split()
        clumps.setdefault(words[1], []).append(([float(w) for w in words[2:5]], float(words[5])))
for spheres in clumps.values():
    O.bodies.appendClumped([utils.sphere(at, radius, material=rock) for at, radius in spheres])
for axis, at, sense in ((0, 0, 1), (0, side, -1), (1, 0, 1), (1, side, -1), (2, 0, 1)):
    O.bodies.append(utils.wall(at, axis, sense, material=rock))

O.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb(), Bo1_Wall_Aabb()], verletDist=0.015),
    InteractionLoop([Ig2_Sphere_Sphere_ScGeom(), Ig2_Wall_Sphere_ScGeom()],
                    [Ip2_FrictMat_FrictMat_MindlinPhys(en=0.3, es=0.3)], [Law2_ScGeom_MindlinPhys_Mindlin()]),
    NewtonIntegrator(gravity=(0, 0, -9.81), damping=0)]
O.dt = 2e-4


def timed(name):
    start = time.process_time()
    O.run(count, True)
    print('seconds', name, time.process_time() - start, flush=True)


O.run(1, True)
timed('fall')
O.run(settle - count, True)
timed('pile')
spheres = [i for i in O.interactions if i.isReal and
           isinstance(O.bodies[i.id1].shape, Sphere) and isinstance(O.bodies[i.id2].shape, Sphere)]
print('touches', 2 * len(spheres))
os._exit(0)
