using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Threading;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Machines;

namespace Caterpillar.GCode;

/// <summary>
/// Reads G-code into a Toolpath. Any bytes decode to something: what a line means to no firmware is counted and reported, never fatal. The rules of each firmware are data
/// (<see cref="DialectRules"/>); with the dialect <c>slicer</c> and <see cref="ExtrusionRule.Rising"/> they are those of slicers' own viewers.
/// </summary>
public static class Decoder
{
    // Without any E in this many bytes of a stream, the axis is decided from what was seen.
    private const long LongestSearch = 256L * 1024 * 1024;

    /// <summary>Decodes a document.</summary>
    /// <exception cref="OperationCanceledException">Cancelled.</exception>
    public static Result<Decoding> Decode(GCodeDocument document, DecodeOptions? options = null, IProgress<double>? progress = null, CancellationToken cancel = default)
    {
        if (document is null) throw new ArgumentNullException(nameof(document));
        var axis = ExtrusionAxis.Detect(document.Chunks);
        return Run(document, document.Chunks, axis, document.Length, document.Name, options ?? new DecodeOptions(), progress, cancel);
    }

    /// <summary>Decodes bytes: plain, gzip, or binary G-code.</summary>
    /// <inheritdoc cref="Decode(GCodeDocument, DecodeOptions?, IProgress{double}?, CancellationToken)" path="/exception"/>
    public static Result<Decoding> Decode(byte[] bytes, DecodeOptions? options = null, IProgress<double>? progress = null, CancellationToken cancel = default)
    {
        GCodeDocument document;
        try
        {
            document = GCodeDocument.FromBytes(bytes);
        }
        // Mono says IOException of broken packing; there is no other input here.
        catch (Exception broken) when (broken is InvalidDataException or IOException)
        {
            return new Result<Decoding>(null, [new Diagnostic(Severity.Error, "gcode.packed", "The packed file is broken: " + broken.Message)]);
        }
        return Decode(document, options, progress, cancel);
    }

    /// <summary>
    /// Decodes a stream while it is read, without keeping the text: memory is that of the moves. The stream may be packed with gzip and stays open; progress is reported where its length is known.
    /// </summary>
    /// <exception cref="IOException">The stream cannot be read.</exception>
    /// <inheritdoc cref="Decode(GCodeDocument, DecodeOptions?, IProgress{double}?, CancellationToken)" path="/exception"/>
    public static Result<Decoding> DecodeStream(
        Stream stream, DecodeOptions? options = null, string name = "", IProgress<double>? progress = null, CancellationToken cancel = default)
    {
        if (stream is null) throw new ArgumentNullException(nameof(stream));
        var tail = Tail(stream);
        using var chunks = ChunkReader.Read(stream, 1024 * 1024, cancel).GetEnumerator();
        var head = new List<GCodeChunk>();
        var seen = 0L;
        IEnumerable<GCodeChunk> Head()
        {
            while (seen < LongestSearch && chunks.MoveNext())
            {
                head.Add(chunks.Current);
                seen += chunks.Current.Length;
                yield return chunks.Current;
            }
        }
        IEnumerable<GCodeChunk> All()
        {
            for (var i = 0; i < head.Count; i++)
            {
                yield return head[i];
                head[i] = null!;
            }
            while (chunks.MoveNext()) yield return chunks.Current;
        }
        var axis = ExtrusionAxis.Detect(Head());
        var length = stream.CanSeek ? stream.Length : 0;
        var told = new List<GCodeChunk>(head);
        if (tail is not null) told.Add(tail);
        return Run(null, All(), axis, length, name, options ?? new DecodeOptions(), progress, cancel, told);
    }

    // The end of a plain file, where some slicers say what it is for; null where it cannot be read yet.
    private static GCodeChunk? Tail(Stream stream)
    {
        const int Length = 96 * 1024;
        if (!stream.CanSeek) return null;
        var position = stream.Position;
        if (stream.Length - position < 2 * Length) return null;
        var bytes = new byte[Length];
        stream.Seek(-Length, SeekOrigin.End);
        var count = 0;
        for (int read; count < Length && (read = stream.Read(bytes, count, Length - count)) > 0;) count += read;
        stream.Position = position;
        return new GCodeChunk(bytes, 0, count);
    }

    private static Result<Decoding> Run(
        GCodeDocument? document, IEnumerable<GCodeChunk> chunks, ExtrusionAxis axis, long length, string name, DecodeOptions options, IProgress<double>? progress, CancellationToken cancel,
        IReadOnlyList<GCodeChunk>? head = null)
    {
        Detection? detected = options.Dialect is null ? DialectDetector.Detect(head ?? document!.Chunks, axis) : null;
        var rules = options.Dialect ?? detected!.Value.Dialect;
        var core = new DecoderCore(rules, options.Rule, axis);
        var lines = 0;
        var mark = false;
        var checkpoints = document is null ? null : new List<Checkpoint>(document.Chunks.Count);
        long bytes = 0;
        ChunkPipeline.Run(
            chunks,
            axis.Letter,
            document is { Chunks.Count: < 3 } ? 1 : options.Degree,
            (parser, done) =>
            {
                if (lines == 0) mark = TextEncoding.MarkLength(parser.Chunk!) > 0;
                checkpoints?.Add(new Checkpoint(lines, core.Save()));
                core.Run(parser, lines);
                lines += parser.Lines;
                bytes = done;
                if (length > 0) progress?.Report(Math.Min((double)done / length, 1));
            },
            cancel);
        core.ReportIgnored();
        if (detected is { } found && found.IsDefault)
            core.Diagnostics.Add(Severity.Remark, "gcode.dialect_default", "Nothing in the file says which firmware it is for; read as " + rules.Title + ".");
        if (detected is { IsDefault: true } && core.Settings.TryGetValue("gcode_flavor", out var flavour) && DialectDetector.OfFlavour(flavour) is { } meant && meant != rules.Name)
            core.Diagnostics.Add(Severity.Warning, "gcode.dialect_late", "The settings at the end of the file name the flavour \"" + flavour + "\"; it was read as " + rules.Title + ". State the dialect.");
        var settings = core.Settings.ToDictionary(p => p.Key, p => p.Value, StringComparer.Ordinal);
        var toolpath = core.Finish(FilamentFactors.Of(settings, options.FilamentDiameter));
        var report = Reports.Of(core, axis, name, bytes, mark);
        var diagnostics = core.Diagnostics.ToList();
        if (name.Length > 0) diagnostics = diagnostics.Select(d => d with { Source = (d.Source ?? new SourceLocation()) with { File = name } }).ToList();
        return new Result<Decoding>(
            new Decoding(document, toolpath, report, rules, detected?.Evidence ?? [], settings, core.IgnoredCommands.ToDictionary(p => p.Key, p => p.Value, StringComparer.Ordinal), options.Rule)
            {
                Checkpoints = checkpoints?.ToArray() ?? [],
                Axis = axis,
                LastModeLine = core.LastModeLine,
                FirstMarkLine = core.FirstMarkLine,
            },
            diagnostics);
    }
}
