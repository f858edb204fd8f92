#!/usr/bin/env python3
"""Shapes for curved slicing: whole programs with all checks against planar slicing of the same mesh, as a table in Markdown.

    bench/curved_shapes.py PROGRAM EXAMPLES [SAMPLES] [--keep FOLDER]

PROGRAM is the published program, EXAMPLES the folder examples/models. SAMPLES may hold vase, Y_shape and costa_surface of compas_slicer as NAME.obj with
NAME_LOW.json and NAME_HIGH.json, the vertices of their ends. Volume: extrusions at 100 % infill against the mesh. Gaps: material of solid infill against the
distance to the layer below, from the lowest to the highest hundredth. Tops: distance between the mesh and the highest extrusion where it slopes by 1 to 45
degrees, from the lowest to the highest twentieth, in planar slicing and in curved. FOLDER keeps meshes and files. Needs GNU time.
"""
import json, math, os, re, struct, subprocess, sys, tempfile

from printed_layers import extrusions, gap_errors, share, steps


def write(path, vertices, faces):
    with open(path, 'w') as out:
        out.writelines('v %.9g %.9g %.9g\n' % tuple(p) for p in vertices)
        out.writelines('f %s\n' % ' '.join(str(i + 1) for i in face) for face in faces)


def between(path, nx, ny, xs, ys, low, high):
    """A solid between two height fields over a rectangle."""
    count = (nx + 1) * (ny + 1)
    at = lambda s, i, j: s * count + j * (nx + 1) + i
    vertices = []
    for surface in (low, high):
        for j in range(ny + 1):
            for i in range(nx + 1):
                x, y = xs[0] + (xs[1] - xs[0]) * i / nx, ys[0] + (ys[1] - ys[0]) * j / ny
                vertices.append((x, y, surface(x, y)))
    faces = []
    for j in range(ny):
        for i in range(nx):
            for s in (0, 1):
                a, b, c, d = at(s, i, j), at(s, i + 1, j), at(s, i + 1, j + 1), at(s, i, j + 1)
                faces += [(a, b, c), (a, c, d)] if s else [(a, c, b), (a, d, c)]
    border = [(i, 0) for i in range(nx)] + [(nx, j) for j in range(ny)] + [(i, ny) for i in range(nx, 0, -1)] + [(0, j) for j in range(ny, 0, -1)]
    for (i, j), (k, m) in zip(border, border[1:] + border[:1]):
        faces += [(at(0, i, j), at(0, k, m), at(1, k, m)), (at(0, i, j), at(1, k, m), at(1, i, j))]
    write(path, vertices, faces)


def rings(path, outlines):
    """A closed solid through outlines of equally many points, from below."""
    n, faces = len(outlines[0]), []
    vertices = [p for outline in outlines for p in outline]
    for k in range(len(outlines) - 1):
        for t in range(n):
            a, b, c, d = k * n + t, k * n + (t + 1) % n, (k + 1) * n + (t + 1) % n, (k + 1) * n + t
            faces += [(a, b, c), (a, c, d)]
    for outline, first in ((outlines[0], 0), (outlines[-1], (len(outlines) - 1) * n)):
        vertices.append(tuple(sum(p[i] for p in outline) / n for i in range(3)))
        for t in range(n):
            a, b = first + t, first + (t + 1) % n
            faces.append((len(vertices) - 1, a, b) if first else (len(vertices) - 1, b, a))
    write(path, vertices, faces)


def circle(radius, z, n=96):
    return [(radius * math.cos(2 * math.pi * t / n), radius * math.sin(2 * math.pi * t / n), z) for t in range(n)]


def lathe(path, outline):
    rings(path, [circle(r, z) for r, z in outline])


def cross(path, step=1.0):
    """Two tubes that cross, rounded where they meet: the surface of a distance, cube by cube in six tetrahedra each."""
    def tube(p, a, b):
        d = [v - u for u, v in zip(a, b)]
        t = sum((u - v) * w for u, v, w in zip(p, a, d)) / sum(w * w for w in d)
        return math.dist(p, [u + t * w for u, w in zip(a, d)]) - 6

    def inside(p):
        d = [tube(p, (-13, 0, -2), (13, 0, 42)), tube(p, (13, 0, -2), (-13, 0, 42))]
        near = max(3 - abs(d[0] - d[1]), 0) / 3
        return max(min(d) - near ** 3 / 2, -p[2], p[2] - 40)

    low, count, values, vertices, at, faces = (-22.3, -9.3, -0.7), (45, 19, 43), {}, [], {}, []

    def place(k):
        return tuple(v + step * i for v, i in zip(low, k))

    def value(k):
        if k not in values:
            values[k] = inside(place(k))
        return values[k]

    def vertex(a, b):
        a, b = min(a, b), max(a, b)
        if (a, b) not in at:
            t = min(0.999, max(0.001, value(a) / (value(a) - value(b))))
            at[a, b] = len(vertices)
            vertices.append(tuple(u + t * (v - u) for u, v in zip(place(a), place(b))))
        return at[a, b]

    for n in range(count[0] * count[1] * count[2]):
        i, j, k = n % count[0], n // count[0] % count[1], n // count[0] // count[1]
        cube = [(i + (b & 1), j + (b >> 1 & 1), k + (b >> 2)) for b in range(8)]
        if len({value(c) < 0 for c in cube}) == 1:
            continue
        for corners in ((0, 1, 3, 7), (0, 3, 2, 7), (0, 2, 6, 7), (0, 6, 4, 7), (0, 4, 5, 7), (0, 5, 1, 7)):
            full, empty = [cube[c] for c in corners if value(cube[c]) < 0], [cube[c] for c in corners if value(cube[c]) >= 0]
            if not full or not empty:
                continue
            if len(full) == 2:
                a, b, c, d = (vertex(*pair) for pair in ((full[0], empty[0]), (full[0], empty[1]), (full[1], empty[1]), (full[1], empty[0])))
                made = [(a, b, c), (a, c, d)]
            else:
                made = [tuple(vertex(e, f) for e in empty for f in full)]
            middle = [sum(place(f)[m] for f in full) / len(full) for m in range(3)]
            for face in made:
                p, q, r = ([v - m for v, m in zip(vertices[f], middle)] for f in face)
                faces.append(face if det(p, q, r) > 0 else face[::-1])
    write(path, vertices, faces)


def shapes(folder):
    join = lambda name: os.path.join(folder, name)
    tan = lambda degrees: math.tan(math.radians(degrees))
    for degrees in (5, 10, 20, 30):
        between(join('wedge%d.obj' % degrees), 20, 12, (0, 50), (0, 30), lambda x, y: 0, lambda x, y, d=degrees: 3 + x * tan(d))
    bowl = lambda r, top, depth: top - depth * r * r
    lathe(join('dome.obj'), [(30, 0)] + [(r, bowl(r, 16, 12 / 900)) for r in [30 - 0.75 * k for k in range(40)]])
    between(join('wave.obj'), 60, 40, (0, 60), (0, 40), lambda x, y: 0, lambda x, y: 8 + 2 * math.sin(2 * math.pi * x / 25) * math.cos(2 * math.pi * y / 40))
    arch = lambda x: 6 - 6 * (x / 30) ** 2
    between(join('shell.obj'), 60, 20, (-30, 30), (0, 30), lambda x, y: arch(x), lambda x, y: arch(x) + 3)
    between(join('terrain.obj'), 60, 60, (-40, 40), (-40, 40), lambda x, y: 0, lambda x, y: 10 + 3 * math.sin(x / 12) * math.cos(y / 10))
    between(join('plate.obj'), 30, 30, (-20, 20), (-15, 15), lambda x, y: 0, lambda x, y: 3)
    lathe(join('mushroom.obj'), [(10, 0), (10, 15)] + [(10 + k, 15 + 0.45 * k) for k in range(1, 19)] + [(28, 26)])
    outline = []
    for k in range(61):
        a = math.radians(k)
        square = [(-10 + 20 * t / 12, -10) for t in range(12)] + [(10, -10 + 20 * t / 12) for t in range(12)]
        square += [(-x, -y) for x, y in square]
        outline.append([(x * math.cos(a) - y * math.sin(a), x * math.sin(a) + y * math.cos(a), 0.5 * k) for x, y in square])
    rings(join('screw.obj'), outline)
    cross(join('cross.obj'))
    heights = [float(line.split()[3]) for line in open(join('cross.obj')) if line.startswith('v ')]
    for end, z in (('LOW', min(heights)), ('HIGH', max(heights))):
        json.dump([i for i, height in enumerate(heights) if abs(height - z) < 1e-6], open(join('cross_%s.json' % end), 'w'))


def triangles(path):
    if path.endswith('.stl'):
        data = open(path, 'rb').read()
        corners = [struct.unpack('<12f', data[84 + 50 * i:132 + 50 * i])[3:] for i in range(struct.unpack('<I', data[80:84])[0])]
        return [(c[0:3], c[3:6], c[6:9]) for c in corners]
    vertices, faces = [], []
    for line in open(path):
        words = line.split()
        if words[:1] == ['v']:
            vertices.append(tuple(map(float, words[1:4])))
        if words[:1] == ['f']:
            faces.append(tuple(vertices[int(w.split('/')[0]) - 1] for w in words[1:4]))
    return faces


def det(a, b, c):
    return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0])


def run(program, arguments, output):
    if os.path.exists(output):
        os.remove(output)
    try:
        done = subprocess.run(['/usr/bin/time', '-f', '@%U %S %M', program, 'slice', *arguments, '-o', output], capture_output=True, text=True, timeout=110)
    except subprocess.TimeoutExpired:
        return None
    text = done.stdout + done.stderr
    user, system, kilobytes = re.search(r'@([\d.]+) ([\d.]+) (\d+)', text).groups()
    found = {}
    for code, rest in re.findall(r'(?:warning|error) ([a-z]+\.[a-z_]+):([^\n]*)', text):
        times = re.search(r'\((\d+) times', rest)
        found[code] = found.get(code, 0) + int(times.group(1) if times else 1)
    return float(user) + float(system), int(kilobytes) // 1024, found


def row(program, folder, name, model, options, common, copies=1):
    """A line of the table; without a mesh that is printed as it is, copies is 0, and volume and tops are left out."""
    word = re.sub(r'[^a-z0-9]+', '_', name.lower()).strip('_')
    level, bent = (os.path.join(folder, '%s.%s.gcode' % (word, kind)) for kind in ('planar', 'curved'))
    planar = run(program, [model, *common, *(options[-4:] if copies > 1 else [])], level)
    curved = run(program, [model, *common, *options], bent)
    if curved is None:
        print('| %s | stopped after 110 s |' % name + ' |' * 7, flush=True)
        return
    volume, gaps, tops = '–', '–', '–'
    if os.path.exists(bent) and 'infill_density_percent=100' in common:
        moves, faces = extrusions(bent), triangles(model)
        if copies:
            mesh = sum(det(*f) for f in faces) / 6 * (copies / 8 if copies > 1 else 1)
            volume = '%+.2f %%' % (100 * (sum(m.volume for m in moves) / mesh - 1))
        errors = gap_errors(moves)
        if len(errors) > 50:
            gaps = '%+.1f to %+.1f %%' % (100 * share(errors, 0.01), 100 * share(errors, 0.99))
        if copies == 1 and planar:
            spread = [share(d, 0.95) - share(d, 0.05) if d else 0 for d in (steps(extrusions(level), faces), steps(moves, faces))]
            tops = '%.2f → %.2f mm' % tuple(spread) if spread[0] else '–'
    words = ', '.join('`%s`' % code + (' × %d' % n if n > 1 else '') for code, n in curved[2].items()) or '–'
    times = '%.1f ×' % (curved[0] / planar[0]) if planar else '–'
    cells = (name, 'yes' if os.path.exists(bent) else 'no', volume, gaps, tops, words, curved[0], times, curved[1])
    print('| %s | %s | %s | %s | %s | %s | %.1f s | %s | %d MB |' % cells, flush=True)


def main(program, examples, samples, folder):
    shapes(folder)
    own, model = lambda name: os.path.join(folder, name + '.obj'), lambda name: os.path.join(examples, name + '.stl')
    full = ['--set', 'infill_density_percent=100', '--set', 'skirt_loops=0']
    print('| shape | written | volume | gaps | tops | errors and warnings | processor | of planar | peak |')
    print('|---|---|---|---|---|---|---|---|---|')

    def line(name, mesh, *options, common=full, copies=1):
        row(program, folder, name, mesh, list(options), common, copies)

    for degrees in (5, 10, 20, 30):
        line('wedge of %d°, `--surface` its top' % degrees, own('wedge%d' % degrees), '--surface', own('wedge%d' % degrees))
    line('wedge of 20°, `--field smooth`', own('wedge20'), '--field', 'smooth')
    line('wedge of 20°, `--field "z - 0.3 * x"`', own('wedge20'), '--field', 'z - 0.3 * x')
    line('dome, `--surface` its top', own('dome'), '--surface', own('dome'))
    line('dome, `--field between`', own('dome'), '--field', 'between', '--surface', own('dome'))
    line('dome, `--field smooth`', own('dome'), '--field', 'smooth')
    line('wave, `--surface` its top, `--blend 1,6`', own('wave'), '--surface', own('wave'), '--blend', '1,6')
    line('wave, `--field "z - 1.5 * sin(6 * x)"`', own('wave'), '--field', 'z - 1.5 * sin(6 * x)')
    line('arched shell, `--surface` its top, supports', own('shell'), '--surface', own('shell'), '--set', 'support=grid', copies=0)
    line('plate, `--onto` a scan', own('plate'), '--onto', own('terrain'), copies=0)
    line('mushroom, `--deform overhangs`', own('mushroom'), '--deform', 'overhangs')
    line('bracket, `--deform overhangs`', model('bracket'), '--deform', 'overhangs')
    line('branching Y, `--field harmonic`', model('branching'), '--field', 'harmonic')
    line('branching Y, `--scale 50% --copies 2`', model('branching'), '--field', 'harmonic', '--scale', '50%', '--copies', '2', copies=2)
    for field in ('harmonic', 'geodesic'):
        line('X of two tubes, `--field %s`, its ends as lists' % field, own('cross'), '--field', field, *ends(folder, 'cross'))
    line('twisted prism, `--field "z - 0.02 * r * sin(2 * theta)"`', own('screw'), '--field', 'z - 0.02 * r * sin(2 * theta)')
    slender = ['--set', 'head_outline_mm=[[2.5,0],[14,28],[22,300]]']
    surface = ['--set', 'open_contours=surface']
    tilting = [*slender, '--set', 'rotary_axes=["C head z speed 120", "B head y at 0 0 60 from -135 to 135 speed 90"]']
    for name, head in (('vase', []), ('Y_shape', slender), ('Y_shape', [])) if samples else ():
        title = '%s of compas_slicer, `--field harmonic`%s' % (name, ', slender nozzle' if head else '')
        line(title, os.path.join(samples, name + '.obj'), '--field', 'harmonic', *ends(samples, name), common=['-p', 'potter_super', *head])
    for name in ('vase', 'Y_shape', 'costa_surface') if samples else ():
        title = '%s as a surface, `--tilt normal`, slender nozzle' % name
        line(title, os.path.join(samples, name + '.obj'), '--field', 'harmonic', *ends(samples, name), '--tilt', 'normal',
             common=['-p', 'potter_super', *tilting, *surface], copies=0)


def ends(samples, name):
    return [word for end, file in (('--from', 'LOW'), ('--to', 'HIGH')) for word in (end, os.path.join(samples, '%s_%s.json' % (name, file)))]


if __name__ == '__main__':
    words = sys.argv[1:]
    keep = words[-1] if words[-2:-1] == ['--keep'] else None
    words = words[:-2] if keep else words
    if len(words) not in (2, 3):
        sys.exit(__doc__)
    with tempfile.TemporaryDirectory() as folder:
        main(words[0], words[1], words[2] if len(words) > 2 else None, keep or folder)
