using System;
using Caterpillar.Basics;
using Caterpillar.Dialects;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;

namespace Caterpillar.GCode;

/// <summary>G2 and G3.</summary>
internal sealed partial class DecoderCore
{
    // Firmware takes no more in one command.
    private const int MostCircles = 100;

    private ArcPlane _plane;
    private bool _absoluteCenters;

    private void ArcMove(ParsedLine line)
    {
        var x = line.TryGet('X', out var wx) ? Target(_x, wx, _shiftX) : _x;
        var y = line.TryGet('Y', out var wy) ? Target(_y, wy, _shiftY) : _y;
        var z = line.TryGet('Z', out var wz) ? Target(_z, wz, _shiftZ) : _z;
        _machineCoordinates = false;
        var start = new Vec3(_x, _y, _z);
        var end = new Vec3(x, y, z);
        if (WhyRefused(line, start, end, out var arc) is { } why)
        {
            if (_rules.ArcWithoutCenterIsLine) Linear(x, y, z, ExtruderWord(line, out var word) ? ChangeOfE(word) : 0, _motion);
            else Refused("gcode.arc_refused", why);
            return;
        }
        var turns = Rounds(line);
        if (_rules.ArcTurns == ArcTurnsRule.CirclesFirst) Circles(start, arc, turns);
        else if (_rules.ArcTurns == ArcTurnsRule.Added) arc = Longer(arc, turns);
        else if (_rules.ArcTurns == ArcTurnsRule.Count) arc = Longer(arc, turns - 1);
        var e = ExtruderWord(line, out var we) ? ChangeOfE(we) : 0;
        if (_rules.HelixRisesFirst && z != _z)
        {
            Linear(_x, _y, z, 0, _motion);
            start = new Vec3(_x, _y, _z);
            arc = arc with { Center = arc.Center + new Vec3(0, 0, z - arc.Center.Z) };
        }
        Arc(start, end, e, arc);
    }

    // Null where the arc is drawn.
    private string? WhyRefused(ParsedLine line, Vec3 start, Vec3 end, out Arc arc)
    {
        arc = default;
        if (!_rules.Arcs) return _rules.Title + " knows no arcs.";
        if (_relative && !_rules.ArcsInRelativeMode) return _rules.Title + " refuses arcs in relative mode.";
        if (_rules.ArcNamesEnd && !line.HasAny(_plane switch { ArcPlane.XY => "XY", ArcPlane.ZX => "ZX", _ => "YZ" })) return _rules.Title
            + " refuses arcs that do not name their end.";
        if (line.Find('P') >= 0 && _rules.ArcTurns == ArcTurnsRule.Refused) return _rules.Title + " refuses arcs with P.";
        bool hasI = line.TryGet('I', out var i), hasJ = line.TryGet('J', out var j), hasK = line.TryGet('K', out var k), hasR = line.TryGet('R', out var r);
        var centered = hasI || hasJ || hasK;
        if (hasR && centered && _rules.RadiusAndCenter == RadiusAndCenterRule.Refused) return _rules.Title + " refuses arcs with both R and a center.";
        if (hasR && _rules.RadiusArcs && (!centered || _rules.RadiusAndCenter == RadiusAndCenterRule.RadiusWins))
        {
            if (_rules.RadiusInXyOnly && _plane != ArcPlane.XY) return _rules.Title + " takes R in the plane XY only.";
            return ByRadius(start, end, r * Unit, out arc) ? null
                : "An arc by R needs two different points that R reaches; " + _rules.Title + " refuses others.";
        }
        if (centered) return Centered(line, start, end, new Vec3(Center(_x, i, hasI), Center(_y, j, hasJ), Center(_z, k, hasK)), out arc);
        return hasR ? _rules.Title + " knows no arcs by R." : "An arc without center is refused by " + _rules.Title + ".";
    }

    private bool IsClockwise => (_motion == 2) != (_rules.MirroredZx && _plane == ArcPlane.ZX);

    private double Center(double from, double word, bool has) => !_absoluteCenters ? from + word * Unit : has ? word * Unit : from;

    private string? Centered(ParsedLine line, Vec3 start, Vec3 end, Vec3 center, out Arc arc)
    {
        arc = default;
        var clockwise = IsClockwise;
        var (su, sv) = InPlane(start - center);
        var (eu, ev) = InPlane(end - center);
        var radius = Math.Sqrt(su * su + sv * sv);
        if (radius <= NoChange) return "An arc whose center is its start is refused by " + _rules.Title + ".";
        if (_rules.ArcTolerance is { } tolerance && tolerance.Refuses(radius, Math.Sqrt(eu * eu + ev * ev))) return _rules.Title
            + " refuses an arc whose end is not on its circle.";
        var closed = Math.Abs(su - eu) <= NoChange && Math.Abs(sv - ev) <= NoChange;
        if (line.Find('P') >= 0 && _rules.ArcTurns == ArcTurnsRule.OneCircle && (!closed || Rounds(line) != 1)) return _rules.Title
            + " takes P1 of a full circle only.";
        double sweep;
        if (closed)
        {
            if (_motion == 3 && !_rules.CounterclockwiseCircles) return _rules.Title + " draws no full circle by G3.";
            sweep = 360;
        }
        else
        {
            var turn = Angle.Atan2(ev, eu) - Angle.Atan2(sv, su);
            sweep = clockwise ? -turn : turn;
            if (sweep < 0) sweep += 360;
            if (sweep >= 360) sweep -= 360;
        }
        arc = new Arc(center, clockwise ? -sweep : sweep, _plane);
        return null;
    }

    // The shorter arc for R > 0, the longer one for R < 0; where R is too short, a half circle about the middle of the chord.
    private bool ByRadius(Vec3 start, Vec3 end, double radius, out Arc arc)
    {
        arc = default;
        var clockwise = IsClockwise;
        var (u, v) = InPlane(end - start);
        var chord = Math.Sqrt(u * u + v * v);
        if (!(chord > NoChange) || radius == 0 || double.IsInfinity(chord) || double.IsInfinity(radius)) return false;
        var size = Math.Abs(radius);
        if (chord / 2 > size * (1 + _rules.ShortRadius) + _rules.ShortRadiusMm + NoChange) return false;
        var height2 = size * size - chord * chord / 4;
        var height = height2 > 0 ? Math.Sqrt(height2) : 0;
        // Counter-clockwise and short: the center lies to the left of the chord.
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

    private static int Rounds(ParsedLine line) => line.TryGet('P', out var p) && p is >= 1 and < 1e6 ? (int)p : 0;

    private static Arc Longer(Arc arc, int turns) => turns > 0 ? arc with { Sweep = arc.Sweep + (arc.Sweep < 0 ? -360.0 : 360.0) * turns } : arc;

    // Full circles in the plane, one move each.
    private void Circles(Vec3 start, Arc arc, int turns)
    {
        for (var k = 0; k < Math.Min(turns, MostCircles); k++) Arc(start, start, 0, arc with { Sweep = arc.Sweep < 0 ? -360 : 360 });
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
        if (!(length * length < LargestSquare) || IsTooFar(end.X, end.Y, end.Z) || IsTooFar(arc.Center.X, arc.Center.Y, arc.Center.Z)
            || !(Math.Abs(e) < LargestE))
        {
            DecodeCounters.Feeds++;
            OutOfRange();
            return;
        }
        if (Math.Abs(e) < NoChange) e = 0;
        DecodeCounters.Feeds++;
        if (length <= NoChange)
        {
            InPlace(end.X, end.Y, end.Z, e);
            return;
        }
        var rise = end.Z - start.Z;
        var xy = Math.Sqrt(Math.Max(length * length - rise * rise, 0));
        var count = DecodeCounters.Prints;
        Moved(end.X, end.Y, end.Z, e, _motion, length, xy, _plane == ArcPlane.XY && rise == 0);
        _out.AddArc(arc with { Center = arc.Center + new Vec3(_shiftX, _shiftY, _shiftZ) });
        var printed = DecodeCounters.Prints > count;
        if (printed) DecodeCounters.PrintArcs++;
        else DecodeCounters.TravelArcs++;
        Extremes(start, arc, printed ? DecodeCounters.PrintEnds : DecodeCounters.TravelEnds);
    }

    // The outermost points of the circle about the center through the start, as far as the arc passes them.
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
