namespace Caterpillar.Checks;

/// <summary>Rules for a whole file: home before printing, and have a known position.</summary>
internal sealed class FileCheck(Toolpath toolpath, CheckScope scope, Findings findings) : MoveCheck
{
    private bool _homes;
    private bool _hasPrinted;
    private bool _hasX = toolpath.Start is not null, _hasY = toolpath.Start is not null, _hasZ = toolpath.Start is not null;

    public override IReadOnlyList<string> Codes => [CheckCodes.NoHoming, CheckCodes.UnknownPosition];

    public override void Event(MoveEvent what)
    {
        if (what.Event is not HomeEvent home) return;
        _homes = true;
        _hasX |= home.X;
        _hasY |= home.Y;
        _hasZ |= home.Z;
    }

    public override void Move(in CheckedMove move)
    {
        _hasX |= move.End.X != move.Start.X;
        _hasY |= move.End.Y != move.Start.Y;
        _hasZ |= move.End.Z != move.Start.Z;
        if (!_hasPrinted && move.Kind == MoveKind.Print && move.E > 0 && move.Length > 0) PrintsFirst(move);
    }

    private void PrintsFirst(in CheckedMove move)
    {
        _hasPrinted = true;
        if (!scope.IsWholeFile || scope.Homes) return;
        if (!_homes) findings.Add(CheckCodes.NoHoming, move.Index, () => "The file prints without homing first. Add G28 to the start G-code.");
        if (_hasX && _hasY && _hasZ) return;
        var axes = string.Join(", ", new[] { _hasX ? "" : "X", _hasY ? "" : "Y", _hasZ ? "" : "Z" }.Where(a => a.Length > 0));
        findings.Add(CheckCodes.UnknownPosition, move.Index, () => $"The file prints before the position in {axes} is known. Home first, or move in {axes}.");
    }
}
