namespace Caterpillar.Slicing;

/// <summary>Bodies inside which other settings apply: cuts them at the heights of a part's layers.</summary>
internal sealed class Modifiers(IReadOnlyList<SliceModel> models)
{
    private readonly bool[] _used = new bool[models.Count];

    /// <summary>Gives the layers of a body what the modifiers cover in them.</summary>
    /// <param name="body">A body with its layers.</param>
    /// <param name="common">The settings of the print.</param>
    /// <param name="threads">Number of threads. 0 = all cores.</param>
    /// <param name="cancel">Cancels the call.</param>
    public void Apply(Body body, PrintSettings common, int threads, CancellationToken cancel)
    {
        var heights = Array.ConvertAll(body.Layers, l => l.Plan.Cut);
        for (var m = 0; m < models.Count; m++)
        {
            var mesh = models[m].Mesh.Mesh;
            if (body.Layers.Length == 0 || !mesh.Bounds.Overlaps(body.Model.Mesh.Bounds)) continue;
            var sections = MeshSections.At(mesh, heights, new SectionOptions { Threads = threads }, null, cancel).Value!;
            var rules = new Dictionary<SliceRules, SliceRules>();
            for (var i = 0; i < heights.Length; i++)
            {
                var area = Region.From(sections[i].Loops);
                if (area.IsEmpty) continue;
                _used[m] = true;
                var layer = body.Layers[i];
                if (!rules.TryGetValue(layer.Rules, out var own))
                {
                    // What layers have in common stays that of the part.
                    var settings = models[m].Settings with { CombineInfillLayers = layer.Rules.Settings.CombineInfillLayers,
                        OpenContours = layer.Rules.Settings.OpenContours };
                    rules.Add(layer.Rules, own = SliceRules.Of(settings, layer.Plan.Thickness, common, layer.Rules.First));
                }
                layer.Modifiers.Add((own with { Top = layer.Rules.Top }, area));
            }
        }
    }

    /// <summary>Warns of modifiers outside all parts.</summary>
    public void Report(DiagnosticList problems)
    {
        for (var m = 0; m < models.Count; m++)
        {
            if (!_used[m])
                problems.Add(Severity.Warning, "slice.modifier_outside", $"The modifier {models[m].Mesh.Name} is outside all parts and has no effect.");
        }
    }
}
