namespace Caterpillar.Slicing;

/// <summary>Layers below the part that reach beyond it: open ones, and a closed one on top from which the part is parted by a gap.</summary>
internal static class Raft
{
    /// <summary>By how much the part is lifted, mm.</summary>
    public static double Lift(PrintSettings settings) => settings.RaftLayers == 0 ? 0 : settings.RaftLayers * settings.RaftLayerHeight + settings.RaftGap;

    /// <summary>The layers of the raft.</summary>
    /// <param name="covered">What the first layer of the parts covers.</param>
    /// <param name="settings">The settings of the print.</param>
    public static IReadOnlyList<SlicedLayer> Below(Region covered, PrintSettings settings)
    {
        var layers = new List<SlicedLayer>();
        // Gaps that a margin on both sides fills are closed, too.
        var area = covered.Offset(settings.RaftExpansion, JoinStyle.Round, arcTolerance: 0.05);
        var tools = new LayerTools();
        for (var i = 0; i < settings.RaftLayers; i++)
        {
            var rules = SliceRules.Of(settings, settings.RaftLayerHeight, first: i == 0);
            var pitch = rules.Pitch(rules.Width);
            var solid = i == settings.RaftLayers - 1;
            var layer = new Layer(i, (i + 1) * settings.RaftLayerHeight, settings.RaftLayerHeight);
            var steps = new List<PathStep>();
            var islands = area.Islands;
            for (var k = 0; k < islands.Count; k++)
            {
                var lines = islands[k].Offset(-rules.Width / 2, JoinStyle.Round, arcTolerance: 0.05);
                var request = new InfillRequest(lines, InfillPattern.Lines, solid ? pitch : pitch * 100 / settings.RaftDensityPercent, rules.Width)
                {
                    Angle = i % 2 == 0 ? 0 : 90, Z = layer.Z, Layer = i, Solid = solid,
                };
                foreach (var line in tools.Infill.Fill(request))
                {
                    if (line.Points.Length < 2) continue;
                    var path = PrintPath.Own(line.Points, [rules.Bead(rules.Width)], line.Closed)
                        with { Role = Role.Raft, Layer = layer, Tool = settings.ToolOf(Role.Raft) };
                    steps.Add(new PathStep(path, new StepGroup(i, k)) { Region = islands[k] });
                }
            }
            layers.Add(new SlicedLayer(layer, area, steps));
        }
        return layers;
    }
}
