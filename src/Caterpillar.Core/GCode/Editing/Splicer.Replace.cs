using System.Collections.Generic;
using Caterpillar.Basics;
using Caterpillar.Dialects;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;

namespace Caterpillar.GCode;

/// <summary>Other start and end code around the layers of a file.</summary>
internal sealed partial class Splicer
{
    private int _firstKept;
    private int _lastKept = int.MaxValue;
    private IReadOnlyList<string> _start = [];
    private IReadOnlyList<string> _end = [];

    /// <summary>Lines in place of those before the first layer and behind the last.</summary>
    public void Replace(EditOptions options, SplicePlan plan)
    {
        if (options.Start is null && options.End is null) return;
        var toolpath = _decoding.Toolpath;
        var first = _decoding.FirstMarkLine;
        var last = 0;
        for (var block = 0; block < toolpath.Blocks.Count; block++)
        {
            var c = toolpath.Blocks[block].Columns;
            for (var i = 0; i < c.Count; i++)
            {
                if (c.Kind[i] != MoveKind.Print || c.Layer[i] < 0) continue;
                if (first == 0) first = c.Source[i];
                last = c.Source[i];
            }
        }
        if (last == 0)
        {
            Diagnostics.Add(Severity.Warning, "gcode.no_layers", "The file prints no layer: its start and end code stay.");
            return;
        }
        if (options.Start is not null)
        {
            _firstKept = first;
            _start = options.Start;
            plan.Touch(1, first);
        }
        if (options.End is null) return;
        _lastKept = last;
        _end = options.End;
        plan.Touch(last, int.MaxValue);
    }

    // The new start code, and then what the first line that stays expects.
    private void Begin()
    {
        foreach (var line in _start) Command(line);
        var wanted = _in.Save();
        var now = _now.Save();
        if (wanted.Inches != now.Inches) Command(wanted.Inches ? "G20" : "G21");
        if (wanted.Tool != now.Tool) Event(new ToolEvent(wanted.Tool));
        if (wanted.Plane != now.Plane) Command("G" + NumberFormatter.Format(17 + (int)wanted.Plane));
        if (now.Relative) Command("G90");
        var unit = wanted.Inches ? 25.4 : 1;
        now = _now.Save();
        var place = new Vec3(wanted.X + wanted.ShiftX, wanted.Y + wanted.ShiftY, wanted.Z + wanted.ShiftZ);
        if (wanted.Started && place != new Vec3(now.X + now.ShiftX, now.Y + now.ShiftY, now.Z + now.ShiftZ))
            Command("G0 X" + Text(place.X - now.ShiftX, unit) + " Y" + Text(place.Y - now.ShiftY, unit) + " Z" + Text(place.Z - now.ShiftZ, unit));
        if (wanted.ShiftX != now.ShiftX || wanted.ShiftY != now.ShiftY || wanted.ShiftZ != now.ShiftZ)
            Command("G92 X" + Text(wanted.X, unit) + " Y" + Text(wanted.Y, unit) + " Z" + Text(wanted.Z, unit));
        Command(wanted.Relative ? "G91" : "G90");
        if (_extruder != 0 && _rules.RelativeE != RelativeERule.OnlyG90G91) Command(wanted.M83
            || (_rules.RelativeE == RelativeERule.LastWins && wanted.LastRelative) ? "M83" : "M82");
        if (_extruder != 0 && !_now.IsRelativeE) Command("G92 " + (char)_extruder + Text(wanted.E, _now.Save().UnitOfE));
        if (wanted.Feed > 0 && wanted.Feed != _now.Save().Feed) State("G1", 'F', wanted.Feed / unit, _style.DecimalsF);
    }
}
