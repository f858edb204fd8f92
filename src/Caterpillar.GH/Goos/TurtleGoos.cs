using Caterpillar.Turtles;
using Grasshopper.Kernel.Types;

namespace Caterpillar.GH.Goos;

/// <summary>A turtle program on a wire. Text becomes one if it compiles.</summary>
public sealed class TurtleProgramGoo : ValueGoo<TurtleProgram>
{
    public TurtleProgramGoo()
    {
    }

    public TurtleProgramGoo(TurtleProgram? program)
        : base(program)
    {
    }

    public override string TypeName => "Turtle Program";

    public override string TypeDescription => "A program for a turtle: a script, commands or an L-system.";

    public override IGH_Goo Duplicate() => new TurtleProgramGoo(Value);

    public override bool CastFrom(object source)
    {
        if (base.CastFrom(source)) return true;
        if (Wrapped.Text(source) is not { } text || TurtleScript.Compile(text).Value is not { } script) return false;
        Value = TurtleProgram.FromScript(script);
        return true;
    }

    protected override string Describe(TurtleProgram value) => $"Turtle Program ({value.Description})";
}

/// <summary>A command of a turtle program on a wire.</summary>
public sealed class TurtleCommandGoo : ValueGoo<TurtleCommand>
{
    public TurtleCommandGoo()
    {
    }

    public TurtleCommandGoo(TurtleCommand? command)
        : base(command)
    {
    }

    public override string TypeName => "Turtle Command";

    public override string TypeDescription => "A command of a turtle program, in mm, degrees and °C.";

    public override IGH_Goo Duplicate() => new TurtleCommandGoo(Value);

    protected override string Describe(TurtleCommand value)
    {
        var text = value.ToString();
        return text.Length > 200 ? text.Substring(0, 200) + " …" : text;
    }
}
