namespace Caterpillar.GCode;

/// <summary>Makes the report of a decoded file from its counters.</summary>
internal static class Reports
{
    public static DecodeReport Of(GCodeInterpreter interpreter, ExtrusionAxis axis, string name, long bytes, bool mark)
    {
        var machine = interpreter.Machine;
        var counters = machine.Counters;
        var used = machine.Extruders.UsedByTool();
        var sum = 0.0;
        foreach (var tool in used) sum += tool.Value;
        var prints = new GrowingBox();
        prints.Include(counters.PrintStarts);
        prints.Include(counters.PrintEnds);
        var all = new GrowingBox();
        all.Include(counters.PrintEnds);
        all.Include(counters.TravelEnds);
        return new DecodeReport(counters)
        {
            File = name,
            Bytes = bytes,
            ExtrusionAxis = axis.Name,
            HasAmounts = axis.HasAmounts || axis == ExtrusionAxis.None,
            EUsed = sum,
            EUsedByTool = used,
            EByMarlin2Rule = machine.State.Extrusion.HasMarlin2E && Math.Abs(counters.EMarlin2 - counters.ENet) > 1e-3 ? counters.EMarlin2 : null,
            PrintBounds = prints.ToBounds(),
            AllBounds = all.ToBounds(),
            EndPosition = machine.State.Head.Written,
            Features = machine.Features.ToList(),
            ByteOrderMark = mark,
            Thumbnails = interpreter.Comments.Thumbnails,
            Setup = FileSetup.In(interpreter.Comments.Settings),
        };
    }
}
