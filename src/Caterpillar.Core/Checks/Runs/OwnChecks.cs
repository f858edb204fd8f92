namespace Caterpillar.Checks;

/// <summary>Shows moves to the checks of the user, block by block.</summary>
internal sealed class OwnChecks(PrintSetup setup, Findings findings)
{
    private readonly IOwnCheck[] _checks = [.. setup.OwnChecks.Select(make => make())];
    private Vec3? _at;

    /// <summary>The next block.</summary>
    public void Take(DecodedBlock block)
    {
        if (_checks.Length == 0) return;
        var c = block.Columns;
        for (var i = 0; i < c.Count; i++)
        {
            var end = new Vec3(c.X[i], c.Y[i], c.Z[i]);
            Arc? arc = c.TryGetArc(i, out var turn) ? turn : null;
            var move = new Move(block.First + i, _at ?? block.Start ?? Vec3.Zero, end, c.E[i], c.Deposited[i], c.Speed[i], c.Kind[i], c.Role[i],
                c.Layer[i], c.Tool[i], c.Source[i], arc);
            foreach (var check in _checks)
            {
                if (check.Look(move) is { } found) findings.Add(found, move.Index);
            }
            _at = end;
        }
    }
}
