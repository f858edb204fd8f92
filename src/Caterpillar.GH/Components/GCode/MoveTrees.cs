namespace Caterpillar.GH.Components.GCode;

/// <summary>The moves of a toolpath as Deconstruct Toolpath gives them: a branch per layer, or one value for all moves.</summary>
internal sealed class MoveTrees(
    GH_Structure<GH_Point> points, GH_Structure<GH_Number> amounts, GH_Structure<GH_Number> speeds, GH_Structure<GH_String>? kinds,
    GH_Structure<GH_String>? roles)
{
    private const double SameHeight = 1e-6;
    private readonly IList<GH_Path> _places = points.Paths;
    private readonly IList<List<GH_Point>> _points = points.Branches;
    private double _retracted;
    private double _below;

    /// <summary>Dwells, which are left out: their durations are events.</summary>
    public int Dwells { get; private set; }

    /// <exception cref="InputProblem">The trees do not fit to each other, or a value can't be used.</exception>
    public Toolpath Build(PrintSetup setup, DocumentUnits units, CancellationToken cancel)
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, null);
        for (var branch = 0; branch < _points.Count; branch++)
        {
            cancel.ThrowIfCancellationRequested();
            var moves = Moves(branch, units).ToArray();
            var layer = builder.AddLayer(LayerOf(_places[branch], moves));
            foreach (var move in moves) Add(builder, move, layer);
        }
        return builder.Build(Enumerable.Range(0, setup.Printer.ToolCount).Select(t => new ToolpathTool(setup.OfTool(t).Extrusion.VolumePerE)));
    }

    private IEnumerable<Given> Moves(int branch, DocumentUnits units)
    {
        var (e, speed) = (Values("E Values", amounts, branch), Values("Speeds", speeds, branch));
        var (kind, role) = (kinds is null ? null : Values("Kinds", kinds, branch), roles is null ? null : Values("Roles", roles, branch));
        for (var i = 0; i < _points[branch].Count; i++)
        {
            var end = _points[branch][i] is { IsValid: true } point ? RhinoGeometry.ToVec(point, units)
                : throw new InputProblem($"Points: item {Text(i)} of branch {_places[branch]} is not a point.");
            yield return new Given(end, e(i).Value, speed(i).Value, kind is null ? null : Word<MoveKind>("Kinds", kind(i).Value),
                role is null ? Role.Unspecified : Word<Role>("Roles", role(i).Value));
        }
    }

    private void Add(ToolpathBuilder builder, Given move, int layer)
    {
        var moves = move.End.DistanceTo(builder.Position) > 1e-9;
        var kind = move.Kind ?? KindOf(move.E, moves);
        if (kind == MoveKind.Dwell)
        {
            Dwells++;
            return;
        }
        if (!(move.Speed > 0) || double.IsInfinity(move.Speed)) throw new InputProblem("Speeds must be greater than zero and finite.");
        if (double.IsNaN(move.E) || double.IsInfinity(move.E)) throw new InputProblem("E Values must be finite.");
        // What was retracted comes back first.
        var restored = Math.Max(Math.Min(move.E, _retracted), 0);
        _retracted -= move.E < 0 ? move.E : restored;
        var deposited = kind is MoveKind.Print or MoveKind.Prime ? Math.Max(move.E - restored, 0) : 0;
        builder.Add(move.End, move.E, deposited, move.Speed, kind, move.Role, layer, 0, -1);
    }

    private MoveKind KindOf(double e, bool moves)
    {
        if (moves) return e > 0 ? MoveKind.Print : e < 0 ? MoveKind.Wipe : MoveKind.Travel;
        return e < 0 ? MoveKind.Retract : e == 0 ? MoveKind.Travel : _retracted > 0 ? MoveKind.Deretract : MoveKind.Prime;
    }

    // A level layer reaches down to the one below it.
    private Layer LayerOf(GH_Path path, Given[] moves)
    {
        var heights = moves.Where(m => m.E > 0 && m.Kind is MoveKind.Print or null).Select(m => m.End.Z).DefaultIfEmpty(_below).ToArray();
        var top = heights.Max();
        var thickness = top - heights.Min() <= SameHeight ? Math.Max(top - _below, 0) : 0;
        _below = top;
        return new Layer(path.Indices[path.Length - 1], top, thickness);
    }

    // The values of a branch by the places of their points.
    private Func<int, T> Values<T>(string name, GH_Structure<T> tree, int branch)
        where T : class, IGH_Goo
    {
        var count = _points[branch].Count;
        var place = _places[branch];
        if (tree.PathCount != 1 && tree.PathCount != _points.Count)
            throw new InputProblem($"{name} has {Text(tree.PathCount)} branches, but Points has {Text(_points.Count)}.");
        var values = tree.Branches[tree.PathCount == 1 ? 0 : branch];
        if (values.Count != 1 && (values.Count != count || tree.PathCount != _points.Count))
        {
            throw new InputProblem($"{name} has {Text(values.Count)} values for the {Text(count)} points of branch {place}. "
                + "Give one for all, or one for each.");
        }
        return i => values[values.Count == 1 ? 0 : i] ?? throw new InputProblem($"{name}: item {Text(i)} of branch {place} is null.");
    }

    private static T Word<T>(string name, string text)
        where T : struct, Enum
        => Enum.TryParse<T>(string.Concat(text.Split(' ')), true, out var value) && Enum.IsDefined(typeof(T), value) ? value
            : throw new InputProblem($"{name} has no {text}. Use one of: {string.Join(", ", Enum.GetNames(typeof(T)))}.");

    private static string Text(int number) => NumberFormatter.Format(number);

    private readonly record struct Given(Vec3 End, double E, double Speed, MoveKind? Kind, Role Role);
}
