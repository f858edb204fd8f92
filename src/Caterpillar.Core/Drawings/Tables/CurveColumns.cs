namespace Caterpillar.Drawings;

/// <summary>The meaning of a column of values.</summary>
internal enum CurveColumn
{
    Ignored = -1,
    X,
    Y,
    Z,
    Area,
    Width,
    Height,
    Speed,
    Flow,
    Tool,
    Layer,
    Dot,
    Key,
}

/// <summary>The names of columns and keys, and the settings of points while they are read.</summary>
internal static class CurveColumns
{
    /// <summary>Number of settings of points, from <see cref="CurveColumn.Area"/>.</summary>
    public const int Settings = 4;

    public const string NoPercentage = "A percentage is not allowed here, or its reference is unknown.";

    public const string Negative = "Settings of an extrusion must be 0 or more.";

    /// <summary>The value at 100 % of a column; 0 = percentages are not allowed.</summary>
    public static double Whole(CurveColumn column, CurveReadOptions options) => column switch
    {
        CurveColumn.Width => options.WidthReference,
        CurveColumn.Height => options.HeightReference,
        CurveColumn.Speed => options.SpeedReference,
        CurveColumn.Flow => 1,
        _ => 0,
    };

    /// <summary>The column of a name. Case and units like <c>width_mm</c> or <c>speed (mm/s)</c> do not matter. Unknown names are ignored.</summary>
    public static CurveColumn Of(string name)
    {
        var plain = name.Trim().Trim('"', '\'').ToLowerInvariant();
        var at = plain.IndexOfAny(['(', '[']);
        if (at > 0) plain = plain.Substring(0, at).Trim();
        foreach (var unit in new[] { "_mm_s", "_mm2", "_mm3", "_mm" })
        {
            if (plain.Length > unit.Length && plain.EndsWith(unit, System.StringComparison.Ordinal)) plain = plain.Substring(0, plain.Length - unit.Length);
        }
        return plain switch
        {
            "x" => CurveColumn.X,
            "y" => CurveColumn.Y,
            "z" => CurveColumn.Z,
            "area" => CurveColumn.Area,
            "width" or "line_width" or "w" => CurveColumn.Width,
            "height" or "layer_height" or "h" => CurveColumn.Height,
            "speed" or "print_speed" => CurveColumn.Speed,
            "flow" or "flow_ratio" => CurveColumn.Flow,
            "tool" => CurveColumn.Tool,
            "layer" => CurveColumn.Layer,
            "dot" or "blob" => CurveColumn.Dot,
            "curve" or "path" or "polyline" or "id" or "name" or "stroke" => CurveColumn.Key,
            _ => CurveColumn.Ignored,
        };
    }

    /// <summary>
    /// The curve with settings from columns of its points: area, width, height and speed. Missing columns are null. A column of equal values becomes a setting
    /// of the whole curve.
    /// </summary>
    public static UserCurve WithValues(UserCurve curve, double[]?[] columns)
    {
        var along = new double[]?[Settings];
        var whole = new double?[Settings + 1];
        var any = false;
        for (var i = 0; i < Settings; i++)
        {
            if (columns[i] is not { Length: > 0 } column) continue;
            if (System.Array.TrueForAll(column, v => v.Equals(column[0])))
            {
                whole[i] = column[0];
                continue;
            }
            along[i] = column;
            any = true;
        }
        curve = With(curve, whole);
        return any ? curve with { Along = new PointValues(along[0], along[1], along[2], along[3]) } : curve;
    }

    /// <summary>The curve with the settings that are given: area, width, height, speed and flow.</summary>
    public static UserCurve With(UserCurve curve, double?[] given) => curve with
    {
        Area = given[0] ?? curve.Area,
        Width = given[1] ?? curve.Width,
        Height = given[2] ?? curve.Height,
        Speed = given[3] ?? curve.Speed,
        Flow = given[4] ?? curve.Flow,
    };

    /// <summary>The columns with only their first values.</summary>
    public static double[]?[] Shortened(double[]?[] columns, int count) => System.Array.ConvertAll(columns, c => c?.Take(count).ToArray());
}
