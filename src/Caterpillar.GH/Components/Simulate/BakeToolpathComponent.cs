namespace Caterpillar.GH.Components.Simulate;

/// <summary>What a toolpath is baked as.</summary>
public enum BakeKind
{
    Curves,
    Beads,
}

/// <summary>Bakes toolpaths when a button is pressed.</summary>
public sealed class BakeToolpathComponent() : CaterpillarComponent(
    "Bake Toolpath", "Bake", "Bakes the extrusions of toolpaths when Bake becomes true, on layers by object and role. Baking again replaces what this "
        + "component has baked.", Panel.Simulate, GH_Exposure.secondary)
{
    private readonly Buttons _bake = new(input: 2);
    private readonly List<Request> _requests = [];
    private readonly HashSet<string> _items = new(StringComparer.Ordinal);

    // The objects of each item. Null before the first solve.
    private Dictionary<string, List<Guid>>? _baked;
    private (GH_RuntimeMessageLevel Level, string? Text) _note;
    private bool _pressed;

    public override Guid ComponentGuid => new("9c1f6a2e-8b43-4f19-8d2c-1c3a7e9b4a06");

    private protected override void Inputs(InputPorts ports)
    {
        ports.Add(new ToolpathParam(), "Toolpaths", "T", "Toolpaths, from Plan Toolpath or Decode G-code.", GH_ParamAccess.list);
        ports.Text("Name", "N", "Name of the baked objects and of their group.", "Toolpath");
        ports.Boolean("Bake", "B", "Bakes the toolpaths when this changes from false to true. Connect a button.", false);
        ports.Choice("Kind", "K", "Curves along the extrusions, or beads of true width and height as meshes.", BakeKind.Curves);
        ports.Text("Layer", "L", "Full path of a layer, such as Prints::Vase. Default: layers by object and role.", optional: true);
        ports.Add(new Param_Colour(), "Color", "C", "Color of the objects. Default: by role.", optional: true);
    }

    private protected override void Outputs(OutputPorts ports)
        => ports.Add(new Param_Guid(), "Ids", "I", "IDs of the baked objects that exist.", GH_ParamAccess.list);

    private protected override void Prepare(Run run)
    {
        if (run.Iteration == 0)
        {
            _items.Clear();
            _requests.Clear();
        }
        _pressed = _bake.IsPressed(run);
    }

    private protected override void Solve(Run run)
    {
        // Nulls are reported. They keep their places, so that items keep their objects.
        run.Some<ToolpathGoo>(0);
        var toolpaths = run.WithNulls<ToolpathGoo>(0);
        var name = run.Get<string>(1).Trim();
        if (name.Length == 0) throw new InputProblem("Name is missing.") { IsMissing = true };
        var kind = run.Choice<BakeKind>(3);
        var (layer, color) = (run.Maybe<string>(4), run.MaybeValue<Color>(5));
        var items = Enumerable.Range(0, toolpaths.Count).Select(i => $"{run.Iteration};{NumberFormatter.Format(i)}").ToArray();
        _items.UnionWith(items);
        if (_pressed)
        {
            if (RhinoDoc.ActiveDoc is null) throw new InputProblem("No Rhino document is open. Open one to bake.");
            // Documents must not change while a solution runs.
            if (_requests.Count == 0) run.Document?.ScheduleSolution(1, Bake);
            var given = items.Zip(toolpaths, (item, goo) => (item, goo?.Value!)).Where(t => t.Item2 is not null).ToArray();
            _requests.Add(new Request(given, name, kind, string.IsNullOrWhiteSpace(layer) ? null : layer, color));
        }
        if (_note.Text is { } note && !_pressed) run.Report(_note.Level, note);
        if (RhinoDoc.ActiveDoc is not { } rhino || run.Document is not { } definition) return;
        _baked ??= OwnerIn(definition).FindIn(rhino);
        var ids = items.SelectMany(item => _baked.TryGetValue(item, out var some) ? some : [])
            .Where(id => rhino.Objects.FindId(id) is { IsDeleted: false }).ToArray();
        run.SetList(0, ids);
        run.Summarize($"{NumberFormatter.Format(ids.Length)} objects");
    }

    private BakeOwner OwnerIn(GH_Document definition) => new(definition.DocumentID, InstanceGuid);

    private void Bake(GH_Document definition)
    {
        if (RhinoDoc.ActiveDoc is not { } document || _requests.Count == 0) return;
        var owner = OwnerIn(definition);
        var before = owner.FindIn(document);
        var made = new Dictionary<string, List<Guid>>(StringComparer.Ordinal);
        var record = document.BeginUndoRecord("Bake " + _requests[0].Name);
        _note = default;
        try
        {
            foreach (var request in _requests) Add(request, owner, document, made);
            // What is baked again, and what has no item any more.
            foreach (var old in before.Where(b => made.ContainsKey(b.Key) || !_items.Contains(b.Key))) Baker.Delete(document, old.Value);
            _baked = null;
        }
        catch (OperationCanceledException)
        {
            foreach (var ids in made.Values) Baker.Delete(document, ids);
            _note = (GH_RuntimeMessageLevel.Warning, "Canceled: nothing was baked.");
        }
        finally
        {
            document.EndUndoRecord(record);
            _requests.Clear();
        }
        ExpireSolution(false);
    }

    private void Add(Request request, BakeOwner owner, RhinoDoc document, Dictionary<string, List<Guid>> made)
    {
        var units = DocumentUnits.Of(document);
        var items = LongWork.Run("Baking", (progress, cancel) => request.Items
            .Select(i => (i.Item, BakedPart.Of(i.Toolpath, request.Kind == BakeKind.Beads, units, progress, cancel))).ToArray());
        var baker = new Baker(document, null) { Name = request.Name, Layer = request.Layer, Color = request.Color, Owner = owner };
        var ids = baker.Add(items) ?? throw new OperationCanceledException();
        for (var i = 0; i < items.Length; i++) made.Add(items[i].Item, ids[i]);
        if (baker.Note is not null) _note = (GH_RuntimeMessageLevel.Remark, baker.Note);
    }

    private sealed record Request((string Item, Toolpath Toolpath)[] Items, string Name, BakeKind Kind, string? Layer, Color? Color);
}
