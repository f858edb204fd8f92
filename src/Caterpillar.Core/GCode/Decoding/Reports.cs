using System;
using Caterpillar.Geometry;

namespace Caterpillar.GCode;

/// <summary>Makes the report from the sums.</summary>
internal static class Reports
{
    public static DecodeReport Of(DecoderCore core, ExtrusionAxis axis, string name, long bytes, bool mark)
    {
        var tally = core.DecodeCounters;
        var used = core.UsedByTool();
        var sum = 0.0;
        foreach (var tool in used) sum += tool.Value;
        var prints = new Box();
        prints.Include(tally.PrintStarts);
        prints.Include(tally.PrintEnds);
        var all = new Box();
        all.Include(tally.PrintEnds);
        all.Include(tally.TravelEnds);
        return new DecodeReport
        {
            File = name,
            Bytes = bytes,
            ExtrusionAxis = axis.Name,
            HasAmounts = axis.HasAmounts || axis == ExtrusionAxis.None,
            PrintSegments = tally.Prints,
            TravelSegments = tally.Travels,
            TravelsWithRetract = tally.TravelsWithRetract,
            PrintArcs = tally.PrintArcs,
            TravelArcs = tally.TravelArcs,
            PrintsByG0 = tally.PrintsG0,
            TravelsByG1 = tally.TravelsG1,
            RapidMoves = tally.Rapids,
            FeedMoves = tally.Feeds,
            Retracts = tally.Retracts,
            Unretracts = tally.Unretracts,
            FirmwareRetracts = tally.FirmwareRetracts,
            FirmwareUnretracts = tally.FirmwareUnretracts,
            NoOps = tally.NoOps,
            ToolChanges = tally.ToolChanges,
            LayerMarks = tally.LayerMarks,
            PrintLength = tally.PrintLength,
            PrintLengthXY = tally.PrintLengthXY,
            TravelLength = tally.TravelLength,
            EPositive = tally.EPositive,
            ENegative = tally.ENegative,
            EPrint = tally.EPrint,
            ENet = tally.ENet,
            EUsed = sum,
            EUsedByTool = used,
            EByMarlin2Rule = core.EByMarlin2Rule is { } other && Math.Abs(other - tally.ENet) > 1e-3 ? other : null,
            Heights = tally.Heights,
            FlatHeights = tally.FlatHeights,
            HeightChanges = tally.ZChanges,
            PrintBounds = ToBounds(prints),
            AllBounds = ToBounds(all),
            EndPosition = core.Position,
            Features = core.Features.ToList(),
            ByteOrderMark = mark,
            Thumbnails = core.Thumbnails,
        };
    }

    private static Bounds ToBounds(Box box)
        => box.IsEmpty ? Bounds.Empty : new Bounds(new Vec3(box.MinX, box.MinY, box.MinZ), new Vec3(box.MaxX, box.MaxY, box.MaxZ));
}
