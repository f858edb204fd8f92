using System;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.GH.Base;
using Caterpillar.Shaping;
using Caterpillar.Toolpaths;

namespace Caterpillar.GH.Components.Path;

/// <summary>Bends paths by formulas.</summary>
public sealed class DeformComponent() : PathShapingComponent(
    "Deform", "Deform", "Bends print paths by formulas of position, area and speed, in Cartesian or cylindrical coordinates. Angles are degrees.")
{
    public override Guid ComponentGuid => new("4b6e1f93-d05a-4c7e-8321-a9c7e4f0b541");

    private protected override void Inputs(InputPorts ports)
    {
        PathsPort(ports);
        ports.Choice("System", "S", "Coordinates of the formulas: x, y, z in mm (Cartesian), or r in mm, theta in degrees and z in mm (Cylindrical).", DeformationSystem.Cartesian);
        ports.Text("X", "X", "Formula of the new x, or of the new r in cylindrical coordinates, for example r + 1.05 * z; without it the coordinate stays.", optional: true);
        ports.Text("Y", "Y", "Formula of the new y, or of the new theta in degrees, for example theta + 3 * z; without it the coordinate stays.", optional: true);
        ports.Text("Z", "Z", "Formula of the new z, for example 0.3 * z; without it the coordinate stays.", optional: true);
        ports.Text("Area", "A", "Formula of the new cross-section in mm² over c, the old one, and the coordinates before the mapping, for example 0.96 * c.", optional: true);
        ports.Text("Speed", "V", "Formula of the new speed in mm/s over v, the old one, and the coordinates before the mapping, for example 0.5 * v.", optional: true);
        ports.Number("Tolerance", "T", "Distance in mm that bent curves keep from straight segments, which are divided for it; 0 divides none.", 0.01);
        PlanePort(ports);
    }

    private protected override void Solve(Run run)
    {
        var before = PathsOf(run);
        var system = run.Choice<DeformationSystem>(1);
        var text = Enumerable.Range(2, 5).Select(i => run.Maybe<string>(i) ?? "").ToArray();
        var tolerance = run.Finite(7);
        if (tolerance < 0) throw new InputProblem("Tolerance must be 0 or more.");
        var frame = FrameOf(run, 8);
        var deformation = DeformationText.Compile(text[0], text[1], text[2], text[3], text[4], system);
        if (deformation.Value is null)
        {
            run.SetList(1, run.Report(deformation.Diagnostics));
            return;
        }
        var shaped = run.Cached([system, frame, tolerance, .. text, .. before.Select(p => p.Value)], () => run.Work("Deform", (progress, cancel) =>
        {
            var problems = new DiagnosticList();
            var local = ToLocal(before.Select(p => p.Value), frame);
            if (text[4].Trim().Length > 0 && local.Any(p => Enumerable.Range(0, p.SegmentCount).Any(i => p.BeadOf(i).Speed == 0)))
                problems.Add(Severity.Warning, "shape.no_speed", "Paths have no speed of their own: v is 0 there.");
            // One by one: a path that can't be bent does not stop the others.
            var paths = new PrintPath?[local.Length];
            for (var i = 0; i < local.Length; i++)
            {
                var bent = deformation.Value.Apply([local[i]], tolerance, null, cancel);
                foreach (var problem in bent.Diagnostics) problems.Add(problem with { Source = new SourceLocation(Step: i) });
                if (bent.Value is { Count: > 0 } value) paths[i] = ToWorld(value[0], frame);
                progress.Report((i + 1.0) / local.Length);
            }
            return new Shaped(paths, problems.ToList());
        }));
        SetPaths(run, before, shaped);
    }
}
