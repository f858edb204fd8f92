using System;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Toolpaths;

namespace Caterpillar.GCode;

/// <summary>G2 and G3.</summary>
internal sealed partial class DecoderCore
{
    private ArcPlane _plane;
    private bool _absoluteCenters;

    private void ArcMove(ParsedLine line)
    {
        var clockwise = _motion == 2;
        var x = line.TryGet('X', out var wx) ? Target(_x, wx) : _x;
        var y = line.TryGet('Y', out var wy) ? Target(_y, wy) : _y;
        var z = line.TryGet('Z', out var wz) ? Target(_z, wz) : _z;
        if (!_rules.Arcs || (_relative && !_rules.ArcsInRelativeMode))
        {
            Refused("gcode.arc_refused", _rules.Title + (_rules.Arcs ? " refuses arcs in relative mode." : " knows no arcs."));
            return;
        }
        var start = new Vec3(_x, _y, _z);
        var end = new Vec3(x, y, z);
        bool hasI = line.TryGet('I', out var i), hasJ = line.TryGet('J', out var j), hasK = line.TryGet('K', out var k);
        Arc arc;
        if (hasI || hasJ || hasK)
        {
            arc = Centered(line, start, end, new Vec3(Center(_x, i, hasI), Center(_y, j, hasJ), Center(_z, k, hasK)), clockwise);
        }
        else if (line.TryGet('R', out var r) && _rules.RadiusArcs)
        {
            if (!ByRadius(start, end, r * Unit, clockwise, out arc))
            {
                if (_rules.ArcWithoutCenterIsLine) Line(line, x, y, z);
                else Refused("gcode.arc_refused", "An arc by R needs two different points and a radius; " + _rules.Title + " refuses others.");
                return;
            }
        }
        else if (_rules.ArcWithoutCenterIsLine)
        {
            Line(line, x, y, z);
            return;
        }
        else
        {
            Refused("gcode.arc_refused", line.Find('R') >= 0 ? _rules.Title + " knows no arcs by R." : "An arc without centre is refused by " + _rules.Title + ".");
            return;
        }
        var e = ExtruderWord(line, out var we) ? ChangeOfE(we) : 0;
        Arc(start, end, e, arc);
    }

    private void Line(ParsedLine line, double x, double y, double z)
        => Linear(x, y, z, ExtruderWord(line, out var we) ? ChangeOfE(we) : 0, _motion);

    private double Center(double from, double word, bool has) => _absoluteCenters ? (has ? word * Unit : from) : from + word * Unit;

    private Arc Centered(ParsedLine line, Vec3 start, Vec3 end, Vec3 center, bool clockwise)
    {
        var (su, sv) = InPlane(start - center);
        var (eu, ev) = InPlane(end - center);
        double sweep;
        if (Math.Abs(su - eu) <= NoChange && Math.Abs(sv - ev) <= NoChange)
        {
            sweep = 360;
        }
        else
        {
            var turn = Angle.Atan2(ev, eu) - Angle.Atan2(sv, su);
            sweep = clockwise ? -turn : turn;
            if (sweep < 0) sweep += 360;
            if (sweep >= 360) sweep -= 360;
        }
        if (_rules.ArcTurns && line.TryGet('P', out var turns) && turns is >= 2 and < 1e6) sweep += 360 * (Math.Floor(turns) - 1);
        return new Arc(center, clockwise ? -sweep : sweep, _plane);
    }

    // The shorter arc for R > 0, the longer one for R < 0; a chord longer than 2R is taken as a half circle about its middle.
    private bool ByRadius(Vec3 start, Vec3 end, double radius, bool clockwise, out Arc arc)
    {
        arc = default;
        var (u, v) = InPlane(end - start);
        var chord = Math.Sqrt(u * u + v * v);
        if (!(chord > NoChange) || radius == 0 || double.IsInfinity(chord) || double.IsInfinity(radius)) return false;
        var size = Math.Abs(radius);
        var height2 = size * size - chord * chord / 4;
        var height = height2 > 0 ? Math.Sqrt(height2) : 0;
        // Counter-clockwise and short: the centre lies to the left of the chord.
        var side = clockwise != radius < 0 ? -1 : 1;
        var cu = u / 2 - side * height * v / chord;
        var cv = v / 2 + side * height * u / chord;
        var half = height > 0 ? Angle.ToDegrees(Math.Asin(Math.Min(chord / 2 / size, 1))) : 90;
        var sweep = radius < 0 ? 360 - 2 * half : 2 * half;
        var center = _plane switch
        {
            ArcPlane.XY => new Vec3(start.X + cu, start.Y + cv, start.Z),
            ArcPlane.ZX => new Vec3(start.X + cv, start.Y, start.Z + cu),
            _ => new Vec3(start.X, start.Y + cu, start.Z + cv),
        };
        arc = new Arc(center, clockwise ? -sweep : sweep, _plane);
        return true;
    }

    private (double U, double V) InPlane(Vec3 d) => _plane switch
    {
        ArcPlane.XY => (d.X, d.Y),
        ArcPlane.ZX => (d.Z, d.X),
        _ => (d.Y, d.Z),
    };

    private void Arc(Vec3 start, Vec3 end, double e, Arc arc)
    {
        var length = arc.Length(start, end);
        if (!(length * length < LargestSquare) || IsTooFar(end.X, end.Y, end.Z) || IsTooFar(arc.Center.X, arc.Center.Y, arc.Center.Z) || !(Math.Abs(e) < LargestE))
        {
            Tally.Feeds++;
            OutOfRange();
            return;
        }
        if (Math.Abs(e) < NoChange) e = 0;
        Tally.Feeds++;
        if (length <= NoChange)
        {
            InPlace(end.X, end.Y, end.Z, e);
            return;
        }
        var rise = end.Z - start.Z;
        var xy = Math.Sqrt(Math.Max(length * length - rise * rise, 0));
        var count = Tally.Prints;
        Moved(end.X, end.Y, end.Z, e, _motion, length, xy, _plane == ArcPlane.XY && rise == 0);
        _out.AddArc(arc with { Center = arc.Center + new Vec3(_shiftX, _shiftY, _shiftZ) });
        var printed = Tally.Prints > count;
        if (printed) Tally.PrintArcs++;
        else Tally.TravelArcs++;
        Extremes(start, arc, printed ? Tally.PrintEnds : Tally.TravelEnds);
    }

    // The outermost points of the circle about the centre through the start, as far as the arc passes them.
    private void Extremes(Vec3 start, Arc arc, Box box)
    {
        var (u, v) = InPlane(start - arc.Center);
        var radius = Math.Sqrt(u * u + v * v);
        if (radius == 0) return;
        var from = Angle.Atan2(v, u);
        var to = from + arc.Sweep;
        var low = Math.Min(from, to);
        var high = Math.Max(from, to);
        var first = Math.Ceiling(low / 90);
        for (var k = 0; k < 4 && (first + k) * 90 <= high; k++)
        {
            var (sin, cos) = Angle.SinCos((first + k) * 90);
            var (pu, pv) = (radius * cos, radius * sin);
            switch (arc.Plane)
            {
                case ArcPlane.XY:
                    box.Include(arc.Center.X + pu, arc.Center.Y + pv, _z);
                    break;
                case ArcPlane.ZX:
                    box.Include(arc.Center.X + pv, _y, arc.Center.Z + pu);
                    break;
                default:
                    box.Include(_x, arc.Center.Y + pu, arc.Center.Z + pv);
                    break;
            }
        }
    }
}
