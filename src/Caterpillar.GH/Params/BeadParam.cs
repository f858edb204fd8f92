namespace Caterpillar.GH.Params;

/// <summary>Beads of extrusions.</summary>
public sealed class BeadParam() : StoredParam<BeadGoo>(
    "Bead", "Bead",
        "Contains beads of extrusions: area in mm², height in mm, speed in mm/s. A number is read as a width in mm, text as width x height.", Panel.Setup)
{
    private protected override string Question => "Bead width in mm, or width x height";

    public override Guid ComponentGuid => new("1c1f088b-dab9-4b6e-8a88-353fb16530ba");
}
