using Caterpillar.GH.Base;
using Caterpillar.Toolpaths;

namespace Caterpillar.GH.Components.Path;

/// <summary>Deforms paths by formulas.</summary>
public sealed class DeformComponent() : PathShapingComponent(
    "Deform", "Deform", "Deforms print paths by formulas for position, area and speed, in Cartesian or cylindrical coordinates. Angles are in degrees.")
{
    public override Guid ComponentGuid => new("4b6e1f93-d05a-4c7e-8321-a9c7e4f0b541");

    private protected override void Inputs(InputPorts ports)
    {
        ports.PrintPaths();
        DeformationPorts.Declare(ports);
    }

    private protected override void Solve(Run run)
    {
        var before = run.Paths(0);
        var request = DeformationPorts.Read(run);
        var frame = request.Frame;
        var deformation = run.Require(request.Compile());
        var shaped = run.Work("Deforming", [.. request.Key, before], (progress, cancel) =>
        {
            var problems = new DiagnosticList();
            var local = ToLocal(before.Paths, frame);
            if (request.HasSpeed && local.Any(p => Enumerable.Range(0, p.SegmentCount).Any(i => p.BeadOf(i).Speed == 0)))
                problems.Add(Severity.Warning, "shape.no_speed", "Some paths have no speed of their own, so v is 0 for them.");
            // One by one: a path that can't be deformed does not stop the others.
            var paths = new PrintPath?[local.Length];
            for (var i = 0; i < local.Length; i++)
            {
                var bent = deformation.Apply([local[i]], request.Tolerance, null, cancel);
                foreach (var problem in bent.Diagnostics) problems.Add(problem with { Source = new SourceLocation(Step: i) });
                if (bent.Value is { Count: > 0 } value) paths[i] = ToWorld(value[0], frame);
                progress.Report((i + 1.0) / local.Length);
            }
            return new Shaped(paths, problems.ToList());
        });
        SetPaths(run, before, shaped);
    }
}
