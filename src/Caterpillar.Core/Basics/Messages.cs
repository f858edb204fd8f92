namespace Caterpillar.Basics;

/// <summary>Messages of exceptions.</summary>
internal static class Messages
{
    /// <summary>The message of an exception without the name of the parameter, which the runtimes append differently.</summary>
    public static string Clean(Exception e)
    {
        var text = e.Message;
        var end = text.IndexOf(" (Parameter '", StringComparison.Ordinal);
        if (end < 0) end = text.IndexOf("\nParameter name:", StringComparison.Ordinal);
        return end < 0 ? text : text.Substring(0, end).TrimEnd('\r');
    }
}
