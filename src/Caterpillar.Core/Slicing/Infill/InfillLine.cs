namespace Caterpillar.Slicing;

/// <summary>An extrusion of infill.</summary>
/// <param name="Points">mm, at the height of the request; a closed line does not repeat its first point.</param>
/// <param name="Closed">A loop.</param>
/// <param name="Flow">Flow ratio of each segment, or null if it is 1 throughout.</param>
internal sealed record InfillLine(Vec3[] Points, bool Closed, double[]? Flow = null)
{
    /// <summary>Length in mm of an extrusion of the full area with the same volume.</summary>
    public double Length
    {
        get
        {
            var sum = 0.0;
            for (var i = Closed ? 0 : 1; i < Points.Length; i++)
            {
                // Segment i − 1 ends at point i; the one that closes a loop is the last.
                var segment = i == 0 ? Points.Length - 1 : i - 1;
                sum += Points[i].DistanceTo(Points[i == 0 ? Points.Length - 1 : i - 1]) * (Flow is null ? 1 : Flow[segment]);
            }
            return sum;
        }
    }

    /// <summary>Without points closer than a length (mm) to the one before; the ends stay. Null where nothing of that length is left.</summary>
    public InfillLine? WithoutShort(double least)
    {
        var points = new Vec3[Points.Length];
        var flow = Flow is null ? null : new double[Flow.Length];
        points[0] = Points[0];
        var n = 1;
        for (var i = 1; i < Points.Length; i++)
        {
            if (Points[i].DistanceTo(points[n - 1]) >= least)
            {
                if (flow is not null) flow[n - 1] = Flow![i - 1];
                points[n++] = Points[i];
            }
            else if (i + 1 == Points.Length && !Closed && n > 1)
            {
                points[n - 1] = Points[i];
            }
        }
        if (Closed && n > 1 && points[n - 1].DistanceTo(points[0]) < least) n--;
        if (n < 2) return null;
        if (n == Points.Length) return this;
        if (flow is not null && Closed) flow[n - 1] = Flow![Flow.Length - 1];
        System.Array.Resize(ref points, n);
        if (flow is not null) System.Array.Resize(ref flow, Closed ? n : n - 1);
        return new InfillLine(points, Closed, flow);
    }
}
