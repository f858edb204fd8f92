namespace Caterpillar.Checks;

/// <summary>Temperatures beyond hot end and bed, cold extrusion, heat that is missing or left on.</summary>
internal sealed class HeatCheck : MoveCheck
{
    private readonly Printer _printer;
    private readonly CheckScope _scope;
    private readonly Findings _findings;
    private readonly double _needed;
    private readonly NozzleTemperatures _nozzles;
    private MoveEvent? _bed;
    private MoveEvent? _chamber;
    private bool _heats;
    private int? _firstExtrusion;

    public HeatCheck(PrintSetup setup, CheckScope scope, Findings findings)
    {
        _printer = setup.Printer;
        _scope = scope;
        _findings = findings;
        _needed = _printer.ExtrusionUnit == ExtrusionUnit.None ? 0 : _printer.MinExtrusionTemperature;
        _nozzles = new NozzleTemperatures(scope.NozzleTemperature, _printer);
        foreach (var material in setup.ToolMaterials.Append(setup.Material))
        {
            Nozzle(Math.Max(material.NozzleTemperature, material.FirstLayerNozzleTemperature), null);
            Bed(Math.Max(material.BedTemperature, material.FirstLayerBedTemperature), null);
            Chamber(material.ChamberTemperature, null);
        }
    }

    public override IReadOnlyList<string> Codes =>
    [
        CheckCodes.NozzleTemperature, CheckCodes.BedTemperature, CheckCodes.ChamberTemperature, CheckCodes.ColdExtrusion, CheckCodes.NoHeating,
        CheckCodes.HeatLeftOn,
    ];

    public override void Event(MoveEvent what)
    {
        switch (what.Event)
        {
            case NozzleTemperatureEvent nozzle:
                _heats = true;
                Nozzle(nozzle.Celsius, what);
                break;
            case BedTemperatureEvent bed:
                _bed = what;
                Bed(bed.Celsius, what);
                break;
            case ChamberTemperatureEvent chamber:
                _chamber = what;
                Chamber(chamber.Celsius, what);
                break;
        }
        _nozzles.Take(what);
    }

    public override void Move(in CheckedMove move)
    {
        if (!(move.E > 0)) return;
        _firstExtrusion ??= move.Index;
        var (celsius, set) = _nozzles.At(move.Tool);
        if (celsius < _needed) ReportCold(move.Index, celsius, set);
    }

    public override void End(Toolpath toolpath)
    {
        if (!_scope.IsWholeFile) return;
        if (_needed > 0 && _firstExtrusion is { } first && !_heats && !_scope.Heats)
            _findings.Add(CheckCodes.NoHeating, first, () => "This move extrudes, but the file never heats the nozzle. Add M109 to the start G-code.");
        if (_scope.Cools) return;
        if (_nozzles.LeftOn is { } nozzle)
            _findings.Add(CheckCodes.HeatLeftOn, () => PlaceOf(nozzle), () => Left("nozzle", ((NozzleTemperatureEvent)nozzle.Event).Celsius, "M104 S0"));
        if (_bed is { Event: BedTemperatureEvent { Celsius: > 0 } left } bed)
            _findings.Add(CheckCodes.HeatLeftOn, () => PlaceOf(bed), () => Left("bed", left.Celsius, "M140 S0"));
        if (_chamber is { Event: ChamberTemperatureEvent { Celsius: > 0 } warm } chamber)
            _findings.Add(CheckCodes.HeatLeftOn, () => PlaceOf(chamber), () => Left("chamber", warm.Celsius, "M141 S0"));
    }

    private void ReportCold(int move, double celsius, MoveEvent? set)
        => _findings.Add(CheckCodes.ColdExtrusion, () => ColdPlace(move, set),
            () => $"A move extrudes at {NumberFormatter.Format(celsius, 0)} °C, but {_printer.Title} needs {NumberFormatter.Format(_needed, 0)} °C. "
                + "Heat the nozzle first.");

    private static string Left(string part, double celsius, string off)
        => $"The {part} is still heated to {Number(celsius)} °C at the end. Add {off} to the end G-code.";

    private SourceLocation? PlaceOf(MoveEvent what) => _findings.PlaceOfEvent(what);

    // A command of the design that cooled the nozzle is what must change.
    private SourceLocation? ColdPlace(int move, MoveEvent? set)
    {
        var place = _findings.PlaceOf(move);
        return set is { } what && _findings.PlaceOfEvent(what)?.Origin is { } origin ? (place ?? new SourceLocation()) with { Origin = origin } : place;
    }

    private void Nozzle(double celsius, MoveEvent? set) => Limit(CheckCodes.NozzleTemperature, "nozzle", celsius, _printer.MaxNozzleTemperature, set);

    private void Bed(double celsius, MoveEvent? set) => Limit(CheckCodes.BedTemperature, "bed", celsius, _printer.MaxBedTemperature, set);

    private void Chamber(double celsius, MoveEvent? set) => Limit(CheckCodes.ChamberTemperature, "chamber", celsius, _printer.MaxChamberTemperature, set);

    // Without a command it is the temperature of the material.
    private void Limit(string code, string part, double celsius, double most, MoveEvent? set)
    {
        if (celsius > most) _findings.Add(code, () => set is { } what ? PlaceOf(what) : null, () => Sentence(part, celsius, most));
    }

    private string Sentence(string part, double celsius, double most)
        => most == 0
            ? $"The {part} temperature is {Number(celsius)} °C, but {_printer.Title} has no heated {part}. Set the temperature to 0."
            : $"The {part} temperature is {Number(celsius)} °C, but {_printer.Title} allows only {Number(most)} °C. Lower the temperature.";

    private static string Number(double celsius) => NumberFormatter.Format(celsius, 1);
}

/// <summary>
/// Temperatures of the nozzles, °C. A command that names no tool is for the current tool; where the file names none at all, its tools share a nozzle or are
/// heated to the same temperature, unless the printer is known to have several nozzles.
/// </summary>
internal sealed class NozzleTemperatures(double initial, Printer printer)
{
    private readonly SortedDictionary<int, (double Celsius, MoveEvent? Set)> _ofTool = [];
    private (double Celsius, MoveEvent? Set) _shared = (initial, null);
    private bool _isNamed = printer.ToolCount > 1 && !printer.SharedNozzle;
    private int _tool;

    /// <summary>The last command of a nozzle that is still heated, or null.</summary>
    public MoveEvent? LeftOn => _ofTool.Values.DefaultIfEmpty(_shared).FirstOrDefault(t => t.Celsius > 0).Set;

    public void Take(MoveEvent what)
    {
        switch (what.Event)
        {
            case ToolEvent change:
                _tool = change.Tool;
                break;
            case NozzleTemperatureEvent { Tool: { } named } heat when !printer.SharedNozzle:
                _isNamed = true;
                _ofTool[named] = (heat.Celsius, what);
                break;
            case NozzleTemperatureEvent heat:
                if (_isNamed) _ofTool[_tool] = (heat.Celsius, what);
                else _shared = (heat.Celsius, what);
                break;
        }
    }

    /// <summary>The temperature of a tool, and the command that set it.</summary>
    public (double Celsius, MoveEvent? Set) At(int tool) => _ofTool.TryGetValue(tool, out var own) ? own : _shared;
}
