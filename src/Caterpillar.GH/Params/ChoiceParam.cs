using System;
using System.Collections.Generic;
using System.Drawing;
using System.Globalization;
using System.Linq;
using Grasshopper.Kernel;
using Grasshopper.Kernel.Parameters;
using Grasshopper.Kernel.Types;

namespace Caterpillar.GH.Params;

/// <summary>An integer with named values that also takes the names as text, whatever their case and spaces.</summary>
public sealed class ChoiceParam : Param_Integer
{
    private readonly Dictionary<string, int> _values = new(StringComparer.OrdinalIgnoreCase);

    public override Guid ComponentGuid => new("0affb938-c607-4099-91df-066bc62dce25");

    public override GH_Exposure Exposure => GH_Exposure.hidden;

    protected override Bitmap? Icon => Plugin.Icons.Load(nameof(ChoiceParam));

    /// <summary>A choice among the values of an enum; <c>OuterWall</c> is shown as "Outer Wall".</summary>
    public static ChoiceParam Of<T>()
        where T : struct, Enum
    {
        var param = new ChoiceParam();
        foreach (T value in Enum.GetValues(typeof(T))) param.AddChoice(Spaced(value.ToString()), Convert.ToInt32(value, CultureInfo.InvariantCulture));
        return param;
    }

    protected override GH_Integer? PreferredCast(object data)
    {
        var text = data as string ?? (data as GH_String)?.Value;
        return text is not null && _values.TryGetValue(Joined(text), out var value) ? new GH_Integer(value) : null;
    }

    private void AddChoice(string name, int value)
    {
        AddNamedValue(name, value);
        _values[Joined(name)] = value;
    }

    private static string Joined(string name) => string.Concat(name.Where(char.IsLetterOrDigit));

    private static string Spaced(string name)
    {
        var text = "";
        foreach (var c in name) text += text.Length > 0 && char.IsUpper(c) && !char.IsUpper(text[text.Length - 1]) ? " " + c : c.ToString();
        return text;
    }
}
