using System.Runtime.InteropServices;
using System.Security.Cryptography;

namespace Caterpillar.Cli;

/// <summary>Reports the contents of G-code files.</summary>
internal sealed class DecodeVerb : Verb
{
    private readonly Argument<string[]> _files = new("FILE") { Description = CommonOptions.GCodeInput, Arity = ArgumentArity.OneOrMore };
    private readonly Described<bool> _json = new("--json", "Print a JSON array with one object per file.");
    private readonly Described<bool> _csv = new("--csv", "Print a CSV table with one row per move.");
    private readonly Described<bool> _stats = new("--stats",
        "Also print times, material, roles, tools and layers. Times depend on --printer.");

    private readonly SetupOptions _setup = new(SetupOptions.FromFile);
    private readonly Option<string?> _flavor = CommonOptions.Flavor();
    private readonly Described<double?> _diameter = CommonOptions.FilamentDiameter();
    private readonly Option<int> _threads = CommonOptions.Threads();

    private readonly Described<string> _rule = new("--rule",
        "E that counts as extrusion. balance: beyond the retracted length. rising: any increase of E.",
        "balance|rising") { DefaultValueFactory = _ => "balance" };

    public DecodeVerb()
        : base("decode", "Report the contents of G-code files: moves, extrusion, layers and roles.")
    {
        Arguments.Add(_files);
        Add([_json, _csv, _stats, _flavor, _rule, _diameter, _threads, .. _setup.All]);
        _rule.AcceptOnlyFromAmong("balance", "rising");
        Validators.Add(result =>
        {
            if (result.GetValue(_json) && result.GetValue(_csv)) result.AddError("--json cannot be combined with --csv.");
            if (result.GetValue(_stats) && result.GetValue(_csv)) result.AddError("--stats cannot be combined with --csv.");
        });
    }

    public override int Run(ParseResult arguments, Session session)
    {
        var options = CommonOptions.Decoding(arguments.GetValue(_flavor), Diameter(arguments, session), arguments.GetValue(_threads), session) with
        {
            Rule = arguments.GetValue(_rule) == "rising" ? ExtrusionRule.Rising : ExtrusionRule.Balance,
            KeepsMoves = !arguments.GetValue(_json) || arguments.GetValue(_stats),
        };
        var json = arguments.GetValue(_json);
        var decoded = new List<(string File, DecodedGCode DecodedGCode, DecodeReport Report)>();
        var bad = false;
        foreach (var file in arguments.GetValue(_files)!)
        {
            try
            {
                decoded.Add(Decode(file, options, json, session));
            }
            catch (CliException stop) when (stop.Message.Length == 0)
            {
                // Already reported. The other files are decoded as well.
                bad = true;
            }
        }
        if (bad) return ExitCode.BadInput;
        if (arguments.GetValue(_csv))
        {
            session.Write("-", stream => MoveTable.Write(stream, decoded.Select(d => (d.File, d.DecodedGCode.Toolpath)).ToArray(), session.Cancel));
            return ExitCode.Done;
        }
        var stats = arguments.GetValue(_stats) ? decoded.Select(d => Timed(d.DecodedGCode, d.Report.File, arguments, session)).ToArray() : [];
        session.WriteText("-", text =>
        {
            if (json && stats.Length > 0)
                text.Write(SimulationJson.Array(stats.Select(s => SimulationJson.Statistics(s.File, s.Sums, s.Toolpath, s.Limits))));
            else if (json) text.Write("[\n " + string.Join(",\n ", decoded.Select(d => d.Report.ToJson(" "))) + "\n]\n");
            else Summaries(text, decoded, stats);
        });
        return ExitCode.Done;
    }

    // Masses need a diameter: from the material if the file does not state it.
    private double? Diameter(ParseResult arguments, Session session)
        => Numbers.Diameter(arguments.GetValue(_diameter), "--filament-diameter")
            ?? (arguments.GetValue(_stats) ? _setup.Resolve(arguments, session).Material.FilamentDiameter : null);

    private static void Summaries(TextWriter text, List<(string File, DecodedGCode DecodedGCode, DecodeReport Report)> decoded, Statistics[] stats)
    {
        for (var i = 0; i < decoded.Count; i++)
        {
            DecodeSummary.Write(text, decoded[i].DecodedGCode, decoded[i].Report);
            if (stats.Length > 0) StatisticsText.Write(text, stats[i].Sums, stats[i].Limits);
        }
    }

    private Statistics Timed(DecodedGCode decoded, string file, ParseResult arguments, Session session)
    {
        var timed = TimedFile.Of(_setup, arguments, decoded, session);
        return new Statistics(file, timed.Statistics(file, session), timed.Toolpath, timed.Limits);
    }

    // On Linux it belongs to OpenSSL; where that is missing, the runtime would end the program.
    private static bool HasSha256
        => !OperatingSystem.IsLinux() || NativeLibrary.TryLoad("libssl.so.3", out _) || NativeLibrary.TryLoad("libssl.so.1.1", out _);

    private sealed record Statistics(string File, PrintStatistics Sums, Toolpath Toolpath, string Limits);

    private static (string, DecodedGCode, DecodeReport) Decode(string file, DecodeOptions options, bool hash, Session session)
    {
        var name = Session.NameOf(file);
        using var plain = GzipReader.Open(session.OpenRead(file));
        hash &= HasSha256;
        // A file is read a second time for its hash: a stream that is being hashed cannot jump to its end, where decoding looks first.
        var hashing = hash && plain.CanSeek ? Task.Run(() => HashOf(file, session)) : null;
        using var sum = hash && hashing is null ? SHA256.Create() : null;
        using var stream = sum is null ? plain : new CryptoStream(plain, sum, CryptoStreamMode.Read);
        var result = session.Decode(stream, name, options);
        if (plain is GzipReader { HasTrailingBytes: true }) session.Print([GzipReader.TrailingBytes("gcode.compression", name)]);
        var decoding = session.GCodeOrFail(result);
        var report = decoding.Report with { File = file == "-" ? "-" : Path.GetFileName(file) };
        if (sum is not null) stream.CopyTo(Stream.Null);
        var bytes = hashing?.GetAwaiter().GetResult() ?? sum?.Hash ?? [];
        return (name, decoding, report with { Sha256 = Convert.ToHexStringLower(bytes) });
    }

    private static byte[] HashOf(string file, Session session)
    {
        using var stream = session.OpenRead(file);
        return SHA256.HashData(stream);
    }
}
