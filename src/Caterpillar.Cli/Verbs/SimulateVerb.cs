namespace Caterpillar.Cli;

/// <summary>Reports the state of the machine at moments of a file.</summary>
internal sealed class SimulateVerb : Verb
{
    private readonly Argument<string> _file = new("FILE") { Description = CommonOptions.GCodeInput };

    private readonly Described<string[]> _at = new("--at",
        "Moment: % of the time (42%), time (90, 90s, 12m30s, 1h5m), line:N, move:N, layer:N or z:MM. Repeatable. Default: 0%.",
        "MOMENT") { Arity = ArgumentArity.OneOrMore };

    private readonly Described<bool> _json = new("--json", "Print a JSON array with one object per moment.");
    private readonly Option<string?> _flavor = CommonOptions.Flavor();
    private readonly SetupOptions _setup = new(SetupOptions.FromFile);
    private readonly Option<int> _threads = CommonOptions.Threads();

    public SimulateVerb()
        : base("simulate", "Report the state of the machine at a time, move, line, layer or height of a G-code file.")
    {
        Arguments.Add(_file);
        Add([_at, _json, _flavor, .. _setup.All, _threads]);
    }

    public override int Run(ParseResult arguments, Session session)
    {
        var moments = (arguments.GetValue(_at) is { Length: > 0 } given ? given : ["0%"]).Select(Moment.Parse).ToArray();
        var file = arguments.GetValue(_file)!;
        var diameter = _setup.Resolve(arguments, session).Material.FilamentDiameter;
        var options = CommonOptions.Decoding(arguments.GetValue(_flavor), diameter, arguments.GetValue(_threads), session);
        var decoded = session.Decode(file, options);
        var timed = TimedFile.Of(_setup, arguments, decoded, session);
        var timeline = timed.Timeline(Session.NameOf(file), session);
        var states = moments.Select(m => m.Of(timeline)).ToArray();
        session.WriteText("-", text =>
        {
            if (arguments.GetValue(_json)) text.Write(SimulationJson.Array(states.Select(s => SimulationJson.State(s, timeline.Toolpath))));
            else Write(text, states, timeline, timed.Limits);
        });
        return ExitCode.Done;
    }

    private static void Write(TextWriter text, MachineState[] states, Timeline timeline, string limits)
    {
        text.WriteLine($"{StatisticsText.Duration(timeline.Duration)} with the limits of {limits}");
        foreach (var s in states)
        {
            text.WriteLine();
            TextTable.Write(text, Rows(s, timeline).ToArray());
        }
    }

    private static IEnumerable<string[]> Rows(MachineState s, Timeline timeline)
    {
        var toolpath = timeline.Toolpath;
        var over = s.Move >= toolpath.Count;
        yield return ["  Time", $"{StatisticsText.Duration(s.Time)}, {StatisticsText.Duration(s.TimeLeft)} left"];
        var source = s.Source >= 0 ? $", line {NumberFormatter.Format(s.Source)}" : "";
        var move = $"{NumberFormatter.Format(s.Move)} of {NumberFormatter.Format(toolpath.Count)} ({Number(100 * s.Done, 1)} % done)";
        yield return ["  Move", over ? $"all {NumberFormatter.Format(toolpath.Count)} done" : move + source];
        var role = s.Kind == Toolpaths.MoveKind.Print && s.Role != Toolpaths.Role.Unspecified ? ", " + Words.Spaced(s.Role.ToString()) : "";
        if (!over) yield return ["  Action", s.Waits ? "Waiting" : Words.Spaced(s.Kind.ToString()) + role];
        yield return ["  Nozzle", $"{Number(s.Position.X, 3)}, {Number(s.Position.Y, 3)}, {Number(s.Position.Z, 3)} mm, tool {NumberFormatter.Format(s.Tool)}"];
        yield return ["  Speed", $"{Number(s.Speed, 2)} mm/s" + (s.Flow is { } flow ? $", {Number(flow, 3)} mm³/s" : "")];
        if (s.Layer >= 0) yield return ["  Layer", $"{NumberFormatter.Format(toolpath.Layers[s.Layer].Index)}, Z {Number(toolpath.Layers[s.Layer].Z, 3)} mm"];
        var nozzle = $"nozzle {Number(s.NozzleTemperature, 1)} of {Number(s.NozzleTarget, 1)} °C";
        yield return ["  Heat", $"{nozzle}, bed {Number(s.BedTemperature, 1)} of {Number(s.BedTarget, 1)} °C, fan {Number(100 * s.Fan, 0)} %"];
        var volume = s.Volume is { } known ? $", {Number(known / 1000, 3)} cm³" : "";
        yield return ["  So far", $"{Number(s.Length / 1000, 3)} m of path, {Number(s.Filament, 2)} of E{volume}"];
    }

    private static string Number(double value, int decimals) => NumberFormatter.Format(value, decimals);
}
