namespace Caterpillar.GH.Components.Design;

/// <summary>Reads curves to print from a file.</summary>
public sealed class ReadCurvesComponent() : CaterpillarComponent(
    "Read Curves", "Curves", "Reads curves to print from a file of points, lines or SVG paths. They are printed exactly as drawn, in "
        + "file order.", Panel.Design, GH_Exposure.tertiary)
{
    public override Guid ComponentGuid => new("6f20d4c9-b318-4e7a-8c45-d3a7f9e01b68");

    private protected override void Inputs(InputPorts ports)
    {
        ports.File("File", "F", "File to read: points (CSV, JSON), lines (OBJ) or paths (SVG). May be packed "
            + "with gzip.", "Curves (*.csv;*.json;*.obj;*.svg;*.gz)|*.csv;*.json;*.obj;*.svg;*.gz|All files|*.*");
        ports.Setup("Used for curves without width, height or speed. Default: generic.");
        ports.Number("Unit", "U", "Length of one unit in mm, if the file does not state its unit.", 1);
        ports.Subdivision("Su");
    }

    private protected override void Outputs(OutputPorts ports)
    {
        ports.Add(new PrintPathParam(), "Print Paths", "P", "Print paths, in file order.", GH_ParamAccess.list);
        ports.Add(new StepParam(), "Steps", "St", "Print paths and the dots between them, for Plan Toolpath.", GH_ParamAccess.list);
        ports.Diagnostics();
    }

    private protected override void Solve(Run run)
    {
        var file = run.FileAt(run.Get<string>(0));
        var setup = SetupPort.Of(run, 1);
        var (unit, step) = (run.Positive(2), run.Positive(3));
        var read = run.Work("Reading", [file.FullName, file.LastWriteTimeUtc, file.Length, unit, setup], (progress, cancel) =>
            CurveReader.Read(file.FullName, CurveReadOptions.For(setup) with { UnitLength = unit }, progress, cancel));
        var curves = run.Require(read);
        var options = CurveOptions.For(setup) with { Subdivision = SubdivisionOptions.ByDistance(step) };
        var steps = run.Require(run.Work("Dividing", [read, step, setup],
            (progress, cancel) => CurvePaths.ToSteps(curves, options, progress, cancel)));
        run.SetList(0, steps.OfType<PathStep>().Select(s => new PrintPathGoo(s, setup)));
        run.SetList(1, steps.Select(s => new StepGoo(s, setup)));
    }
}
