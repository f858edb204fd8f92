namespace Caterpillar.GH.Params;

/// <summary>Turtle programs.</summary>
public sealed class TurtleProgramParam() : StoredParam<TurtleProgramGoo>(
    "Turtle Program", "Program", "Contains turtle programs. Text is read as a script.", Panel.Design)
{
    private protected override string Question => "Turtle script, for example: repeat 4 [ forward 10; left 90 ]";

    public override Guid ComponentGuid => new("51a3b9f4-7a3f-4c0e-9a55-2f1d7fbd4a01");
}

/// <summary>Commands of turtle programs.</summary>
public sealed class TurtleCommandParam() : VolatileParam<TurtleCommandGoo>("Turtle Command", "Command", "Contains commands of turtle programs.", Panel.Design)
{
    public override Guid ComponentGuid => new("9c4a1d6e-2d0b-4f2c-8f0a-63c0b5d90b02");
}
