using System.Collections.Generic;

namespace Caterpillar.Machines;

/// <summary>All keys of profiles, by the kind of profile: the one table that reader, writer, schema, templates, <c>--set</c> and the manual read.</summary>
public static class ProfileKeys
{
    /// <summary>Keys of printers.</summary>
    public static IReadOnlyList<ProfileKey> Printer => PrinterKeys.All;

    /// <summary>Keys of materials.</summary>
    public static IReadOnlyList<ProfileKey> Material => MaterialKeys.All;

    /// <summary>Keys of print settings.</summary>
    public static IReadOnlyList<ProfileKey> Settings => SettingsKeys.All;
}
