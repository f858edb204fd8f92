namespace Caterpillar.Cli;

/// <summary>The verbs in the order of the help.</summary>
internal static class Verbs
{
    public static IEnumerable<Verb> All() =>
    [
        new SliceVerb(),
        new DecodeVerb(),
        new SimulateVerb(),
        new ConvertVerb(),
        new SectionsVerb(),
        new TurtleVerb(),
        new CurvesVerb(),
        new ImageVerb(),
        new ViewVerb(),
        new CheckVerb(),
        new PrintersVerb(),
        new CompletionsVerb(),
    ];

    /// <summary>A new instance of a verb.</summary>
    public static Verb Named(string name) => All().First(v => v.Name == name);
}
