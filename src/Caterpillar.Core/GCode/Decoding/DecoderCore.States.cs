using System;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Geometry;

namespace Caterpillar.GCode;

/// <summary>States that a file keeps and brings back: M120 and M121, and the named ones of extended commands.</summary>
internal sealed partial class DecoderCore
{
    private const int MostStates = 100;

    // Replaced, never changed.
    private KeptState[] _modeStack = [];
    private KeptState[] _namedStates = [];

    // What SET_GCODE_OFFSET has put between the coordinates of the file and those of the machine; homing keeps it.
    private Vec3 _offset;
    private double _offsetE;

    private void PushModes()
    {
        if (_modeStack.Length < MostStates) _modeStack = [.. _modeStack, Keep("")];
    }

    private void PopModes()
    {
        if (_modeStack.Length == 0) return;
        var kept = _modeStack[_modeStack.Length - 1];
        _modeStack = _modeStack.Take(_modeStack.Length - 1).ToArray();
        _inches = kept.Inches;
        _volumetric = kept.Volumetric;
        _plane = kept.Plane;
        Bring(kept);
    }

    private KeptState Keep(string name) => new(name)
    {
        Relative = _relative,
        LastRelative = _lastRelative,
        M83 = _m83,
        Inches = _inches,
        Volumetric = _volumetric,
        Plane = _plane,
        Feed = _feed,
        FeedFactor = _feedFactor,
        Flow = _flow,
        E = _e,
        Shift = new Vec3(_shiftX, _shiftY, _shiftZ),
        Place = new Vec3(_x + _shiftX, _y + _shiftY, _z + _shiftZ),
        Offset = _offset,
        OffsetE = _offsetE,
    };

    private void Bring(KeptState kept)
    {
        _relative = kept.Relative;
        _lastRelative = kept.LastRelative;
        _m83 = kept.M83;
        _feed = kept.Feed;
        _speed = _feed / 60 * _feedFactor;
        Modes();
    }

    // True when the command is one of the three.
    private bool NamedState(string name, string words)
    {
        switch (name)
        {
            case "SAVE_GCODE_STATE":
                var state = Word(words, "NAME") ?? "DEFAULT";
                _namedStates = [.. _namedStates.Where(s => s.Name != state).Take(MostStates), Keep(state)];
                return true;
            case "RESTORE_GCODE_STATE":
                RestoreState(words);
                return true;
            case "SET_GCODE_OFFSET":
                SetOffset(words);
                return true;
            default:
                return false;
        }
    }

    private void RestoreState(string words)
    {
        var name = Word(words, "NAME") ?? "DEFAULT";
        if (_namedStates.FirstOrDefault(s => s.Name == name) is not { } kept)
        {
            Refused("gcode.state", "RESTORE_GCODE_STATE of a state that was not saved is refused.");
            return;
        }
        _feedFactor = kept.FeedFactor;
        _flow = kept.Flow;
        Bring(kept);
        Shift(kept.Shift.X, kept.Shift.Y, kept.Shift.Z);
        _offset = kept.Offset;
        _offsetE = kept.OffsetE;
        _e = _shadowE = kept.E;
        if (Number(words, "MOVE") is { } move && move != 0) MoveTo(kept.Place.X, kept.Place.Y, kept.Place.Z, words);
    }

    private void SetOffset(string words)
    {
        var before = _offset;
        _offset = new Vec3(Changed(words, "X", before.X), Changed(words, "Y", before.Y), Changed(words, "Z", before.Z));
        var e = Changed(words, "E", _offsetE);
        var change = _offset - before;
        Shift(_shiftX + change.X, _shiftY + change.Y, _shiftZ + change.Z);
        _e -= e - _offsetE;
        _shadowE = _e;
        _offsetE = e;
        if (Number(words, "MOVE") is { } move && move != 0) MoveTo(_x + _shiftX + change.X, _y + _shiftY + change.Y, _z + _shiftZ + change.Z, words);
    }

    private static double Changed(string words, string axis, double before)
    {
        var value = Number(words, axis) ?? (Number(words, axis + "_ADJUST") is { } more ? before + more : before);
        return value is > -Largest and < Largest ? value : before;
    }

    // To a place in machine coordinates.
    private void MoveTo(double x, double y, double z, string words)
    {
        var speed = _speed;
        if (Number(words, "MOVE_SPEED") is { } own && own is > 0 and < 1e6) _speed = own;
        Linear(x - _shiftX, y - _shiftY, z - _shiftZ, 0, 1);
        _speed = speed;
    }

    private static double? Number(string words, string key) => Word(words, key) is { } text && NumberReader.TryParse(text, out var value) ? value : null;

    private static string? Word(string words, string key)
    {
        for (var at = 0; (at = words.IndexOf(key + "=", at, StringComparison.Ordinal)) >= 0; at += key.Length)
        {
            if (at > 0 && words[at - 1] > ' ') continue;
            at += key.Length + 1;
            var end = at;
            while (end < words.Length && words[end] > ' ') end++;
            return words.Substring(at, end - at).Trim('"', '\'');
        }
        return null;
    }
}

/// <summary>Modes and places as they were kept.</summary>
internal sealed record KeptState(string Name)
{
    public bool Relative;
    public bool LastRelative;
    public bool M83;
    public bool Inches;
    public bool Volumetric;
    public ArcPlane Plane;
    public double Feed;
    public double FeedFactor;
    public double Flow;
    public double E;
    public Vec3 Shift;
    public Vec3 Place;
    public Vec3 Offset;
    public double OffsetE;
}
