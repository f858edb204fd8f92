using System.Collections.Generic;
using Caterpillar.Toolpaths;

namespace Caterpillar.Checks;

/// <summary>
/// Temperatures of the nozzles along a toolpath, °C. A command that names no tool is for the current tool; where the file names none at all, its tools share a
/// nozzle or are heated to the same temperature.
/// </summary>
internal sealed class NozzleTemperatures(Toolpath toolpath, double initial)
{
    private readonly Dictionary<int, double> _ofTool = [];
    private double _shared = initial;
    private bool _isNamed;
    private int _tool;
    private int _next;

    /// <summary>The temperature of a tool at a move; moves are asked for in order.</summary>
    public double At(int move, int tool)
    {
        for (; _next < toolpath.Events.Count && toolpath.Events[_next].Move <= move; _next++)
        {
            switch (toolpath.Events[_next].Event)
            {
                case ToolEvent change:
                    _tool = change.Tool;
                    break;
                case NozzleTemperatureEvent { Tool: { } named } heat:
                    _isNamed = true;
                    _ofTool[named] = heat.Celsius;
                    break;
                case NozzleTemperatureEvent heat:
                    if (_isNamed) _ofTool[_tool] = heat.Celsius;
                    else _shared = heat.Celsius;
                    break;
            }
        }
        return _ofTool.TryGetValue(tool, out var own) ? own : _shared;
    }
}
