#!/usr/bin/python3
"""Compares two dump files.

usage: compare.py FILE FILE UNTIL TOLERANCE [SPREAD]

Up to step UNTIL every column may deviate by TOLERANCE times the largest magnitude it has so far (of
a vector, that of its three components together). With SPREAD the means of the last frame may deviate
by that fraction: of the height, of the kinetic energy. Prints the largest deviations."""
import sys

VECTORS = {'x': 'xyz', 'v': ('vx', 'vy', 'vz'), 'f': ('fx', 'fy', 'fz'),
           'omega': ('omegax', 'omegay', 'omegaz'), 'torque': ('tqx', 'tqy', 'tqz')}


def frames(name):
    with open(name, encoding='ascii') as lines:
        for line in lines:
            if not line.startswith('ITEM: TIMESTEP'):
                continue
            step = int(next(lines))
            next(lines)
            count = int(next(lines))
            while not line.startswith('ITEM: ATOMS'):
                line = next(lines)
            names = line.split()[2:]
            rows = [[float(word) for word in next(lines).split()] for _ in range(count)]
            yield step, {c: [row[k] for row in rows] for k, c in enumerate(names)}


def mean(frame, name):
    return sum(frame[name]) / len(frame[name])


def speed2(frame):
    return sum(u * u for name in VECTORS['v'] for u in frame[name]) / len(frame['id'])


def main():
    until, tolerance = int(sys.argv[3]), float(sys.argv[4])
    spread = float(sys.argv[5]) if len(sys.argv) > 5 else None
    most = dict.fromkeys(VECTORS, 0.0)
    scale = dict.fromkeys(VECTORS, 0.0)
    problems = []
    count, v2 = 0, [0.0, 0.0]
    for (step, a), (other, b) in zip(frames(sys.argv[1]), frames(sys.argv[2]), strict=True):
        count += 1
        if step != other or a['id'] != b['id'] or a['type'] != b['type']:
            sys.exit(f'step {step}: not the same frames or particles')
        v2 = [v2[0] + speed2(a), v2[1] + speed2(b)]
        if step > until:
            continue
        for vector, names in VECTORS.items():
            if names[0] not in a:
                scale.pop(vector, None)
                continue
            for name in names:
                scale[vector] = max([scale[vector]] + [abs(u) for u in a[name]])
                most[vector] = max([most[vector]] +
                                   [abs(u - w) for u, w in zip(a[name], b[name])])
    for vector, largest in scale.items():
        if largest == 0 and vector in 'xvf':
            problems.append(f'{vector} is 0 everywhere: nothing is compared')
        elif most[vector] > tolerance * largest:
            problems.append(f'{vector} deviates')
    print(f'{count} frames,', ', '.join(
        f'{vector} {most[vector] / (scale[vector] or 1):.1e}' for vector in scale))
    if count < 2:
        problems.append('no frames')
    if spread is not None:
        z = mean(a, 'z'), mean(b, 'z')
        print(f'mean z at the end {z[0]:.6g} {z[1]:.6g}, '
              f'mean v^2 {v2[0] / count:.6g} {v2[1] / count:.6g}')
        if abs(z[0] - z[1]) > spread * abs(z[0]):
            problems.append('the mean height differs')
        if abs(v2[0] - v2[1]) > spread * v2[0]:
            problems.append('the mean energy differs')
    sys.exit('; '.join(problems) or 0)


main()
