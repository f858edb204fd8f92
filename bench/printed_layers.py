"""What a G-code file prints, measured from its extrusions alone: gaps between layers, and how far tops lie from a mesh. Lengths in mm."""
import math, random, re
from collections import defaultdict

FILAMENT = math.pi / 4 * 1.75 ** 2
CELL = 1.0
PROBES = 1000


class Extrusion:
    """A printing move: its ends, mm³, the role of its comment and the number of its layer."""
    __slots__ = ('a', 'b', 'volume', 'role', 'layer', 'length')

    def __init__(self, a, b, volume, role, layer):
        self.a, self.b, self.volume, self.role, self.layer, self.length = a, b, volume, role, layer, math.dist(a, b)

    def at(self, t):
        return tuple(p + (q - p) * t for p, q in zip(self.a, self.b))


def extrusions(path):
    """The printing moves after the start code."""
    at, role, layer, found = [0.0, 0.0, 0.0], '', 0, []
    for line in open(path):
        if line.startswith(';LAYER_CHANGE'):
            layer += 1
        elif line.startswith(';TYPE:'):
            role = line[6:].strip()
        if not line.startswith(('G0 ', 'G1 ')):
            continue
        start, e = tuple(at), 0
        for word, value in re.findall(r'([XYZE])(-?[\d.]+)', line.split(';')[0]):
            if word == 'E':
                e = float(value)
            else:
                at['XYZ'.index(word)] = float(value)
        if layer and e > 0 and start[:2] != tuple(at[:2]):
            found.append(Extrusion(start, tuple(at), e * FILAMENT, role, layer))
    return found


def gap_errors(moves):
    """
    Of lines of solid infill at random: their material per covered area against the distance to the layer below, less 1, in ascending order. The area is the
    length times the mean distance to the parallel lines at both sides; the layer below is a quadric through the extrusions around the place.
    """
    chosen = [m for m in moves if 'infill' in m.role.lower() and m.length > 1.5]
    chosen = random.Random(7).sample(chosen, min(PROBES, len(chosen)))
    wanted = set()
    for move in chosen:
        x, y = (int(v // CELL) for v in move.at(0.5)[:2])
        wanted.update((x + i, y + j) for i in (-1, 0, 1) for j in (-1, 0, 1))
    cells = defaultdict(list)
    for move in moves:
        count = max(1, math.ceil(move.length / 0.2))
        for k in range(count):
            p = move.at((k + 0.5) / count)
            key = (int(p[0] // CELL), int(p[1] // CELL))
            if key in wanted:
                cells[key].append((p, move))
    return sorted(e for e in (gap_error(move, cells) for move in chosen) if e is not None)


def gap_error(move, cells):
    p, area = move.at(0.5), move.volume / move.length
    x, y = int(p[0] // CELL), int(p[1] // CELL)
    near = [s for i in (-1, 0, 1) for j in (-1, 0, 1) for s in cells.get((x + i, y + j), ())]
    along = [(q - r) / move.length for q, r in zip(move.b, move.a)]
    plan = math.hypot(along[0], along[1])
    left = (-along[1] / plan, along[0] / plan)
    beside = {1: None, -1: None}
    for q, other in near:
        if other.layer != move.layer or other is move:
            continue
        d = [s - t for s, t in zip(q, p)]
        aside, ahead = d[0] * left[0] + d[1] * left[1], sum(s * t for s, t in zip(d, along))
        if abs(aside) < 0.15 or abs(ahead) > 0.25:
            continue
        turn = sum(s * (b - a) for s, a, b in zip(along, other.a, other.b)) / other.length
        far = math.sqrt(max(0, sum(s * s for s in d) - ahead * ahead))
        side = 1 if aside > 0 else -1
        if beside[side] is None or far < beside[side][0]:
            beside[side] = (far, abs(turn))
    if None in beside.values() or min(turn for _, turn in beside.values()) < 0.995:
        return None
    spacing = (beside[1][0] + beside[-1][0]) / 2
    height = area / spacing
    # The layer below is the one with the least gap: on a slope, a lower one may have a higher point nearby. Across a bend it cannot be told.
    near_below = {other.layer for q, other in near if math.dist(q[:2], p[:2]) < 0.25 and other.layer < move.layer and abs(q[2] - p[2]) < 2 * height + 0.1}
    if not near_below or spacing > 1:
        return None
    gaps = [gap_over([q for q, other in near if other.layer == layer and math.dist(q[:2], p[:2]) < 1], p) for layer in near_below]
    if None in gaps:
        return None
    gap = min((gap for gap in gaps if gap > 0.3 * height), default=None)
    return height / gap - 1 if gap else None


def gap_over(points, p):
    """From a place down to a quadric through points, across it."""
    if len(points) < 16:
        return None
    rows = [(1, x - p[0], y - p[1], (x - p[0]) ** 2, (x - p[0]) * (y - p[1]), (y - p[1]) ** 2, z - p[2]) for x, y, z in points]
    matrix = [[sum(r[i] * r[j] for r in rows) for j in range(7)] for i in range(6)]
    for i in range(6):
        pivot = max(range(i, 6), key=lambda k: abs(matrix[k][i]))
        matrix[i], matrix[pivot] = matrix[pivot], matrix[i]
        if abs(matrix[i][i]) < 1e-9:
            return None
        for k in range(6):
            if k != i:
                factor = matrix[k][i] / matrix[i][i]
                matrix[k] = [s - factor * t for s, t in zip(matrix[k], matrix[i])]
    depth, slope_x, slope_y = (matrix[i][6] / matrix[i][i] for i in range(3))
    # Other pieces of the layer may lie at other heights.
    if max(abs(sum(matrix[i][6] / matrix[i][i] * r[i] for i in range(6)) - r[6]) for r in rows) > 0.08:
        return None
    return -depth / math.sqrt(1 + slope_x ** 2 + slope_y ** 2)


def steps(moves, triangles, steepest=45, cell=0.2, half=0.23):
    """From the mesh down to the highest extrusion over its tops that slope by 1 degree to the steepest, in ascending order."""
    xs, ys = ([c[i] for t in triangles for c in t] for i in (0, 1))
    shift = (110 - (min(xs) + max(xs)) / 2, 110 - (min(ys) + max(ys)) / 2, -min(c[2] for t in triangles for c in t))
    tops = {}
    for triangle in triangles:
        a, b, c = (tuple(v + s for v, s in zip(corner, shift)) for corner in triangle)
        area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
        if abs(area) < 1e-9:
            continue
        by_x = ((b[2] - a[2]) * (c[1] - a[1]) - (c[2] - a[2]) * (b[1] - a[1])) / area
        by_y = ((c[2] - a[2]) * (b[0] - a[0]) - (b[2] - a[2]) * (c[0] - a[0])) / area
        slope = math.degrees(math.atan(math.hypot(by_x, by_y)))
        for j in range(math.ceil(min(a[1], b[1], c[1]) / cell), math.floor(max(a[1], b[1], c[1]) / cell) + 1):
            for i in range(math.ceil(min(a[0], b[0], c[0]) / cell), math.floor(max(a[0], b[0], c[0]) / cell) + 1):
                x, y = i * cell, j * cell
                u = ((b[0] - x) * (c[1] - y) - (b[1] - y) * (c[0] - x)) / area
                v = ((c[0] - x) * (a[1] - y) - (c[1] - y) * (a[0] - x)) / area
                z = a[2] * u + b[2] * v + c[2] * (1 - u - v)
                if u >= 0 and v >= 0 and u + v <= 1 and z > tops.get((i, j), (-1,))[0]:
                    tops[i, j] = (z, slope)
    tops = {k: z for k, (z, slope) in tops.items() if 1 < slope < steepest and z > 0.3}
    highest, reach = {}, math.ceil(half / cell)
    for move in moves:
        plan = math.dist(move.a[:2], move.b[:2])
        count = max(1, math.ceil(plan / (cell / 2)))
        for k in range(count + 1):
            p = move.at(k / count)
            i0, j0 = round(p[0] / cell), round(p[1] / cell)
            if (i0, j0) in tops and p[2] < tops[i0, j0] - 1:
                continue
            for j in range(j0 - reach, j0 + reach + 1):
                for i in range(i0 - reach, i0 + reach + 1):
                    dx, dy = i * cell - p[0], j * cell - p[1]
                    ahead = (dx * (move.b[0] - move.a[0]) + dy * (move.b[1] - move.a[1])) / plan
                    if dx * dx + dy * dy > half * half or abs(ahead) > 0.3 * cell or (i, j) not in tops:
                        continue
                    highest[i, j] = max(highest.get((i, j), -1), p[2] + (move.b[2] - move.a[2]) * ahead / plan)
    return sorted(z - highest.get(k, 0) for k, z in tops.items())


def share(values, part):
    """The value below which a part of ascending ones lie."""
    return values[min(len(values) - 1, int(part * len(values)))]
