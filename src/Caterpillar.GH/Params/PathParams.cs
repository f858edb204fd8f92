using Caterpillar.GH.Goos;

namespace Caterpillar.GH.Params;

/// <summary>Print paths.</summary>
public sealed class PrintPathParam() : VisibleParam<PrintPathGoo>(
    "Print Path", "PPath", "Contains print paths: points in mm, beads in mm². Curves are printed as they are.", Panel.Path)
{
    public override Guid ComponentGuid => new("2d2f50b1-4f83-49b3-bca7-4d4ff4381898");
}

/// <summary>Toolpaths.</summary>
public sealed class ToolpathParam() : VisibleParam<ToolpathGoo>("Toolpath", "T", "Contains toolpaths: all moves of the printer, in mm and mm/s.", Panel.GCode)
{
    public override Guid ComponentGuid => new("e5b0d5ad-9d81-4e91-8b3e-fab789fdb2c2");
}
