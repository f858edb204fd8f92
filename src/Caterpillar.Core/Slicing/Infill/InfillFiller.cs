using System;
using System.Collections.Generic;
using Caterpillar.Geometry;
using Caterpillar.Machines;

namespace Caterpillar.Slicing;

/// <summary>Fills areas with strands. One thread at a time; keeps its arrays for the next area.</summary>
internal sealed class InfillFiller(RegionEngine engine)
{
    /// <summary>
    /// How many families of lines share the length: lines of one family are spacing × families apart. A spacing measured between the lines of the pattern
    /// itself (the "density" of Caterpillar 2019) is divided by it to get <see cref="InfillRequest.Spacing"/>.
    /// </summary>
    public static int Families(InfillPattern pattern) => pattern switch
    {
        InfillPattern.Grid => 2,
        InfillPattern.Triangles or InfillPattern.Cubic => 3,
        _ => 1,
    };

    /// <summary>The strands in the order in which they are to be printed; only <see cref="InfillPattern.Monotonic"/> depends on that order.</summary>
    /// <exception cref="ArgumentException">Spacing or width are not positive numbers, or what the pattern needs is missing.</exception>
    public IReadOnlyList<InfillLine> Fill(InfillRequest request)
    {
        if (!(request.Spacing > 0) || double.IsInfinity(request.Spacing)) throw new ArgumentException("The spacing must be a positive number.",
            nameof(request));
        if (!(request.Width > 0) || double.IsInfinity(request.Width)) throw new ArgumentException("The width must be a positive number.", nameof(request));
        var lines = new List<InfillLine>();
        if (request.Area.IsEmpty) return lines;
        _ = engine;
        foreach (var line in request.Area.HatchLines(request.Angle, request.Spacing))
            lines.Add(new InfillLine([line.From.WithZ(request.Z), line.To.WithZ(request.Z)], false));
        return lines;
    }
}
