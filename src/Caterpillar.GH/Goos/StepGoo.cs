namespace Caterpillar.GH.Goos;

/// <summary>A step of a design on a wire: a print path, a travel move or an event.</summary>
public sealed class StepGoo(Step? step, PrintSetup? setup = null) : ValueGoo<Step>(step)
{
    // The print path on the wire, if it came as one.
    private PrintPathGoo? _path;

    public StepGoo()
        : this(null, null)
    {
    }

    public StepGoo(PrintPathGoo path)
        : this(path.ToStep(), path.Setup)
    {
        _path = path;
    }

    /// <summary>The setup that it was made with. Null if nothing of it depends on one.</summary>
    public PrintSetup? Setup { get; private set; } = setup;

    public override string TypeName => "Step";

    public override string TypeDescription => "A step of a design: a print path, a travel move or an event.";

    /// <inheritdoc cref="PrintPathGoo.StepFor"/>
    public Step StepFor(PrintSetup setup) => _path?.StepFor(setup) ?? Value;

    public override bool Write(GH_IWriter writer)
    {
        if (_path is not null) return _path.Write(writer);
        if (Value is not null) writer.SetByteArray("Step", StepBytes.Pack(Value));
        if (Setup is not null) new SetupGoo { Value = Setup }.Write(writer.CreateChunk("Setup"));
        return true;
    }

    public override bool Read(GH_IReader reader)
    {
        if (!reader.ItemExists("Step")) return true;
        var setup = new SetupGoo();
        Value = StepBytes.Unpack(reader.GetByteArray("Step"))!;
        if (!setup.ReadPart(reader)) return false;
        Setup = setup.Value;
        return Value is not null;
    }

    public override bool CastFrom(object source)
    {
        switch (Wrapped.Bare(source))
        {
            case PrintPathGoo { Value: not null } goo: return From(goo);
            case StepGoo { Value: not null } goo:
                (Value, Setup, _path) = (goo.Value, goo.Setup, goo._path);
                return true;
            case PrintPath path: Value = path; return true;
            case PrinterEvent what: Value = what; return true;
            default:
                var drawn = new PrintPathGoo();
                return base.CastFrom(source) || (drawn.CastFrom(source) && From(drawn));
        }
    }

    public override bool CastTo<Q>(ref Q target)
    {
        if (Value is not PathStep path || typeof(Q) != typeof(PrintPathGoo)) return base.CastTo(ref target);
        target = (Q)(object)(_path ?? new PrintPathGoo(path, Setup));
        return true;
    }

    protected override string Describe(Step value) => value switch
    {
        PathStep path => new PrintPathGoo(path).ToString(),
        TravelStep travel => $"Travel ({Basics.NumberFormatter.Format(travel.Points.Count)} points)",
        EventStep what => what.Event.ToString(),
        _ => "Step",
    };

    private bool From(PrintPathGoo path)
    {
        (Value, Setup, _path) = (path.ToStep(), path.Setup, path);
        return true;
    }
}
