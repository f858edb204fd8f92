namespace Caterpillar.GH.Components.Setup;

/// <summary>A port for a key of a profile: its type, its texts, its value.</summary>
internal static class KeyPort
{
    /// <summary>A port of the type of a key. Text without a key.</summary>
    public static IGH_Param Make(ProfileKey? key, bool isUsual = false)
    {
        IGH_Param param = key?.Kind switch
        {
            // A number, or a text such as 110%. The usual ports were numbers before.
            KeyKind.Number when key.TakesPercent && !isUsual => new Param_GenericObject(),
            KeyKind.Number => new Param_Number(),
            KeyKind.Integer => new Param_Integer(),
            KeyKind.Boolean => new Param_Boolean(),
            KeyKind.Choice => ChoiceParam.Of(key.Choices),
            _ => new Param_String(),
        };
        param.Optional = true;
        return param;
    }

    /// <summary>Gives a port the texts and the access of a key, and the choices that a file may lack.</summary>
    public static void Describe(IGH_Param port, ProfileKey? key)
    {
        port.Optional = true;
        port.Access = key?.Kind is KeyKind.Lines or KeyKind.Numbers or KeyKind.Rows ? GH_ParamAccess.list : GH_ParamAccess.item;
        port.Description = key is null ? "Rename this port to a key, such as those in the manual. It gets the type of the key." : Sentence(key);
        if (port is ChoiceParam choice && key is not null) choice.Take(ChoiceParam.Of(key.Choices));
    }

    /// <summary>What a key means, with its unit and range.</summary>
    public static string Sentence(ProfileKey key)
        => $"{key.Summary} {key.Name}: {key.Range}{(key.Unit.Length > 0 ? " " + key.Unit : "")}. Default: as in the profile.";

    /// <summary>The value of a port as text after <c>key=</c>. Null without a value.</summary>
    public static string? Value(Run run, int input, IGH_Param port, ProfileKey key)
    {
        switch (key.Kind)
        {
            case KeyKind.Number when port is Param_GenericObject && run.Maybe<IGH_Goo>(input) is GH_String size: return size.Value;
            case KeyKind.Number: return run.MaybeValue<double>(input) is null ? null : NumberFormatter.Shortest(run.Finite(input));
            case KeyKind.Integer: return run.MaybeValue<int>(input) is { } number ? NumberFormatter.Format(number) : null;
            case KeyKind.Boolean: return run.MaybeValue<bool>(input) is { } flag ? (flag ? "true" : "false") : null;
            case KeyKind.Choice:
                if (run.MaybeValue<int>(input) is not { } choice) return null;
                return choice >= 0 && choice < key.Choices.Count ? key.Choices[choice]
                    : throw new InputProblem(((ChoiceParam)port).Refuse(NumberFormatter.Format(choice)));
            case KeyKind.Text: return run.Maybe<string>(input);
        }
        var items = run.List<GH_String>(input).Select(s => s.Value).ToArray();
        return items.Length == 0 ? null : string.Join(key.Kind == KeyKind.Lines ? "\n" : key.Kind == KeyKind.Rows ? ";" : ",", items);
    }
}
