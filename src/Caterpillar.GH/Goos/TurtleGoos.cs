using Newtonsoft.Json;

namespace Caterpillar.GH.Goos;

/// <summary>A turtle program on a wire. Text is its script.</summary>
public sealed class TurtleProgramGoo : ValueGoo<TurtleProgram>, IReadsText
{
    private string? _text;

    public override string TypeName => "Turtle Program";

    public override string TypeDescription => "A program for a turtle: a script, commands or an L-system.";

    public string? Problem { get; private set; }

    public override bool CastFrom(object source)
    {
        if (base.CastFrom(source)) return true;
        if (Wrapped.Text(source) is not { } text) return false;
        var compiled = TurtleScript.Compile(text);
        Problem = TextProblem.Of(compiled);
        if (compiled.Value is not { } script) return false;
        Value = TurtleProgram.FromScript(script);
        _text = text;
        return true;
    }

    /// <summary>A definition stores programs that were given as text.</summary>
    public override bool Write(GH_IWriter writer)
    {
        if (_text is null) return true;
        writer.SetInt32("Version", StoredText.Version);
        writer.SetString("Script", StoredText.Pack(_text));
        return true;
    }

    public override bool Read(GH_IReader reader)
    {
        var text = "";
        return !reader.TryGetString("Script", ref text) || CastFrom(StoredText.Unpack(text));
    }

    protected override string Describe(TurtleProgram value) => $"Turtle Program ({value.Description})";
}

/// <summary>A command of a turtle program on a wire.</summary>
public sealed class TurtleCommandGoo : ValueGoo<TurtleCommand>
{
    public override string TypeName => "Turtle Command";

    public override string TypeDescription => "A command of a turtle program, in mm, degrees and °C.";

    public override bool Write(GH_IWriter writer)
    {
        if (Value is not null) writer.SetString("Command", StoredText.Pack(JsonConvert.SerializeObject(Stored.Of(Value))));
        return true;
    }

    public override bool Read(GH_IReader reader)
    {
        var json = "";
        if (reader.TryGetString("Command", ref json)) Value = JsonConvert.DeserializeObject<Stored>(StoredText.Unpack(json))!.ToCommand();
        return true;
    }

    private sealed record Stored(TurtleAction Action, double[] Values, string Text, Stored[] Body)
    {
        public static Stored Of(TurtleCommand c) => new(c.Action, c.Values.ToArray(), c.Text, c.Body.Select(Of).ToArray());

        public TurtleCommand ToCommand() => Action == TurtleAction.Repeat ? TurtleCommand.Repeat((long)Values[0], Body.Select(b => b.ToCommand()))
            : TurtleCommand.Of(Action, Text, Values);
    }

    protected override string Describe(TurtleCommand value)
    {
        var text = value.ToString();
        return text.Length > 200 ? text.Substring(0, 200) + " …" : text;
    }
}
