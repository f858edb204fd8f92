namespace Caterpillar.Cli;

/// <summary>Reads curve files of options.</summary>
internal static class Curves
{
    private const double Tolerance = 0.05;

    /// <summary>The curves of a file, or of standard input.</summary>
    /// <exception cref="CliException">It cannot be read.</exception>
    public static IReadOnlyList<UserCurve> Read(string file, CurveReadOptions reading, Session session)
    {
        var bytes = session.ReadBytes(file);
        return session.Run("Reading", progress => CurveReader.Read(bytes, Session.NameOf(file), reading, progress, session.Cancel));
    }

    /// <summary>The same without percentages.</summary>
    /// <exception cref="CliException">It cannot be read.</exception>
    public static IReadOnlyList<UserCurve> Read(string file, Session session) => Read(file, new CurveReadOptions { Memory = session.Memory }, session);

    /// <summary>The same as polylines within 0.05 mm, transformed like the models.</summary>
    /// <exception cref="CliException">It cannot be read.</exception>
    public static IReadOnlyList<Polyline> ReadPolylines(string file, Affine placed, Session session)
    {
        var options = new SubdivisionOptions { ChordTolerance = Tolerance };
        return Read(file, session).Select(c => new Polyline(
            CurveSubdivider.Subdivide(c.Curve, options, session.Cancel).Points.Select(p => placed.Apply(p)), c.Curve.IsClosed)).ToArray();
    }
}
