namespace Caterpillar.Checks;

/// <summary>Gaps in continuous paths: a short travel between two extrusions that go on in the same direction.</summary>
internal sealed class GapCheck(Findings findings) : MoveCheck
{
    /// <summary>Longest gap, mm; longer ones are meant.</summary>
    public const double Longest = 1;

    /// <summary>Shorter ones are none.</summary>
    public const double Shortest = 0.1;

    // Cosine of the largest turn, 10°.
    private const double Straight = 0.985;
    private Vec3 _before;
    private Vec3 _gapStart;
    private bool _printed;
    private bool _gap;
    private Role _role;

    public override IReadOnlyList<string> Codes => [CheckCodes.Gap];

    public override void Move(in CheckedMove move)
    {
        if (!(move.Length > 0)) return;
        var along = move.End - move.Start;
        if (move.Kind == MoveKind.Print && move.Arc is null && move.Deposited > 0)
        {
            // Supports come in pieces.
            var isOne = move.Role == _role && move.Role is not (Role.Support or Role.SupportInterface);
            if (_gap && isOne && Continues(_before, move.Start - _gapStart) && Continues(move.Start - _gapStart, along)) Report(move);
            _before = along;
            _role = move.Role;
            _printed = true;
            _gap = false;
            return;
        }
        _gap = move.Kind == MoveKind.Travel && _printed && move.StartKnown && move.Length is > Shortest and < Longest;
        _gapStart = move.Start;
        _printed = false;
    }

    private void Report(in CheckedMove move)
    {
        var (from, gap) = (_gapStart, _gapStart.DistanceTo(move.Start));
        findings.Add(CheckCodes.Gap, move.Index,
            () => $"A straight line of extrusions has a gap of {NumberFormatter.Format(gap, 2)} mm at {from}. Join the paths.");
    }

    private static bool Continues(Vec3 a, Vec3 b) => Vec3.Dot(a, b) >= Straight * a.Length * b.Length;
}
