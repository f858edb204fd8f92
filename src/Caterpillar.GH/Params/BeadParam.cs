using System;
using Caterpillar.GH.Base;
using Caterpillar.GH.Goos;

namespace Caterpillar.GH.Params;

/// <summary>Strands of paths.</summary>
public sealed class BeadParam()
    : VolatileParam<BeadGoo>("Bead", "Bead", "Contains strands of paths: cross-section in mm², height in mm, speed in mm/s.", Panel.Setup)
{
    public override Guid ComponentGuid => new("1c1f088b-dab9-4b6e-8a88-353fb16530ba");
}
