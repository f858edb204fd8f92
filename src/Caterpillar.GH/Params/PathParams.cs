using Rhino.DocObjects;
using Rhino.Commands;
using Rhino.Input;

namespace Caterpillar.GH.Params;

/// <summary>Print paths. A user picks curves, which are kept in the definition.</summary>
public sealed class PrintPathParam() : VisibleParam<PrintPathGoo>(
    "Print Path", "PPath", "Contains print paths: points in mm, beads in mm². Curves are printed as they are.", Panel.Path)
{
    public override Guid ComponentGuid => new("2d2f50b1-4f83-49b3-bca7-4d4ff4381898");

    protected override GH_GetterResult Prompt_Singular(ref PrintPathGoo value)
    {
        var made = new PrintPathGoo();
        if (RhinoGet.GetOneObject("Curve to print", false, ObjectType.Curve, out var picked) != Result.Success || !made.CastFrom(picked.Curve()))
            return GH_GetterResult.cancel;
        value = made;
        return GH_GetterResult.success;
    }

    protected override GH_GetterResult Prompt_Plural(ref List<PrintPathGoo> values)
    {
        if (RhinoGet.GetMultipleObjects("Curves to print", false, ObjectType.Curve, out var picked) != Result.Success) return GH_GetterResult.cancel;
        var all = new List<PrintPathGoo>();
        foreach (var one in picked)
        {
            var made = new PrintPathGoo();
            if (made.CastFrom(one.Curve())) all.Add(made);
        }
        if (all.Count == 0) return GH_GetterResult.cancel;
        values = all;
        return GH_GetterResult.success;
    }
}

/// <summary>Toolpaths. A user names G-code files, whose content is kept in the definition.</summary>
public sealed class ToolpathParam() : VisibleParam<ToolpathGoo>("Toolpath", "T", "Contains toolpaths: all moves of the printer, in mm and mm/s.", Panel.GCode)
{
    public override Guid ComponentGuid => new("e5b0d5ad-9d81-4e91-8b3e-fab789fdb2c2");

    private protected override string Question => "G-code file";

    private protected override ToolpathGoo? Made(string text)
    {
        if (!File.Exists(text.Trim()) || GCodeDocument.ReadFile(text.Trim()).Value is not { } document) return null;
        return GCodeDecoder.Decode(document).Value is { NotGCode: null } decoding ? new ToolpathGoo(decoding) : null;
    }
}
