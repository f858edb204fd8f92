using System;
using Caterpillar.GH.Base;
using Caterpillar.GH.Goos;

namespace Caterpillar.GH.Params;

/// <summary>G-code files; text is G-code.</summary>
public sealed class GCodeParam() : VolatileParam<GCodeGoo>("G-code", "GCode", "Contains G-code files; text is G-code.", Panel.GCode)
{
    public override Guid ComponentGuid => new("c626418d-8e36-4127-935e-c83c2c852506");
}

/// <summary>Steps of a design: print paths, travels and events.</summary>
public sealed class StepParam() : VolatileParam<StepGoo>("Step", "Step", "Contains steps of a design: print paths, travels and events.", Panel.Path)
{
    public override Guid ComponentGuid => new("9338155d-65ee-4cc2-939c-d876fc935887");
}
