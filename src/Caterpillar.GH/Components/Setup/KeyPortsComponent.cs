namespace Caterpillar.GH.Components.Setup;

/// <summary>
/// A component that changes values of a profile. Its usual keys are ports. The zoomable + adds a port for any other key: the name of the port is the key, and
/// its type follows.
/// </summary>
public abstract class KeyPortsComponent<T> : ProfileComponent, IGH_VariableParameterComponent
    where T : class
{
    private const string NewName = "key";
    private const int DelayMilliseconds = 5;
    private readonly string _usual;
    private readonly int _fixed;

    /// <param name="name">Name of the component.</param>
    /// <param name="nickname">Its nickname.</param>
    /// <param name="description">What it does.</param>
    /// <param name="usual">Name of the profile that is used if none is connected.</param>
    private protected KeyPortsComponent(string name, string nickname, string description, string usual)
        : base(name, nickname, description, GH_Exposure.secondary)
    {
        _usual = usual;
        _fixed = Params.Input.Count;
        Params.ParameterNickNameChanged += (_, e) =>
        {
            if (e.ParameterSide != GH_ParameterSide.Input || Params.Input.IndexOf(e.Parameter) < _fixed) return;
            // Ports must not change while the event is handled.
            if (OnPingDocument() is { } document) document.ScheduleSolution(DelayMilliseconds, _ => Follow());
            else Follow();
        };
    }

    /// <summary>The usual ports.</summary>
    private protected abstract IReadOnlyList<UsualKey> Usual { get; }

    public bool CanInsertParameter(GH_ParameterSide side, int index) => side == GH_ParameterSide.Input && index >= _fixed;

    public bool CanRemoveParameter(GH_ParameterSide side, int index) => side == GH_ParameterSide.Input && index >= _fixed;

    public IGH_Param CreateParameter(GH_ParameterSide side, int index)
    {
        var port = KeyPort.Make(null);
        for (var i = 1; port.NickName.Length == 0 || i == 1 || Params.Input.Exists(p => p.NickName == port.NickName); i++)
            port.NickName = i == 1 ? NewName : NewName + NumberFormatter.Format(i);
        return port;
    }

    public bool DestroyParameter(GH_ParameterSide side, int index) => true;

    /// <summary>Gives added ports the texts of their keys. It is called after reading, too, where ports must stay: their wires come later.</summary>
    public void VariableParameterMaintenance()
    {
        for (var i = 0; i < Params.Input.Count; i++)
        {
            var port = Params.Input[i];
            if (i >= _fixed) port.Name = port.NickName;
            if (IsKey(i)) KeyPort.Describe(port, KeyOf(i));
        }
    }

    /// <summary>The connected profile, or the usual one.</summary>
    private protected T Profile(Run run) => run.Maybe<T>(0) ?? run.Require(Profiles.Library.Find<T>(_usual));

    /// <summary>Declares the usual ports.</summary>
    private protected void UsualPorts(InputPorts ports)
    {
        foreach (var usual in Usual)
        {
            var key = ProfileKeys.Of<T>().First(k => k.Name == usual.Key);
            ports.Add(KeyPort.Make(key, isUsual: true), usual.Name, usual.Nick, KeyPort.Sentence(key));
        }
    }

    /// <summary>A setup with the values of the ports.</summary>
    /// <exception cref="InputProblem">A port has no key, or two have the same.</exception>
    private protected PrintSetup With(Run run, PrintSetup setup)
    {
        var values = new List<string>();
        var used = new HashSet<string>(StringComparer.Ordinal);
        for (var i = 0; i < Params.Input.Count; i++)
        {
            var port = Params.Input[i];
            if (!IsKey(i)) continue;
            if (KeyOf(i) is not { } key)
            {
                Explain(run, port, i);
                continue;
            }
            if (KeyPort.Value(run, i, port, key) is not { } text) continue;
            if (!used.Add(key.Name)) throw new InputProblem($"Two ports set {key.Name}. Remove one of them.");
            values.Add($"{key.Name}={text}");
        }
        return run.Require(setup.With(values));
    }

    private bool IsKey(int input) => input >= _fixed || Usual.Any(u => u.Name == Params.Input[input].Name);

    // A port that has no value yet may have no key yet.
    private void Explain(Run run, IGH_Param port, int input)
    {
        var problem = ProfileKeys.Unknown<T>(port.NickName);
        if (run.Maybe<string>(input) is not null) throw new InputProblem(problem.Message);
        run.Report(GH_RuntimeMessageLevel.Warning, $"{problem.Message} Rename the port.");
    }

    private ProfileKey? KeyOf(int input)
    {
        var port = Params.Input[input];
        var name = input < _fixed ? Usual.First(u => u.Name == port.Name).Key : port.NickName.Trim();
        return name == "title" ? null : ProfileKeys.Of<T>().FirstOrDefault(k => k.Name == name);
    }

    // Gives ports that were renamed the type of their key. The wires stay.
    private void Follow()
    {
        for (var i = _fixed; i < Params.Input.Count; i++)
        {
            var old = Params.Input[i];
            var port = KeyPort.Make(KeyOf(i));
            if (port.GetType() == old.GetType()) continue;
            port.NickName = old.NickName;
            port.NewInstanceGuid(old.InstanceGuid);
            var sources = old.Sources.ToArray();
            Params.UnregisterInputParameter(old, true);
            Params.RegisterInputParam(port, i);
            foreach (var source in sources) port.AddSource(source);
        }
        Params.OnParametersChanged();
        VariableParameterMaintenance();
        ExpireSolution(false);
    }
}

/// <summary>A port for a key that is always there.</summary>
internal sealed record UsualKey(string Name, string Nick, string Key);
