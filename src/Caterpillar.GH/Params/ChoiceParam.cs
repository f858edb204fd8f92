namespace Caterpillar.GH.Params;

/// <summary>
/// An integer with named values that also takes the names as text. Case and spaces do not matter. Extracted from a component, it keeps the names, also in
/// the file. Without names, it takes those of the choices that it is connected to.
/// </summary>
public sealed class ChoiceParam : Param_Integer
{
    private const string CountKey = "ChoiceCount";
    private const string NameKey = "ChoiceName";
    private const string ValueKey = "ChoiceValue";
    private readonly List<GH_Integer> _refused = [];

    public override Guid ComponentGuid => new("0affb938-c607-4099-91df-066bc62dce25");

    public override GH_Exposure Exposure => GH_Exposure.hidden;

    /// <summary>Names and numbers of the choices, in the order of the menu.</summary>
    internal List<KeyValuePair<string, int>> Choices { get; } = [];

    /// <summary>The numbers that are chosen: on the wire, for several items also several, or before the first solution those that are stored.</summary>
    internal IEnumerable<int> Chosen
        => (VolatileDataCount > 0 || SourceCount > 0 ? m_data : PersistentData).AllData(true).OfType<GH_Integer>().Select(i => i.Value);

    protected override Bitmap? Icon => Icons.Load(nameof(ChoiceParam));

    /// <summary>A choice among the values of an enum. <c>OuterWall</c> is shown as "Outer Wall".</summary>
    public static ChoiceParam Of<T>()
        where T : struct, Enum
    {
        var param = new ChoiceParam();
        foreach (T value in Enum.GetValues(typeof(T))) param.AddChoice(Spaced(value.ToString()), Convert.ToInt32(value, CultureInfo.InvariantCulture));
        return param;
    }

    /// <summary>The choice among words, by their place.</summary>
    public static ChoiceParam Of(IReadOnlyList<string> words)
    {
        var param = new ChoiceParam();
        for (var i = 0; i < words.Count; i++) param.AddChoice(words[i], i);
        return param;
    }

    /// <summary>Takes the choices of another port.</summary>
    internal void Take(ChoiceParam other)
    {
        ClearNamedValues();
        Choices.Clear();
        foreach (var choice in other.Choices.ToArray()) AddChoice(choice.Key, choice.Value);
    }

    public override bool Write(GH_IWriter writer)
    {
        writer.SetInt32(CountKey, Choices.Count);
        for (var i = 0; i < Choices.Count; i++)
        {
            writer.SetString(NameKey, i, Choices[i].Key);
            writer.SetInt32(ValueKey, i, Choices[i].Value);
        }
        return base.Write(writer);
    }

    public override bool Read(GH_IReader reader)
    {
        if (!base.Read(reader)) return false;
        var count = 0;
        // A port of a component has the choices of this version; a floating parameter those of the file.
        if (Choices.Count > 0 || !reader.TryGetInt32(CountKey, ref count)) return true;
        ClearNamedValues();
        for (var i = 0; i < count; i++) AddChoice(reader.GetString(NameKey, i), reader.GetInt32(ValueKey, i));
        return true;
    }

    protected override GH_Integer? PreferredCast(object data)
    {
        if (Wrapped.Text(data) is not { } text) return null;
        var name = Joined(text);
        foreach (var choice in Known())
        {
            if (string.Equals(Joined(choice.Key), name, StringComparison.OrdinalIgnoreCase)) return new GH_Integer(choice.Value);
        }
        var number = new GH_Integer();
        if (number.CastFrom(data) || !Known().Any()) return null;
        AddRuntimeMessage(GH_RuntimeMessageLevel.Error, Refuse($"\"{text}\""));
        _refused.Add(number);
        return number;
    }

    // Null on the wire, instead of a number that nobody chose.
    protected override void OnVolatileDataCollected()
    {
        TextProblem.Clean(m_data, _refused.Contains);
        _refused.Clear();
    }

    /// <summary>The answer to a value that is not one of the choices.</summary>
    internal string Refuse(string given) => $"{Name} has no choice {given}."
        + (SpellingSuggestion.Hint(given.Trim('"'), Known().Select(c => c.Key)) is { Length: > 0 } hint ? hint
            : $" Choose one of: {string.Join(", ", Known().Select(c => c.Key))}.");

    private IEnumerable<KeyValuePair<string, int>> Known()
        => Choices.Count > 0 ? Choices : Recipients.OfType<ChoiceParam>().Select(r => r.Choices).FirstOrDefault(c => c.Count > 0) ?? [];

    private void AddChoice(string name, int value)
    {
        AddNamedValue(name, value);
        Choices.Add(new KeyValuePair<string, int>(name, value));
    }

    private static string Joined(string name) => string.Concat(name.Where(char.IsLetterOrDigit));

    internal static string Spaced(string name)
    {
        var text = "";
        foreach (var c in name) text += text.Length > 0 && char.IsUpper(c) && !char.IsUpper(text[text.Length - 1]) ? " " + c : c.ToString();
        return text;
    }
}
