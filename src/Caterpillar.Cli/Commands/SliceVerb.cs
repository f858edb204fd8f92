using System;
using System.Collections.Generic;
using System.CommandLine;
using System.IO;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Slicing;

namespace Caterpillar.Cli.Commands;

/// <summary>Meshes to G-code by planar layers.</summary>
internal sealed class SliceVerb : Verb
{
    private readonly Argument<string[]> _models = new("MODEL")
    {
        Description = "Mesh files (STL, OBJ, PLY, 3MF, also packed with gzip), or - for standard input. Several are parts of one print and keep their places to each other.",
        Arity = ArgumentArity.OneOrMore,
    };

    private readonly Option<bool> _keepPosition = new("--keep-position") { Description = "Print where the model stands in its file, instead of the middle of the bed." };

    private readonly SetupOptions _setup = new();
    private readonly WriteOptions _write = new();
    private readonly Option<int> _threads = CommonOptions.Threads();

    public SliceVerb()
        : base("slice", "Slice meshes into G-code.")
    {
        Arguments.Add(_models);
        _write.AddTo(this);
        _setup.AddTo(this);
        Options.Add(_keepPosition);
        Options.Add(_threads);
    }

    public override int Run(ParseResult arguments, Session session)
    {
        var files = arguments.GetValue(_models)!;
        var setup = _setup.Resolve(arguments, session);
        var output = _write.FileFor(arguments, files[0]);
        var sliced = session.Long("Slicing", progress =>
        {
            IReadOnlyList<NamedMesh> models = Meshes.Read(files, session, progress.Part(0, 0.2));
            if (!arguments.GetValue(_keepPosition)) models = ModelPlacement.OnBed(models, setup.Printer.BuildBounds.Center);
            return PlanarSlicer.Slice(models, setup.Settings, arguments.GetValue(_threads), progress.Part(0.2, 1), session.Cancel);
        });
        var steps = session.Need(sliced).ToSteps();
        var toolpath = session.Need(session.Long("Planning", progress => Planner.Plan(steps, setup, null, progress, session.Cancel)));
        return _write.Write(arguments, session, toolpath, setup, output);
    }
}
