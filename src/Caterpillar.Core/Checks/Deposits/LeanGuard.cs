namespace Caterpillar.Checks;

/// <summary>Tells planning which moves the collision check would refuse, for a tool that leans.</summary>
internal sealed class LeanGuard
{
    private readonly PrintSetup _setup;
    private readonly Kinematics _kinematics;
    private readonly Toolpath _toolpath;
    private readonly LeaningHead _head;
    private readonly StrandGrid _strands;
    private readonly int _boxes;
    private readonly double _lag;

    /// <param name="setup">The printer and what is printed on.</param>
    /// <param name="kinematics">Its axes.</param>
    /// <param name="toolpath">The plan, whose layers say how high extrusions are.</param>
    public LeanGuard(PrintSetup setup, Kinematics kinematics, Toolpath toolpath)
    {
        (_setup, _kinematics, _toolpath) = (setup, kinematics, toolpath);
        var printed = new PrintedSoFar(setup);
        (_strands, _lag) = (printed.Strands!, printed.Lag);
        _head = CollisionCheck.HeadOf(setup.Printer, kinematics);
        _boxes = setup.Printer.HeadBoxes.Count + setup.Printer.Gantry.Count;
    }

    /// <summary>True if the head would hit what was printed before, the object, the bed or clips, or if a travel leaves the build volume.</summary>
    public bool Refuses(Move move, HeadMove head)
    {
        if (move.Kind == MoveKind.Travel && (!_setup.Printer.CanReach(head.To, 0) || !_kinematics.IsWithin(head.ToTurns))) return true;
        return Hits(_strands, move, head);
    }

    /// <summary>
    /// The moves of a bead, by their place in it, at which the head would hit what was printed before, also by the bead itself; and those at its ends where a
    /// travel would.
    /// </summary>
    public IReadOnlyList<int> RefusedIn(IEnumerable<(Move Move, HeadMove Head)> bead)
    {
        var refused = new List<int>();
        var own = new StrandGrid();
        var fresh = new Queue<(Move Move, HeadMove Head, double End)>();
        var (length, i) = (0.0, 0);
        var travel = new Move { Kind = MoveKind.Travel, Layer = -1 };
        foreach (var (move, head) in bead)
        {
            if (i == 0 && Refuses(travel, head.Part(0, 0))) refused.Add(0);
            while (fresh.Count > 0 && fresh.Peek().End + _lag <= length)
            {
                var printed = fresh.Dequeue();
                Add(own, printed.Move, printed.Head);
            }
            if (Refuses(move, head) || Hits(own, move, head)) refused.Add(i);
            length += move.Length;
            fresh.Enqueue((move, head, length));
            i++;
        }
        if (fresh.Count > 0 && fresh.Last().Head.Part(1, 1) is var end && (Refuses(travel, end) || Hits(own, travel, end))) refused.Add(i - 1);
        return refused;
    }

    /// <summary>What a move prints can be hit from now on.</summary>
    public void Add(Move move, HeadMove head) => Add(_strands, move, head);

    private bool Hits(StrandGrid strands, in Move move, HeadMove head)
    {
        var tolerance = move.Kind == MoveKind.Print ? Math.Max(CollisionCheck.Flush, HeightOf(move) / 2) : CollisionCheck.Flush;
        if (_head.Meets(strands, head, tolerance, out _) == HeadContact.Hits) return true;
        for (var i = 0; i < _boxes; i++)
        {
            if (_head.MeetsBox(strands, head, tolerance, i, i >= _setup.Printer.HeadBoxes.Count, out _)) return true;
        }
        return false;
    }

    private void Add(StrandGrid strands, in Move move, HeadMove head)
    {
        if (!(move.Length > 0) || !(_toolpath.VolumePerE(move.Tool) * move.Deposited > 0)) return;
        var area = _toolpath.VolumePerE(move.Tool)!.Value * move.Deposited / move.Length;
        var width = new Bead(area, HeightOf(move)).Width(_setup.Settings.BeadShape);
        var half = Math.Min(width, PrintedSoFar.Widest * _setup.Printer.NozzleDiameter) / 2;
        strands.Add(head.From, head.To, half, _kinematics.Direction(Vec3.Lerp(head.FromTurns, head.ToTurns, 0.5)), move.Index);
    }

    private double HeightOf(in Move move)
        => move.Layer >= 0 && _toolpath.Layers[move.Layer].Thickness > 0 ? _toolpath.Layers[move.Layer].Thickness : _setup.Settings.LargerLayerHeight;
}
