using Caterpillar.GH.Bake;
using Caterpillar.GH.Base;
using Caterpillar.GH.Params;
using Caterpillar.Toolpaths;
using Grasshopper.Kernel;
using Rhino;
using Rhino.DocObjects;

namespace Caterpillar.GH.Components.Simulate;

/// <summary>What a toolpath is baked as.</summary>
public enum BakeKind
{
    Curves,
    Beads,
}

/// <summary>Bakes a toolpath when a button is pressed.</summary>
public sealed class BakeToolpathComponent() : CaterpillarComponent(
    "Bake Toolpath", "Bake", "Bakes the extrusions of a toolpath when Bake becomes true, on layers by object and role. Baking again under the same name "
        + "replaces them.", Panel.Simulate, GH_Exposure.secondary)
{
    private readonly Buttons _bake = new(input: 2);

    // What was baked last, by item.
    private readonly Dictionary<int, List<Guid>> _baked = [];
    private bool _pressed;

    public override Guid ComponentGuid => new("9c1f6a2e-8b43-4f19-8d2c-1c3a7e9b4a06");

    private protected override void Inputs(InputPorts ports)
    {
        ports.Toolpath();
        ports.Text("Name", "N", "Name of the baked objects and of their group. Objects baked under this name are replaced.", "Toolpath");
        ports.Boolean("Bake", "B", "Bakes the toolpath when this changes from false to true. Connect a button.", false);
        ports.Choice("Kind", "K", "Curves along the extrusions, or beads of true width and height as meshes.", BakeKind.Curves);
    }

    private protected override void Outputs(OutputPorts ports)
        => ports.Text("Ids", "I", "IDs of the objects that were baked last.", GH_ParamAccess.list);

    private protected override void Prepare(Run run) => _pressed = _bake.IsPressed(run);

    private protected override void Solve(Run run)
    {
        var toolpath = run.Get<Toolpath>(0);
        var name = run.Get<string>(1).Trim();
        if (name.Length == 0) throw new InputProblem("Name is missing.") { IsMissing = true };
        var kind = run.Choice<BakeKind>(3);
        var item = run.Iteration;
        if (_pressed && run.MayAct())
        {
            if (RhinoDoc.ActiveDoc is null) throw new InputProblem("No Rhino document is open. Open one to bake.");
            // Documents must not change while a solution runs.
            run.Document?.ScheduleSolution(1, _ => Bake(toolpath, name, kind, item));
        }
        if (!_baked.TryGetValue(item, out var ids)) return;
        run.SetList(0, ids.Select(id => id.ToString()));
        run.Summarize($"{NumberFormatter.Format(ids.Count)} objects");
    }

    private void Bake(Toolpath toolpath, string name, BakeKind kind, int item)
    {
        if (RhinoDoc.ActiveDoc is not { } document) return;
        var record = document.BeginUndoRecord("Bake " + name);
        var ids = new List<Guid>();
        try
        {
            foreach (var old in document.Objects.FindByUserString(Baker.NameKey, name, true)) document.Objects.Delete(old.Id, true);
            var group = document.Groups.Find(name);
            if (group < 0) group = document.Groups.Add(name);
            new Baker(document, new ObjectAttributes(), ids) { Name = name, Group = group }.Add(toolpath, kind == BakeKind.Beads);
        }
        finally
        {
            document.EndUndoRecord(record);
        }
        _baked[item] = ids;
        ExpireSolution(false);
    }
}
