namespace Caterpillar.Checks;

/// <summary>Reads an edited file again, compares it with its toolpath and checks it.</summary>
internal static class EditCheck
{
    // mm; files have three decimals or two.
    private const double Position = 0.006;
    private const double Share = 0.001;

    public static IReadOnlyList<Diagnostic> Run(
        DecodedGCode decoding, Toolpath edited, GCodeDocument document, PrintSetup setup, IProgress<double>? progress, CancellationToken cancel,
        DecodedGCode? before = null)
    {
        var options = new DecodeOptions { Flavor = decoding.Flavor, Rule = decoding.Rule, FilamentDiameter = setup.Material.FilamentDiameter };
        var file = GCodeDecoder.Decode(document, options, null, cancel).OrThrow();
        var findings = new Findings(setup.Printer, file.Toolpath);
        Compare(edited, file.Toolpath, findings);
        var checks = PrintCheck.RunFile(file, setup, before ?? decoding, progress, cancel);
        return [.. findings.ToList(), .. checks, .. DecodingNotes.Of(file, before ?? decoding)];
    }

    // Edits may join and divide moves: where their numbers differ, only the sums are compared.
    private static void Compare(Toolpath wanted, Toolpath read, Findings findings)
    {
        if (wanted.Count == read.Count)
        {
            for (var block = 0; block < wanted.Blocks.Count; block++)
            {
                var c = wanted.Blocks[block].Columns;
                for (var i = 0; i < c.Count; i++) Compare(new Vec3(c.X[i], c.Y[i], c.Z[i]), c.E[i], read, wanted.FirstOf(block) + i, findings);
            }
            return;
        }
        var (a, b) = (ToolpathTotals.Of(wanted), ToolpathTotals.Of(read));
        if (Math.Abs(a.PrintLength - b.PrintLength) > Share * a.PrintLength + Position)
            findings.Add(CheckCodes.FilePosition, () => null, () => $"The file prints {NumberFormatter.Format(b.PrintLength, 2)} mm, but the edit has "
                + $"{NumberFormatter.Format(a.PrintLength, 2)} mm.");
        if (Math.Abs(a.DepositedE - b.DepositedE) > Share * a.DepositedE + Position)
            findings.Add(CheckCodes.FileExtrusion, () => null, () => $"The file extrudes {NumberFormatter.Format(b.DepositedE, 3)}, but the edit has "
                + $"{NumberFormatter.Format(a.DepositedE, 3)}.");
    }

    private static void Compare(Vec3 wanted, double e, Toolpath read, int move, Findings findings)
    {
        var block = read.BlockOf(move);
        var (c, i) = (read.Blocks[block].Columns, move - read.FirstOf(block));
        var end = new Vec3(c.X[i], c.Y[i], c.Z[i]);
        if (Math.Abs(end.X - wanted.X) > Position || Math.Abs(end.Y - wanted.Y) > Position || Math.Abs(end.Z - wanted.Z) > Position)
            findings.Add(CheckCodes.FilePosition, move, () => $"The head is at {end} after this line, but the edit has {wanted}.");
        var got = c.E[i];
        if (Math.Abs(got - e) > Position + Share * Math.Abs(e))
            findings.Add(CheckCodes.FileExtrusion, move, () => $"E changes by {NumberFormatter.Format(got, 5)} in this line, but the edit has "
                + $"{NumberFormatter.Format(e, 5)}.");
    }
}
