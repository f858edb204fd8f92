namespace Caterpillar.GH.Base;

/// <summary>
/// A component whose inputs follow its choices: a port that no chosen value needs is not shown, unless something is connected to it. Ports change between
/// solutions, and the definition stores them.
/// </summary>
public abstract class ChosenPortsComponent(string name, string nickname, string description, string panel, GH_Exposure exposure = GH_Exposure.primary)
    : CaterpillarComponent(name, nickname, description, panel, exposure), IGH_VariableParameterComponent
{
    private const string RadiansKey = "Radians";
    private const int DelayMilliseconds = 5;

    // Ports that were taken away come back as they were.
    private readonly Dictionary<string, IGH_Param> _hidden = [];

    public bool CanInsertParameter(GH_ParameterSide side, int index) => false;

    public bool CanRemoveParameter(GH_ParameterSide side, int index) => false;

    public IGH_Param? CreateParameter(GH_ParameterSide side, int index) => null;

    public bool DestroyParameter(GH_ParameterSide side, int index) => false;

    // Reading makes new ports: their choice of radians is stored here.
    public override bool Write(GH_IWriter writer)
    {
        var radians = Params.Input.OfType<Param_Number>().Where(p => p is { AngleParameter: true, UseDegrees: false }).Select(p => p.Name);
        writer.SetString(RadiansKey, string.Join(",", radians));
        return base.Write(writer);
    }

    public override bool Read(GH_IReader reader)
    {
        var read = base.Read(reader);
        var radians = "";
        reader.TryGetString(RadiansKey, ref radians);
        foreach (var port in Params.Input.OfType<Param_Number>().Where(p => p.AngleParameter)) port.UseDegrees = !radians.Split(',').Contains(port.Name);
        return read;
    }

    /// <summary>Gives ports that were read from a file what files do not hold.</summary>
    public void VariableParameterMaintenance()
    {
        foreach (var port in Params.Input)
        {
            if (Declared.FirstOrDefault(d => d.Param.Name == port.Name)?.Param is not { } declared || ReferenceEquals(port, declared)) continue;
            port.Description = declared.Description;
            port.Optional = declared.Optional;
            port.Access = declared.Access;
            if (port is ChoiceParam choice) choice.Take((ChoiceParam)declared);
            if (port is Param_Number number) number.AngleParameter = ((Param_Number)declared).AngleParameter;
        }
    }

    /// <summary>Shows the ports for the present choices. Returns false if they are shown already.</summary>
    internal bool Arrange()
    {
        var wanted = Declared.Where(IsWanted).ToArray();
        if (wanted.Select(d => d.Param.Name).SequenceEqual(Params.Input.Select(p => p.Name))) return false;
        foreach (var port in Params.Input.ToArray())
        {
            if (Array.Exists(wanted, d => d.Param.Name == port.Name)) continue;
            Params.UnregisterInputParameter(port, true);
            _hidden[port.Name] = port;
        }
        for (var i = 0; i < wanted.Length; i++)
        {
            var name = wanted[i].Param.Name;
            if (i < Params.Input.Count && Params.Input[i].Name == name) continue;
            Params.RegisterInputParam(_hidden.TryGetValue(name, out var port) ? port : wanted[i].Param, i);
        }
        Params.OnParametersChanged();
        VariableParameterMaintenance();
        return true;
    }

    private protected sealed override void Begin()
    {
        var wanted = Declared.Where(IsWanted).Select(d => d.Param.Name);
        if (wanted.SequenceEqual(Params.Input.Select(p => p.Name))) return;
        OnPingDocument()?.ScheduleSolution(DelayMilliseconds, _ =>
        {
            if (Arrange()) ExpireSolution(false);
        });
    }

    private bool IsWanted(DeclaredPort declared)
        => declared.Conditions.All(Holds) || Params.Input.Exists(p => p.Name == declared.Param.Name && p.SourceCount > 0);

    private bool Holds(PortCondition condition)
    {
        var port = (ChoiceParam?)Params.Input.Find(p => p.Name == condition.Port);
        return port is null ? condition.Values.Contains((int)Declared.First(d => d.Param.Name == condition.Port).Default!)
            : port.Chosen.Any(condition.Values.Contains);
    }
}
