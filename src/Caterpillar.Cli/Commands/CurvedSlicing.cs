using System;
using System.Collections.Generic;
using System.CommandLine;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Curved;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Slicing;
using Caterpillar.Toolpaths;

namespace Caterpillar.Cli.Commands;

/// <summary>Slices along surfaces, or onto an object.</summary>
internal sealed class CurvedSlicing(CurvedOptionValues options, ParseResult arguments, PrintSetup setup, int threads, Session session)
{
    private LayerField? _field;

    /// <summary>
    /// The setup to plan and write with: it knows of the object, and over curved layers the head is lifted by what lies under its course, unless travels are
    /// not lifted at all.
    /// </summary>
    public PrintSetup Setup { get; private set; } = OntoOptions.Over(setup);

    /// <summary>The planned toolpath with the tool tilted along the normals of the layers, where that was asked for.</summary>
    public Toolpath Tilted(Toolpath toolpath) => options.Tilt(arguments) is not { } tilt || _field is not { } field ? toolpath
        : session.WithProgress("Tilting", progress => tilt.Apply(toolpath, field.Normal, progress, session.Cancel));

    /// <summary>The steps, and the number of layers.</summary>
    /// <param name="read">The models as they were read.</param>
    /// <param name="models">The same where they are printed.</param>
    public (IReadOnlyList<Step> Steps, int Layers) Run(IReadOnlyList<NamedMesh> read, IReadOnlyList<SliceModel> models)
    {
        var shift = Shift(read, models);
        var onto = options.Onto(arguments, shift, session);
        Setup = Setup with { PrintedOn = onto };
        if (!options.HasField(arguments)) return Onto(onto!, models);
        // Together with an object the model is already where it belongs.
        if (onto is not null)
        {
            models = models.Select(m => new SliceModel(new NamedMesh(m.Mesh.Name, m.Mesh.Mesh.Moved(new Vec3(0, 0, -shift.Z))), m.Settings)).ToArray();
            shift = shift.WithZ(0);
        }
        var meshes = models.Select(m => m.Mesh).ToArray();
        var field = options.Field(arguments, meshes, shift, setup, session, out var surface);
        var lines = options.InfillLines(arguments, surface, meshes, shift, setup, session);
        var curved = new CurvedOptions
        {
            Threads = threads, InfillLines = lines is null ? null : _ => lines,
            Onto = onto is null ? null : PlanSurface.OnBed(onto), Partial = options.IsPartial(arguments), MaxTilt = options.Tilt(arguments)?.MaxTilt ?? 0,
        };
        var result = session.ValueOrFail(session.WithProgress("Slicing",
            progress => CurvedSlicer.SliceEach(models, field, setup, curved, progress, session.Cancel)));
        _field = result.Field;
        return (result.ToSteps(), result.Layers.Count);
    }

    private (IReadOnlyList<Step> Steps, int Layers) Onto(TriMesh onto, IReadOnlyList<SliceModel> models)
    {
        // Loops around the part and rafts are for beds.
        var plain = models.Select(m => new SliceModel(m.Mesh, Plain(m.Settings))).ToArray();
        var flat = session.ValueOrFail(session.WithProgress("Slicing",
            progress => PlanarSlicer.SliceEach(plain, Plain(setup.Settings), new SliceOptions { Threads = threads }, progress, session.Cancel)));
        var steps = session.ValueOrFail(session.WithProgress("Projecting", progress => SurfaceProjection.Project(
            flat.ToSteps(), PlanSurface.Of(onto), setup, options.Squeeze(arguments), options.IsPartial(arguments), progress, session.Cancel)));
        return (steps, flat.Layers.Count);
    }

    private static PrintSettings Plain(PrintSettings settings) => settings with { SkirtLoops = 0, BrimWidth = 0, RaftLayers = 0 };

    // Surfaces move with the model, but are not scaled, turned or copied.
    private static Vec3 Shift(IReadOnlyList<NamedMesh> read, IReadOnlyList<SliceModel> models)
    {
        const double Rounding = 1e-6;
        var shift = models[0].Mesh.Mesh.Bounds.Min - read[0].Mesh.Bounds.Min;
        var moved = models.Count == read.Count;
        for (var i = 0; moved && i < read.Count; i++)
        {
            var (from, to) = (read[i].Mesh.Bounds, models[i].Mesh.Mesh.Bounds);
            moved = to.Min.DistanceTo(from.Min + shift) < Rounding && to.Max.DistanceTo(from.Max + shift) < Rounding;
        }
        return moved ? shift : throw new CliException(ExitCode.Usage,
            "Models that are sliced along a surface cannot be scaled, turned, copied or arranged: the surface would not go with them.");
    }
}
