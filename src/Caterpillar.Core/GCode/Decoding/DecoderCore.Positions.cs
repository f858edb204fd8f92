using Caterpillar.Dialects;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;

namespace Caterpillar.GCode;

/// <summary>Names of positions: start, G28, G92.</summary>
internal sealed partial class DecoderCore
{
    // A place is known once the file has homed, named or moved to it.
    private bool _knownX;
    private bool _knownY;
    private bool _knownZ;
    private bool _startKnown;
    private double _startX;
    private double _startY;
    private double _startZ;

    private bool _started;

    private void NoteStart()
    {
        _started = true;
        _startX = _x + _shiftX;
        _startY = _y + _shiftY;
        _startZ = _z + _shiftZ;
        _startKnown = _knownX && _knownY && _knownZ;
        _knownX = _knownY = _knownZ = true;
    }

    // G92: the place gets another name; the head stays.
    private void Rename(ParsedLine line)
    {
        var xyz = false;
        if (line.TryGet('X', out var x)) xyz |= RenameAxis(x, ref _x, ref _shiftX, ref _knownX);
        if (line.TryGet('Y', out var y)) xyz |= RenameAxis(y, ref _y, ref _shiftY, ref _knownY);
        if (line.TryGet('Z', out var z)) xyz |= RenameAxis(z, ref _z, ref _shiftZ, ref _knownZ);
        if (xyz) Features.G92Xyz++;
        if (RenameE(line)) Features.G92E++;
        RenameTurns(line);
        if (line.Count == 1) BareG92();
    }

    private bool RenameAxis(double word, ref double position, ref double shift, ref bool known)
    {
        word *= Unit;
        if (!(word is > -Largest and < Largest))
        {
            OutOfRange();
            return false;
        }
        // Before the axis has moved or homed, the name is all there is to know.
        if (known) shift += position - word;
        position = word;
        known = true;
        _wasPrint = false;
        return true;
    }

    private bool RenameE(ParsedLine line)
    {
        if (!_axis.HasAmounts) return false;
        if (_axis == ExtrusionAxis.Both)
        {
            var any = line.TryGet('A', out var a);
            if (any) _a = a;
            if (line.TryGet('B', out var b)) _b = b;
            else if (!any) return false;
            return true;
        }
        if (!line.TryGet((char)_axis.Letter, out var e)) return false;
        e *= UnitOfE;
        if (!(e is > -LargestE and < LargestE)) return false;
        _e = _shadowE = e;
        return true;
    }

    private void BareG92()
    {
        Features.G92All++;
        Differs("gcode.dialect_g92", "G92 without letters means different things to firmwares; here as " + _rules.Title + " takes it.");
        switch (_rules.BareG92)
        {
            case BareG92Rule.ZeroAll:
                RenameAxis(0, ref _x, ref _shiftX, ref _knownX);
                RenameAxis(0, ref _y, ref _shiftY, ref _knownY);
                RenameAxis(0, ref _z, ref _shiftZ, ref _knownZ);
                _e = _shadowE = _a = _b = 0;
                return;
            case BareG92Rule.ClearShifts:
                ClearShifts();
                _e = _shadowE = _a = _b = 0;
                return;
            default:
                return;
        }
    }

    // What G92 has shifted; the zero of a workspace stays.
    private void ClearShifts()
    {
        var (x, y, z) = Origin();
        Shift(x, y, z);
        _wasPrint = false;
    }

    // Coordinates as written get another zero; the head stays.
    private void Shift(double x, double y, double z)
    {
        _x += _shiftX - x;
        _y += _shiftY - y;
        _z += _shiftZ - z;
        (_shiftX, _shiftY, _shiftZ) = (x, y, z);
    }
}
