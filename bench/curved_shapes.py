#!/usr/bin/env python3
"""Shapes for curved slicing: whole programs with all checks against planar slicing of the same mesh, as a table in Markdown.

    bench/curved_shapes.py PROGRAM EXAMPLES [SAMPLES]

PROGRAM is the published program, EXAMPLES the folder examples/models. SAMPLES may hold vase, Y_shape and costa_surface of compas_slicer as NAME.obj with
NAME_LOW.json and NAME_HIGH.json, the vertices of their ends. Volume: extrusions at 100 % infill against the mesh. Needs GNU time.
"""
import math, os, re, subprocess, sys, tempfile

FILAMENT = math.pi / 4 * 1.75 ** 2


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


def volume(path):
    vertices, total = [], 0
    if path.endswith('.stl'):
        import struct
        data = open(path, 'rb').read()
        corners = [struct.unpack('<12f', data[84 + 50 * i:132 + 50 * i])[3:] for i in range(struct.unpack('<I', data[80:84])[0])]
        return sum(det(c[0:3], c[3:6], c[6:9]) for c in corners) / 6
    for line in open(path):
        words = line.split()
        if words[:1] == ['v']:
            vertices.append(tuple(map(float, words[1:4])))
        if words[:1] == ['f']:
            total += det(*(vertices[int(w.split('/')[0]) - 1] for w in words[1:4]))
    return total / 6


def det(a, b, c):
    return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0])


def moves(path):
    """Printing moves after the start code: start, end, mm³."""
    at, begun = [0.0, 0.0, 0.0], False
    for line in open(path):
        begun |= line.startswith(';LAYER_CHANGE')
        if not line.startswith(('G0 ', 'G1 ')):
            continue
        start, e = tuple(at), 0
        for word, value in re.findall(r'([XYZE])(-?[\d.]+)', line.split(';')[0]):
            if word == 'E':
                e = float(value)
            else:
                at['XYZ'.index(word)] = float(value)
        if begun and e > 0 and start[:2] != tuple(at[:2]):
            yield start, tuple(at), e * FILAMENT


def run(program, arguments, output):
    if os.path.exists(output):
        os.remove(output)
    try:
        done = subprocess.run(['/usr/bin/time', '-f', '@%U %S %M', program, 'slice', *arguments, '-o', output], capture_output=True, text=True, timeout=60)
    except subprocess.TimeoutExpired:
        return None
    text = done.stdout + done.stderr
    user, system, kilobytes = re.search(r'@([\d.]+) ([\d.]+) (\d+)', text).groups()
    found = {}
    for code, rest in re.findall(r'(?:warning|error) ([a-z]+\.[a-z_]+):([^\n]*)', text):
        times = re.search(r'\((\d+) times', rest)
        found[code] = found.get(code, 0) + int(times.group(1) if times else 1)
    return float(user) + float(system), int(kilobytes) // 1024, found


def row(program, folder, name, model, options, common):
    output = os.path.join(folder, 'o.gcode')
    planar = run(program, [model, *common], output)
    curved = run(program, [model, *common, *options], output)
    if curved is None:
        print('| %s | stopped after 60 s | | | | | |' % name, flush=True)
        return
    written = os.path.exists(output)
    share = '–'
    if written and 'infill_density_percent=100' in common:
        share = '%+.2f %%' % (100 * (sum(m[2] for m in moves(output)) / volume(model) - 1))
    words = ', '.join(code + (' × %d' % n if n > 1 else '') for code, n in curved[2].items()) or '–'
    times = '%.1f ×' % (curved[0] / planar[0]) if planar else '–'
    cells = (name, 'yes' if written else 'no', share, words, curved[0], times, curved[1])
    print('| %s | %s | %s | %s | %.1f s | %s | %d MB |' % cells, flush=True)


def main(program, examples, samples=None):
    with tempfile.TemporaryDirectory() as folder:
        shapes(folder)
        own, model = lambda name: os.path.join(folder, name + '.obj'), lambda name: os.path.join(examples, name + '.stl')
        full = ['--set', 'infill_density_percent=100', '--set', 'skirt_loops=0']
        print('| shape | written | volume | warnings and errors | processor | of planar | peak |')
        print('|---|---|---|---|---|---|---|')
        for degrees in (5, 10, 20, 30):
            wedge = own('wedge%d' % degrees)
            row(program, folder, 'wedge of %d°, `--surface` its top' % degrees, wedge, ['--surface', wedge], full)
        row(program, folder, 'wedge of 20°, `--field "z - 0.3 * x"`', own('wedge20'), ['--field', 'z - 0.3 * x'], full)
        row(program, folder, 'dome, `--surface` its top', own('dome'), ['--surface', own('dome')], full)
        row(program, folder, 'dome, `--field smooth`', own('dome'), ['--field', 'smooth'], full)
        row(program, folder, 'wave, `--blend 1,6`', own('wave'), ['--surface', own('wave'), '--blend', '1,6'], full)
        row(program, folder, 'wave, `--field "z - 1.5 * sin(6 * x)"`', own('wave'), ['--field', 'z - 1.5 * sin(6 * x)'], full)
        row(program, folder, 'arched shell with supports, `--surface` its top', own('shell'), ['--surface', own('shell'), '--set', 'support=grid'], full)
        row(program, folder, 'plate, `--onto` a scan', own('plate'), ['--onto', own('terrain')], full)
        row(program, folder, 'mushroom, `--deform overhangs`', own('mushroom'), ['--deform', 'overhangs'], full)
        row(program, folder, 'bracket, `--deform overhangs`', model('bracket'), ['--deform', 'overhangs'], full)
        row(program, folder, 'branching Y, `--field harmonic`', model('branching'), ['--field', 'harmonic'], full)
        row(program, folder, 'twisted prism, `--field "z - 0.02 * r * sin(2 * theta)"`', own('screw'), ['--field', 'z - 0.02 * r * sin(2 * theta)'], full)
        slender = ['--set', 'head_outline_mm=[[2.5,0],[14,28],[22,300]]']
        for name, head in (('vase', []), ('Y_shape', slender), ('Y_shape', []), ('costa_surface', slender)) if samples else ():
            ends = [word for end, file in (('--from', 'LOW'), ('--to', 'HIGH')) for word in (end, os.path.join(samples, '%s_%s.json' % (name, file)))]
            title = '%s of compas_slicer, `--field harmonic`%s' % (name, ', slender nozzle' if head else '')
            row(program, folder, title, os.path.join(samples, name + '.obj'), ['--field', 'harmonic', *ends], ['-p', 'potter_super', *head])


if __name__ == '__main__':
    if len(sys.argv) not in (3, 4):
        sys.exit(__doc__)
    main(*sys.argv[1:])
