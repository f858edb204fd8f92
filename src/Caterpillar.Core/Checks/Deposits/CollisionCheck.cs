namespace Caterpillar.Checks;

/// <summary>Collisions of nozzle, print head and gantry with earlier extrusions, the object below the print and bed clips, along any path.</summary>
internal sealed class CollisionCheck
{
    /// <summary>Codes of its findings.</summary>
    public static IReadOnlyList<string> Codes { get; } =
    [
        CheckCodes.NozzleHits, CheckCodes.TravelHits, CheckCodes.HeadHits, CheckCodes.GantryHits, CheckCodes.ClipHit, CheckCodes.Slope,
    ];

    /// <summary>Height in mm that travel moves may touch: slicers travel across new extrusions.</summary>
    public const double Flush = 0.05;
    private const double Everywhere = 1e6;

    // As far as a beam reaches over a part that turns.
    private const double Wide = 2000;
    private const double ClipLine = 0.5;
    private readonly PrintedSoFar _printed;
    private readonly Findings _findings;
    private readonly List<(Bounds Box, string Code)> _boxes = [];
    private readonly Deposit _clips;
    private readonly double _lowest;
    private readonly LeaningHead? _leaning;
    private bool _leans;
    private int? _hit;
    private (Vec3 From, Vec3 To)? _digs;

    // Where the last move ended, and how deep its extrusion may be in another, mm.
    private Vec3? _end;
    private double _depth;

    public CollisionCheck(Printer printer, PrintedSoFar printed, Findings findings)
    {
        _printed = printed;
        _findings = findings;
        foreach (var box in printer.HeadBoxes) _boxes.Add((box, CheckCodes.HeadHits));
        foreach (var box in printer.Beams(Everywhere)) _boxes.Add((box, CheckCodes.GantryHits));
        foreach (var (box, _) in _boxes) _lowest = Math.Min(_lowest, box.Min.Z);
        _clips = Stand(printer.Clips);
        if (printer.Kinematics is { } kinematics) _leaning = HeadOf(printer, kinematics);
    }

    /// <summary>The head of a machine with rotary axes: the boxes of the head, then the beams as far as they reach over a part that turns.</summary>
    public static LeaningHead HeadOf(Printer printer, Kinematics kinematics) => new(kinematics, PrintedSoFar.Outline(printer),
        [.. printer.HeadBoxes, .. printer.Beams(Wide)]);

    /// <summary>Checks a straight move with the height of its extrusion in mm; 0 = no extrusion.</summary>
    public void Check(in CheckedMove move, double height)
    {
        // An extrusion may be printed into another by half its height; from there the nozzle may rise straight up.
        var rises = height == 0 && move.Start == _end && move.End.Z > move.Start.Z && move.End.X == move.Start.X && move.End.Y == move.Start.Y;
        var tolerance = Math.Max(Flush, rises ? _depth : height / 2);
        (_end, _depth) = (move.End, height / 2);
        // One finding for a move, also for the chords of an arc.
        if (move.Index == _hit) return;
        if (_leaning is not null && (_leans |= move.StartTurns != Vec3.Zero || move.EndTurns != Vec3.Zero))
        {
            Lean(move, tolerance);
            return;
        }
        if (IsAbove(move, tolerance)) return;
        _digs = null;
        if (Hits(move, tolerance) || HitsLast(move, tolerance)) _hit = move.Index;
        // Where it goes through something farther on, that is to be told.
        else if (_digs is { } digs) Digs(move, digs.From, digs.To, tolerance);
    }

    // All that is there at the start of a move, then in pieces, before each of which more is not fresh any more.
    private void Lean(in CheckedMove move, double tolerance)
    {
        var whole = new HeadMove(move.Start, move.StartTurns, move.End, move.EndTurns);
        var (from, digs) = (0.0, false);
        for (var piece = 1; ; piece++)
        {
            var to = piece > PrintedSoFar.FreshPieces || !(piece * _printed.FreshPiece < move.Length) ? 1 : piece * _printed.FreshPiece / move.Length;
            if (Hits(move, whole.Part(from, to), tolerance, ref digs))
            {
                _hit = move.Index;
                return;
            }
            if (to == 1) break;
            _printed.Advance(piece * _printed.FreshPiece);
            from = to;
        }
        if (digs) Digs(move, move.Start, move.End, tolerance);
    }

    private bool Hits(in CheckedMove move, in HeadMove part, double tolerance, ref bool digs)
    {
        var contact = _leaning!.Meets(_printed.Strands!, part, tolerance, out var strand);
        digs |= contact == HeadContact.Digs;
        if (contact == HeadContact.Hits) Report(move.Kind == MoveKind.Print ? CheckCodes.NozzleHits : CheckCodes.TravelHits, "nozzle", move, part, strand!.Tag);
        var hit = contact == HeadContact.Hits;
        for (var i = 0; i < _boxes.Count; i++)
        {
            var code = _boxes[i].Code;
            if (!_leaning.MeetsBox(_printed.Strands!, part, tolerance, i, code == CheckCodes.GantryHits, out strand)) continue;
            Report(code, code == CheckCodes.HeadHits ? "print head" : "gantry", move, part, strand!.Tag);
            hit = true;
        }
        return hit;
    }

    private void Report(string code, string body, in CheckedMove move, in HeadMove part, int tag)
    {
        var (a, b) = (part.From, part.To);
        if (tag <= PrintedSoFar.ClipTag) code = CheckCodes.ClipHit;
        _findings.AddNaming(code, move.Index, () => () =>
        {
            var what = tag >= 0 ? "an earlier extrusion" + _findings.InBrackets(tag) : tag == PrintedSoFar.ObjectTag ? "the object below the print"
                : tag == PrintedSoFar.BedTag ? "the bed" : "bed clip " + NumberFormatter.Format(PrintedSoFar.ClipTag - tag + 1);
            return $"The {body} of the leaning tool hits {what} between {a} and {b}. Lean it less, or keep more distance.";
        });
    }

    // Above all that is there, also by this time: most moves of a flat print.
    private bool IsAbove(in CheckedMove move, double tolerance)
    {
        var low = Math.Min(move.Start.Z, move.End.Z) + _lowest;
        var top = Math.Max(_printed.Highest, _printed.Object?.Lines.Highest ?? double.NegativeInfinity);
        return !(top > low + tolerance) && !(_clips.Highest > low);
    }

    // All that is there at the start of a move.
    private bool Hits(in CheckedMove move, double tolerance)
    {
        var hit = Clips(move, move.Start, move.End);
        hit |= Meets(_printed.Deposit, move, tolerance);
        if (_printed.Object is { } thing) hit |= Meets(thing.Lines, move, tolerance);
        return hit;
    }

    private bool Meets(Deposit deposit, in CheckedMove move, double tolerance)
    {
        var contact = deposit.Contacts.Meets(move.Start, move.End, tolerance, _printed.Head, _digs is not null, out var extrusion);
        return Nozzle(contact, deposit, move, move.Start, move.End, tolerance, extrusion)
            | Boxes(deposit, deposit.Highest, move, move.Start, move.End, tolerance);
    }

    // What is fresh at its start is not any more farther on.
    private bool HitsLast(in CheckedMove move, double tolerance)
    {
        for (var piece = 1; piece <= PrintedSoFar.FreshPieces && piece * _printed.FreshPiece < move.Length; piece++)
        {
            var at = Vec3.Lerp(move.Start, move.End, piece * _printed.FreshPiece / move.Length);
            var count = _printed.Advance(piece * _printed.FreshPiece);
            var contact = _printed.MeetsLast(count, at, move.End, tolerance, _digs is not null, out var extrusion);
            if (Nozzle(contact, _printed.Deposit, move, at, move.End, tolerance, extrusion)
                | Boxes(_printed.Deposit, _printed.TopOfLast(count), move, at, move.End, tolerance))
            {
                return true;
            }
        }
        return false;
    }

    private bool Nozzle(HeadContact contact, Deposit deposit, in CheckedMove move, Vec3 a, Vec3 b, double tolerance, int extrusion)
    {
        if (contact == HeadContact.Digs) _digs = (a, b);
        if (contact != HeadContact.Hits) return false;
        Report(move.Kind == MoveKind.Print ? CheckCodes.NozzleHits : CheckCodes.TravelHits, deposit, move, a, b, tolerance, extrusion);
        return true;
    }

    private bool Boxes(Deposit deposit, double top, in CheckedMove move, Vec3 a, Vec3 b, double tolerance)
    {
        var hit = false;
        var low = Math.Min(a.Z, b.Z) + tolerance;
        foreach (var (box, code) in _boxes)
        {
            if (!(top > low + box.Min.Z) || !deposit.Contacts.MeetsBox(a, b, tolerance, box, out var tag)) continue;
            hit = true;
            ReportBox(code, deposit, move, a, tag);
        }
        return hit;
    }

    private bool Clips(in CheckedMove move, Vec3 a, Vec3 b)
    {
        var part = _clips.Contacts.Meets(a, b, 0, _printed.Head, false, out var clip) != HeadContact.None ? "nozzle" : "";
        foreach (var (box, code) in _boxes)
        {
            if (part.Length == 0 && _clips.Contacts.MeetsBox(a, b, 0, box, out clip)) part = code == CheckCodes.HeadHits ? "print head" : "gantry";
        }
        if (part.Length > 0) ReportClip(move, a, b, part, clip);
        return part.Length > 0;
    }

    private void ReportClip(in CheckedMove move, Vec3 a, Vec3 b, string part, int clip)
        => _findings.Add(CheckCodes.ClipHit, move.Index,
            () => $"The {part} hits bed clip {NumberFormatter.Format(clip + 1)} between {a} and {b}. Move the clip or the print.");

    private void Report(string code, Deposit deposit, in CheckedMove move, Vec3 a, Vec3 b, double tolerance, int extrusion)
        => _findings.AddNaming(code, move.Index, () =>
        {
            var at = FirstMeeting(deposit, a, b, tolerance);
            var remedy = code == CheckCodes.TravelHits ? "Raise the travel move" : ReferenceEquals(deposit, _printed.Object?.Lines) ? "Raise the path"
                : "Print the higher extrusion later";
            return () => $"The nozzle hits {What(deposit, extrusion)} at {at}. {remedy}.";
        });

    private void Digs(in CheckedMove move, Vec3 a, Vec3 b, double tolerance)
        => _findings.Add(CheckCodes.Slope, move.Index,
            () => $"The flat of the nozzle tip cuts into a slope next to it by more than {NumberFormatter.Format(tolerance, 2)} mm between {a} and {b}. "
                + "A narrower tip or a gentler slope avoids this.");

    private void ReportBox(string code, Deposit deposit, in CheckedMove move, Vec3 a, int tag)
    {
        var end = move.End;
        _findings.AddNaming(code, move.Index,
            () => () => $"The {(code == CheckCodes.HeadHits ? "print head" : "gantry")} hits {What(deposit, tag)} while the nozzle moves "
            + $"from {a} to {end}. Keep more distance, or print the higher part later.");
    }

    private string What(Deposit deposit, int extrusion)
        => ReferenceEquals(deposit, _printed.Deposit) ? "an earlier extrusion" + _findings.InBrackets(extrusion) : "the object below the print";

    private Vec3 FirstMeeting(Deposit deposit, Vec3 a, Vec3 b, double tolerance)
    {
        while (a.DistanceTo(b) > deposit.Cell)
        {
            var middle = Vec3.Lerp(a, b, 0.5);
            if (deposit.Contacts.Meets(a, middle, tolerance, _printed.Head, true, out _) == HeadContact.Hits) b = middle;
            else a = middle;
        }
        return new Vec3(Math.Round(a.X, 2), Math.Round(a.Y, 2), Math.Round(a.Z, 2));
    }

    // Boxes as extrusions side by side, of their height.
    private Deposit Stand(ValueList<Bounds> clips)
    {
        var deposit = new Deposit(_printed.Deposit.Cell, Everywhere);
        for (var i = 0; i < clips.Count; i++)
        {
            var (min, max) = (clips[i].Min, clips[i].Max);
            var extrusions = Math.Max((int)Math.Ceiling(clips[i].Size.Y / ClipLine), 1);
            var half = clips[i].Size.Y / extrusions / 2;
            var inset = Math.Min(half, clips[i].Size.X / 2);
            for (var k = 0; k < extrusions; k++)
            {
                var y = min.Y + (2 * k + 1) * half;
                deposit.Add(new Vec3(min.X + inset, y, max.Z), new Vec3(max.X - inset, y, max.Z), half, i);
            }
        }
        return deposit;
    }
}
