using System;
using System.Collections.Generic;
using System.CommandLine;
using System.IO;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Checks;
using Caterpillar.Cli.Commands;
using Caterpillar.Display;
using Caterpillar.Files;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Simulation;

namespace Caterpillar.Cli.Viewing;

/// <summary>Reads what a viewer page shows: G-code, meshes, or a design, which is turned into G-code first.</summary>
internal sealed class ViewSource(SetupOptions setup, ParseResult arguments, bool withLines, Session session)
{
    private const string Reason = "Made to be looked at in a viewer page, not to be printed.";

    /// <summary>What was read last, in one line.</summary>
    public string Summary { get; private set; } = "";

    /// <exception cref="CliException">The file cannot be read.</exception>
    public ViewerContent Read(string file) => Path.GetExtension(Plain(file)).ToUpperInvariant() switch
    {
        ".STL" or ".OBJ" or ".PLY" or ".3MF" => Model(file),
        ".TURTLE" => Design(file, new TurtleVerb()),
        ".CSV" or ".SVG" or ".JSON" => Design(file, new CurvesVerb()),
        _ => GCode(file, session.ReadBytes(file)),
    };

    private static string Plain(string file) => file.EndsWith(".gz", StringComparison.OrdinalIgnoreCase) ? file[..^3] : file;

    private static string Title(string file) => file == "-" ? "Standard input" : Path.GetFileName(file);

    private ViewerContent Model(string file)
    {
        var meshes = session.ValueOrFail(session.WithProgress("Reading", progress => Meshes.Read([file], session, progress)));
        var points = new List<Vec3>();
        var corners = new List<int>();
        foreach (var mesh in meshes.Select(m => m.Mesh))
        {
            var first = points.Count;
            points.AddRange(mesh.Vertices);
            corners.AddRange(mesh.Indices.Select(i => i + first));
        }
        Summary = NumberFormatter.Format(corners.Count / 3) + " triangles";
        return new ViewerContent(Title(file)) { Model = TriMesh.Create(points, corners), Printer = setup.Resolve(arguments, session).Printer };
    }

    // The verb writes what it would write for a printer, whatever the checks find: that is what is looked at.
    private ViewerContent Design(string file, Verb verb)
    {
        using var memory = new MemoryStream();
        var inner = new Session(() => Stream.Null, () => memory, session.Messages)
        {
            IsPart = true, Cancel = session.Cancel, Profiles = session.Profiles, Quiet = session.Quiet, Memory = session.Memory,
        };
        string[] given = [file, "--output", "-", "--override", Reason, .. setup.Given(arguments)];
        var code = verb.Run(verb.Parse(given), inner);
        if (code != ExitCode.Done) throw new CliException(code);
        return GCode(file, memory.ToArray());
    }

    private ViewerContent GCode(string file, byte[] bytes)
    {
        var name = Session.NameOf(file);
        var resolved = setup.Resolve(arguments, session);
        var options = new DecodeOptions { FilamentDiameter = resolved.Material.FilamentDiameter, Memory = session.Memory };
        using var stream = GzipReader.Open(new MemoryStream(bytes, false));
        var decoded = session.ValueOrFail(session.WithProgress("Reading " + name,
            progress => GCodeDecoder.DecodeStream(stream, options, name, progress, session.Cancel)));
        var motion = MotionSetup.Of(setup, arguments, decoded, session);
        var timeline = session.WithProgress("Planning " + name, progress => Timeline.Of(decoded.Toolpath, motion.Setup, progress, session.Cancel));
        var findings = setup.IsGiven(arguments)
            ? session.WithProgress("Checking " + name, progress => PrintCheck.Run(decoded, resolved, progress, session.Cancel))
            : [];
        Summary = PrintSummary.Of(PrintFigures.Of(decoded, decoded.Toolpath) with { Seconds = timeline.Duration });
        return new ViewerContent(Title(file))
        {
            Toolpath = decoded.Toolpath,
            GCode = withLines && !bytes.AsSpan().StartsWith("GCDE"u8) ? Unpacked(bytes) : null,
            EndOf = timeline.EndOf,
            Limits = motion.Limits,
            Printer = motion.Setup.Printer,
            Shape = resolved.Settings.BeadShape,
            Density = resolved.Material.Density,
            Findings = [.. findings],
        };
    }

    private static byte[] Unpacked(byte[] bytes)
    {
        if (!GzipReader.IsPacked(bytes, bytes.Length)) return bytes;
        using var text = GzipReader.Open(new MemoryStream(bytes, false));
        using var memory = new MemoryStream();
        text.CopyTo(memory);
        return memory.ToArray();
    }
}
