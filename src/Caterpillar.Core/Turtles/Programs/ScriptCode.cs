namespace Caterpillar.Turtles;

internal enum ScriptOp : byte
{
    Command,
    Set,
    SetElement,
    NewArray,
    Parameter,
    Seed,
    Jump,
    JumpIfFalse,
    RepeatStart,
    RepeatNext,
    ForStart,
    ForNext,
    Call,
    Return,
    Grow,
    NextLetter,
    Stop,
    Print,
    BeginShaping,
    EndShaping,
}

/// <summary>One instruction of a compiled script.</summary>
internal sealed class Instruction(ScriptOp op, Token at)
{
    public ScriptOp Op { get; } = op;

    public Token At { get; } = at;

    public int Target { get; set; }

    public int Slot { get; init; }

    /// <summary>True if the slot counts from the frame of the procedure.</summary>
    public bool Local { get; init; }

    public TurtleAction Action { get; init; }

    /// <summary>Numbers. Null keeps a coordinate.</summary>
    public Argument?[] Arguments { get; init; } = [];

    public TextTemplate? Text { get; init; }

    public Procedure? Procedure { get; init; }

    public LSystem? System { get; init; }

    /// <summary>Variables for the rules of the L-system.</summary>
    public IReadOnlyList<(string Name, int Slot, bool Local)> Variables { get; init; } = [];

    public string Name { get; init; } = "";

    /// <summary>The included file. Null = the script itself.</summary>
    public string? File { get; set; }

    public SourceLocation Place => new(File, At.Line, At.Column);

    public ShapingRules? Shaping { get; init; }
}

/// <summary>A compiled number of a command and its position.</summary>
internal sealed class Argument(FormulaNode node, Token at)
{
    public Evaluator Evaluate { get; } = node.Evaluate;

    /// <summary>Its value if it is a finite constant, else NaN.</summary>
    public double Constant { get; } = node.IsConstant && !double.IsInfinity(node.Value) ? node.Value : double.NaN;

    public Token At { get; } = at;
}

/// <summary>A procedure of a script.</summary>
internal sealed class Procedure(string name, IReadOnlyList<string> parameters)
{
    public string Name { get; } = name;

    public IReadOnlyList<string> Parameters { get; } = parameters;

    public int Start { get; set; } = -1;

    public int FrameSize { get; set; }

    /// <summary>True if it returns a value somewhere, so that formulas can call it.</summary>
    public bool ReturnsValue { get; set; }
}

/// <summary>A text with {formulas} that are evaluated.</summary>
/// <param name="Texts">One more text than values.</param>
/// <param name="Values">The formulas.</param>
internal sealed record TextTemplate(IReadOnlyList<string> Texts, IReadOnlyList<Argument> Values);

/// <summary>A compiled script.</summary>
internal sealed class ScriptCode
{
    public Instruction[] Instructions { get; init; } = [];

    public int GlobalCount { get; init; }

    public int ArrayCount { get; init; }

    /// <summary>True if a formula calls a procedure.</summary>
    public bool CallsFunctions { get; init; }

    /// <summary>Parameters that can be set from outside, in order.</summary>
    public IReadOnlyList<string> Parameters { get; init; } = [];

    /// <summary>Printer, material and settings that the script is for. The later ones may be missing.</summary>
    public IReadOnlyList<string> Profiles { get; init; } = [];

    /// <summary>Procedures of one letter, for L-systems.</summary>
    public Dictionary<char, Procedure> Letters { get; init; } = [];

    /// <summary>Slots of the globals that give L-systems their step and angle, or −1.</summary>
    public int StepSlot { get; init; } = -1;

    public int AngleSlot { get; init; } = -1;
}
