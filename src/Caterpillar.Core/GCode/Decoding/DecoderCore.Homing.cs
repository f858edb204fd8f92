using System;
using Caterpillar.Geometry;
using Caterpillar.Toolpaths;

namespace Caterpillar.GCode;

/// <summary>G28 and its like.</summary>
internal sealed partial class DecoderCore
{
    // Positions of G28 and G30 that a file stores by G28.1 and G30.1, in machine coordinates; those of the machine itself are taken as zero.
    private Vec3 _stored28;
    private Vec3 _stored30;

    private void Home(ParsedLine line)
    {
        Axes(line, out var x, out var y, out var z);
        var moves = (x && _x + _shiftX != 0) || (y && _y + _shiftY != 0) || (z && _z + _shiftZ != 0);
        AddEvent(new HomeEvent(x, y, z));
        if (_rules.HomingSelectsXy) _plane = ArcPlane.XY;
        var (ox, oy, oz) = Origin();
        if (_rules.HomingKeepsShifts) (ox, oy, oz) = (_shiftX, _shiftY, _shiftZ);
        if (x) Homed(line, 'X', ox + _offset.X, ref _x, ref _shiftX, ref _knownX);
        if (y) Homed(line, 'Y', oy + _offset.Y, ref _y, ref _shiftY, ref _knownY);
        if (z) Homed(line, 'Z', oz + _offset.Z, ref _z, ref _shiftZ, ref _knownZ);
        _wasPrint = false;
        // The way home is a move of the toolpath, though not of the file's own.
        if (moves && _started) Emit(_x, _y, _z, 0, 0, MoveKind.Travel);
    }

    private static void Axes(ParsedLine line, out bool x, out bool y, out bool z)
    {
        x = line.Has('X');
        y = line.Has('Y');
        z = line.Has('Z');
        if (!x && !y && !z) x = y = z = true;
    }

    private void Homed(ParsedLine line, char letter, double origin, ref double position, ref double shift, ref bool known)
    {
        if (_rules.HomesToNumber && line.TryGet(letter, out var number) && Math.Abs(number) is >= 1 and < Largest) origin -= number;
        shift = origin;
        position = -origin;
        known = true;
    }

    // Over the point named to the stored position, in the axes named.
    private void GoToStored(ParsedLine line, int which)
    {
        var x = line.TryGet('X', out var wx) ? Target(_x, wx, _shiftX) : _x;
        var y = line.TryGet('Y', out var wy) ? Target(_y, wy, _shiftY) : _y;
        var z = line.TryGet('Z', out var wz) ? Target(_z, wz, _shiftZ) : _z;
        if (IsTooFar(x, y, z))
        {
            OutOfRange();
            return;
        }
        Axes(line, out var hasX, out var hasY, out var hasZ);
        _wasPrint = false;
        var stored = which == 0 ? _stored28 : _stored30;
        var (sx, sy, sz) = (hasX ? stored.X - _shiftX : x, hasY ? stored.Y - _shiftY : y, hasZ ? stored.Z - _shiftZ : z);
        // The way to the point named is a travel like others, the way from there the one home.
        if (x != sx || y != sy || z != sz) GoTo(x, y, z);
        AddEvent(new HomeEvent(hasX, hasY, hasZ));
        GoTo(sx, sy, sz);
        _knownX |= hasX;
        _knownY |= hasY;
        _knownZ |= hasZ;
    }

    private void GoTo(double x, double y, double z)
    {
        var moves = x != _x || y != _y || z != _z;
        if (moves && _started) Emit(x, y, z, 0, 0, MoveKind.Travel);
        (_x, _y, _z) = (x, y, z);
    }

    private void Store(int which)
    {
        var here = new Vec3(_x + _shiftX, _y + _shiftY, _z + _shiftZ);
        if (which == 0) _stored28 = here;
        else _stored30 = here;
    }
}
