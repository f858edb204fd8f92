using System;
using Caterpillar.GH.Base;
using Caterpillar.GH.Conversion;
using Caterpillar.GH.Params;
using Caterpillar.Toolpaths;
using Grasshopper.Kernel;
using Grasshopper.Kernel.Data;
using Grasshopper.Kernel.Types;

namespace Caterpillar.GH.Components.GCode;

/// <summary>Takes a toolpath apart, move by move.</summary>
public sealed class DeconstructToolpathComponent() : CaterpillarComponent(
    "Deconstruct Toolpath", "DeTP", "Takes a toolpath apart: for each move its end, material, speed, kind, role and source, one branch per layer.", Panel.GCode)
{
    public override Guid ComponentGuid => new("6d012a42-e489-4a36-80c4-6b3d1c1cde28");

    private protected override void Inputs(InputPorts ports) => ports.Add(new ToolpathParam(), "Toolpath", "T", "Toolpath to take apart.");

    private protected override void Outputs(OutputPorts ports)
    {
        ports.Point("Points", "P", "End of each move, in document units. A move without a layer is listed with the layer before it.", GH_ParamAccess.tree);
        ports.Number("Amounts", "E", "Change of E of each move, in mm of filament (or mm³ if the machine counts volume).", GH_ParamAccess.tree);
        ports.Number("Speeds", "V", "Speed of each move, in mm/s.", GH_ParamAccess.tree);
        ports.Text("Kinds", "K", "What the move does: Print, Travel, Wipe, Retract, Restore, Moving Restore, Prime or Dwell.", GH_ParamAccess.tree);
        ports.Text("Roles", "R", "What each strand is for, such as OuterWall or Infill.", GH_ParamAccess.tree);
        ports.Integer("Sources", "S", "Line number in the file, from 1, or number of the step of the design, from 0; -1 if there is none.",
            GH_ParamAccess.tree);
        ports.Number("Areas", "A", "Cross-section of each strand in mm²; 0 for moves that print nothing, or if the filament diameter is unknown.",
            GH_ParamAccess.tree);
        ports.Number("Widths", "W", "Width of each strand in mm, with round sides and the height of its layer; 0 if there is none.", GH_ParamAccess.tree);
    }

    private protected override void Solve(Run run)
    {
        var toolpath = run.Get<Toolpath>(0);
        var units = run.Units;
        var points = new GH_Structure<GH_Point>();
        GH_Structure<GH_Number> amounts = new(), speeds = new(), areas = new(), widths = new();
        GH_Structure<GH_String> kinds = new(), roles = new();
        var sources = new GH_Structure<GH_Integer>();
        var root = run.PathOf(0);
        // Numbers of rafts may begin below 0, branches do not.
        var numbers = toolpath.NumbersOfLayers();
        var lowest = numbers.Count > 0 ? Math.Min(numbers[0], 0) : 0;
        var layer = 0;
        var path = root.AppendElement(layer);
        foreach (var move in toolpath.Moves())
        {
            if (toolpath.NumberOfLayer(move) is { } number && number - lowest != layer) path = root.AppendElement(layer = number - lowest);
            points.Append(new GH_Point(RhinoGeometry.ToPoint(move.End, units)), path);
            amounts.Append(new GH_Number(move.E), path);
            speeds.Append(new GH_Number(move.Speed), path);
            kinds.Append(new GH_String(move.Kind.ToString()), path);
            roles.Append(new GH_String(move.Role.ToString()), path);
            sources.Append(new GH_Integer(move.Source), path);
            var bead = toolpath.BeadOf(move);
            areas.Append(new GH_Number(bead?.Area ?? 0), path);
            widths.Append(new GH_Number(bead?.Width(BeadShape.Stadium) ?? 0), path);
        }
        run.SetTree(0, points);
        run.SetTree(1, amounts);
        run.SetTree(2, speeds);
        run.SetTree(3, kinds);
        run.SetTree(4, roles);
        run.SetTree(5, sources);
        run.SetTree(6, areas);
        run.SetTree(7, widths);
    }
}
