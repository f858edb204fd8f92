namespace Caterpillar.GH.Components.Path;

/// <summary>How numbers change between the vertices of a path.</summary>
public enum Interpolation
{
    Linear,
    Steps,
}

/// <summary>
/// Widths, heights, speeds and flows of a path: one for all of it, one for each vertex, or one for each segment, as Deconstruct Print Path gives them.
/// </summary>
internal sealed class VertexNumbers(Run run)
{
    private static readonly string[] Names = ["Widths", "Heights", "Speeds", "Flows"];
    private readonly double[][] _lists = Array.ConvertAll(Names, n => run.List<GH_Number>(run[n]).Select(g => g.Value).ToArray());

    /// <summary>True if the area of the bead follows from width, height and flow.</summary>
    public bool SetsArea => _lists[0].Length > 0 || _lists[1].Length > 0 || _lists[3].Length > 0;

    /// <summary>True if each number holds from its vertex to the next.</summary>
    public bool IsStepped { get; private set; } = run.Choice<Interpolation>(run["Interpolation"]) == Interpolation.Steps;

    /// <summary>The parts of a key.</summary>
    public object?[] Key => [IsStepped, .. _lists.Select(l => (object?)Array.ConvertAll(l, v => (object?)v))];

    public static void Declare(InputPorts ports)
    {
        const string Each = "One for all, or one for each vertex; on curves that are not polylines, at equal distances. ";
        Numbers("Widths", "W", Each + "In mm. Default: width of the bead.");
        Numbers("Heights", "H", Each + "In mm. Default: height of the bead.");
        Numbers("Speeds", "V", Each + "In mm/s, 0 = speed of the print settings. Default: speed of the bead.");
        Numbers("Flows", "F", Each + "Flow ratio of width × height. Default: 1.");
        ports.Choice("Interpolation", "In", "How numbers change between vertices: evenly (Linear), or at each vertex (Steps).", Interpolation.Linear);

        void Numbers(string name, string nick, string description)
            => ports.Add(new Param_Number(), name, nick, description, GH_ParamAccess.list, optional: true);
    }

    /// <summary>The curve with the numbers.</summary>
    /// <exception cref="InputProblem">There are not as many as vertices or segments.</exception>
    public UserCurve On(UserCurve curve)
    {
        var line = (curve.Curve as PolylineCurve)?.Polyline;
        var count = line?.Count ?? _lists.Max(l => l.Length);
        for (var i = 0; i < _lists.Length; i++)
        {
            var given = _lists[i].Length;
            if (given <= 1 || given == count) continue;
            if (line is null) throw new InputProblem($"{Names[i]} has {Text(given)} numbers, but another list has {Text(count)}.");
            if (given != line.SegmentCount)
            {
                throw new InputProblem($"{Names[i]} has {Text(given)} numbers, but the curve has {Text(count)} vertices. "
                    + "Give one for all, or one for each vertex (of a closed curve the first one only once).");
            }
            // One for each segment: they begin at all vertices but the last.
            IsStepped = true;
        }
        double? One(int list) => _lists[list].Length == 1 ? _lists[list][0] : null;
        IEnumerable<double>? Many(int list)
            => _lists[list] is { Length: > 1 } all ? all.Concat(all.Skip(all.Length - 1).Take(count - all.Length)) : null;
        curve = curve with
        {
            Width = One(0) ?? curve.Width, Height = One(1) ?? curve.Height, Speed = One(2) ?? curve.Speed, Flow = One(3) ?? curve.Flow,
        };
        return count < 2 ? curve : curve with { Along = new PointValues(null, Many(0), Many(1), Many(2), Many(3)) };
    }

    private static string Text(int count) => NumberFormatter.Format(count);
}
