using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Basics;

namespace Caterpillar.Machines;

/// <summary>Applies <c>key=value</c> to a setup.</summary>
internal static class SetupValues
{
    public static Result<PrintSetup> Apply(PrintSetup setup, IEnumerable<string> values)
    {
        var diagnostics = new List<Diagnostic>();
        foreach (var entry in values)
        {
            var at = entry.IndexOfAny(['=']);
            var key = (at < 0 ? entry : entry.Substring(0, at)).Trim();
            var place = new SourceLocation(Key: key);
            if (at < 0) diagnostics.Add(new Diagnostic(Severity.Error, "profile.no_value", $"\"{entry}\" is not key=value.", place));
            else setup = One(setup, key, entry.Substring(at + 1), place, diagnostics);
        }
        return new Result<PrintSetup>(diagnostics.Any(d => d.Severity == Severity.Error) ? null : setup, diagnostics);
    }

    private static PrintSetup One(PrintSetup setup, string key, string text, SourceLocation place, List<Diagnostic> diagnostics)
    {
        // All three have a title; it does not affect the print.
        if (key != "title")
        {
            if (ProfileKinds.Settings.Find(key) is { } settings)
                return setup with { Settings = ProfileReader.Apply(ProfileKinds.Settings, setup.Settings, key, Parse(settings, text), place, diagnostics) };
            if (ProfileKinds.Material.Find(key) is { } material)
                return setup with { Material = ProfileReader.Apply(ProfileKinds.Material, setup.Material, key, Parse(material, text), place, diagnostics) };
            if (ProfileKinds.Printer.Find(key) is { } printer)
                return setup with { Printer = ProfileReader.Apply(ProfileKinds.Printer, setup.Printer, key, Parse(printer, text), place, diagnostics) };
        }
        var known = SettingsKeys.All.Cast<ProfileKey>().Concat(MaterialKeys.All).Concat(PrinterKeys.All).Select(k => k.Name).Where(k => k != "title");
        diagnostics.Add(ProfileReader.Unknown("printer, material or settings", key, known, place));
        return setup;
    }

    // Text of another kind is passed on as text, so that the message can show it.
    private static object Parse(ProfileKey key, string text) => key.Format.Parse(text) ?? text;
}
