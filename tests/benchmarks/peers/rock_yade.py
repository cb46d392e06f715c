# Bonded rock in YADE: the cube of rock_lammps.in with JCFpm bonds (normal and shear springs, Mohr-Coulomb with a
# tension cut-off, no moments). Environment: CELLS (a side), COUNT (steps).
import os, random, time
from yade import utils

cells, count = int(os.environ['CELLS']), int(os.environ['COUNT'])
pitch = 0.1 * 2**0.5
rock = O.materials.append(JCFpmMat(type=1, young=1e9, poisson=0.3, frictionAngle=0.5, density=2500,
                                   tensileStrength=1e9, cohesion=1e9))
random.seed(1)
for i in range(cells):
    for j in range(cells):
        for k in range(cells):
            for a, b, c in ((0, 0, 0), (0.5, 0.5, 0), (0.5, 0, 0.5), (0, 0.5, 0.5)):
                at = ((i + a) * pitch, (j + b) * pitch, (k + c) * pitch)
                body = utils.sphere(at, 0.05, material=rock)
                body.state.vel = [random.uniform(-5e-4, 5e-4) for axis in range(3)]
                O.bodies.append(body)

reach = 1.1  # bonds at the first step: all within this many diameters
O.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb(aabbEnlargeFactor=reach, label='aabb')], verletDist=0.005),
    InteractionLoop([Ig2_Sphere_Sphere_ScGeom(interactionDetectionFactor=reach, label='geometry')],
                    [Ip2_JCFpmMat_JCFpmMat_JCFpmPhys(cohesiveTresholdIteration=1)],
                    [Law2_ScGeom_JCFpmPhys_JointedCohesiveFrictionalPM()]),
    NewtonIntegrator(damping=0)]
O.dt = 1e-5
O.run(1, True)
aabb.aabbEnlargeFactor = geometry.interactionDetectionFactor = -1
O.run(9, True)
start = time.process_time()
O.run(count, True)
print('seconds rock', time.process_time() - start)
print('atoms', len(O.bodies), 'bonds', sum(1 for i in O.interactions if i.isReal and i.phys.isCohesive), flush=True)
os._exit(0)
