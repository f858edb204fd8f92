namespace Caterpillar.Machines;

/// <summary>Formats of keys that a row of a table cannot describe, by their properties.</summary>
internal static class OwnFormats
{
    private const double Far = 100_000;

    private static readonly string[] Box = ["min x", "min y", "min z", "max x", "max y", "max z"];

    private static readonly LinesFormat Template = new(PrintTemplate.Error);

    public static readonly IReadOnlyDictionary<string, KeyFormat> Printer = new Dictionary<string, KeyFormat>(StringComparer.Ordinal)
    {
        ["Flavor"] = new ChoiceFormat([.. FlavorTable.All.Select(d => (d.Name, (object)d))]),
        ["ToolOffsets"] = new RowsFormat<Vec3>(["x", "y", "z"], 64, -10_000, 10_000, n => new Vec3(n[0], n[1], n[2]), v => [v.X, v.Y, v.Z]) { Fewest = 1 },
        ["HeadOutline"] = new RowsFormat<HeadPoint>(
            ["radius", "height"], 64, 0, 10_000, n => new HeadPoint(n[0], n[1]), h => [h.Radius, h.Height], Ascends) { Fewest = 1 },
        ["HeadBoxes"] = new RowsFormat<Bounds>(Box, 64, -10_000, 10_000, MakeBox, TakeBox),
        ["Gantry"] = new RowsFormat<Bounds>(
            ["min y", "min z", "max y", "max z"], 64, -10_000, 10_000, n => MakeBox([0, n[0], n[1], 0, n[2], n[3]]),
            b => [b.Min.Y, b.Min.Z, b.Max.Y, b.Max.Z]),
        ["Clips"] = new RowsFormat<Bounds>(Box, 64, -Far, Far, MakeBox, TakeBox),
        ["ExcludedAreas"] = new RowsFormat<Bounds>(
            ["min x", "min y", "max x", "max y"], 64, -Far, Far, n => Bounds.Of([new Vec3(n[0], n[1]), new Vec3(n[2], n[3])]),
            b => [b.Min.X, b.Min.Y, b.Max.X, b.Max.Y]),
        ["AxisMappings"] = new TextsFormat<AxisMapping>("a list of texts such as \"X=A*2.86\"", "a list of AXIS=WORD*SCALE", AxisMapping.Parse,
            mappings => mappings.Select(m => m.From).Distinct().Count() == mappings.Count ? null : "maps a coordinate twice",
            "^[XYZ]=[ABCXYZ]\\*[-0-9.]+(@[-0-9.]+)?$"),
        ["RotaryAxes"] = new TextsFormat<RotaryAxis>("a list of texts such as \"B head y at 0 0 42 from -110 to 110\"",
            "a list of WORD head/work x/y/z [at X Y Z] [from MIN] [to MAX] [speed S] [acceleration A]", RotaryAxis.Parse, Kinematics.Problem,
            "^[ABC] (head|work) -?[xyz]( at( -?[0-9.]+){3})?( (from|to|speed|acceleration) -?[0-9.]+)*$"),
        ["SlideRange"] = new RowsFormat<Bounds>(Box, 1, -Far, Far, MakeBox, TakeBox),
        ["CheckSeverities"] = new TextsFormat<CheckSeverity>("a list of texts such as \"limit.flow=warning\"",
            "a list of code=off, note, warning or error", CheckSeverity.OrWrong, CheckSeverity.Problem, CheckSeverity.Pattern),
        ["Thumbnails"] = new RowsFormat<Vec3>(["width", "height"], 16, 16, 1000, n => new Vec3(n[0], n[1], 0), v => [v.X, v.Y]),
        ["StartGCode"] = Template,
        ["EndGCode"] = Template,
        ["LayerChangeGCode"] = Template,
        ["ToolChangeGCode"] = Template,
        ["PauseGCode"] = Template,
        ["Macros"] = new LinesFormat(MacroEffect.Error),
        ["PausePark"] = new RowsFormat<Vec3>(["x", "y"], 1, -Far, Far, n => new Vec3(n[0], n[1], 0), v => [v.X, v.Y]),
    };

    public static readonly IReadOnlyDictionary<string, KeyFormat> Settings = new Dictionary<string, KeyFormat>(StringComparer.Ordinal)
    {
        ["LayerRanges"] = new RowsFormat<LayerRange>(
            ["from", "to", "layer height"], 1000, 0, Far, n => new LayerRange(n[0], n[1], n[2]), r => [r.From, r.To, r.Thickness], LayerRange.Problem),
        ["LayerFormula"] = new FormulaFormat("z"),
        ["OverhangClasses"] = new RowsFormat<OverhangClass>(
            ["percent", "speed", "fan", "flow"], 20, 0, 10_000, n => new OverhangClass(n[0], n[1], n[2], n[3]),
            c => [c.Percent, c.Speed, c.MinFanSpeedPercent, c.Flow], OverhangClass.Problem),
        ["InfillFormula"] = new FormulaFormat("x", "y", "z", "layer", "spacing", "width"),
        ["InfillCurves"] = new RowsFormat<InfillPoint>(["curve", "x", "y"], 1_000_000, -Far, Far, InfillPoint.Of, p => [p.Curve, p.X, p.Y]),
        ["BrimEars"] = new RowsFormat<BrimEar>(["x", "y", "diameter"], 10_000, -Far, Far, n => new BrimEar(n[0], n[1], n[2]),
            e => [e.X, e.Y, e.Diameter], BrimEar.Problem),
        ["SeamPoint"] = new NumbersFormat<Vec3>(["x", "y"], -Far, Far, n => new Vec3(n[0], n[1]), v => [v.X, v.Y]),
        ["SeamEnforcers"] = new RowsFormat<SeamMark>(
            ["x", "y", "z", "radius"], 10_000, -Far, Far, n => new SeamMark(new Vec3(n[0], n[1], n[2]), n[3]),
            m => [m.Place.X, m.Place.Y, m.Place.Z, m.Radius], SeamMark.Problem),
        ["PurgeTowerPlace"] = new RowsFormat<Vec3>(["x", "y"], 1, -Far, Far, n => new Vec3(n[0], n[1]), v => [v.X, v.Y]),
        ["ToolChanges"] = new RowsFormat<ToolChange>(["from", "tool"], 1000, 0, 10_000, ToolChange.Of, c => [c.From, c.Tool], ToolChange.Problem),
    };

    public static readonly IReadOnlyDictionary<string, KeyFormat> Material = new Dictionary<string, KeyFormat>(StringComparer.Ordinal)
    {
        ["FlowLimits"] = new RowsFormat<FlowLimit>(
            ["temperature", "flow"], 100, 0.001, 1_000_000, n => new FlowLimit(n[0], n[1]), f => [f.Temperature, f.Flow], FlowLimit.Problem),
    };

    private static string? Ascends(ValueList<HeadPoint> outline)
    {
        if (outline.Zip(outline.Skip(1), (a, b) => b.Radius <= a.Radius || b.Height < a.Height).Contains(true)) return "must have ascending radii and heights";
        return outline[0].Height == 0 ? null : "must begin at the tip, height 0";
    }

    private static Bounds? MakeBox(double[] n)
        => n[0] <= n[3] && n[1] <= n[4] && n[2] <= n[5] ? new Bounds(new Vec3(n[0], n[1], n[2]), new Vec3(n[3], n[4], n[5])) : null;

    private static double[] TakeBox(Bounds b) => [b.Min.X, b.Min.Y, b.Min.Z, b.Max.X, b.Max.Y, b.Max.Z];
}
