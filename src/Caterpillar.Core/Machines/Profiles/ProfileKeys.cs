using System.Collections.Generic;

namespace Caterpillar.Machines;

/// <summary>All keys of profiles, by the kind of profile: the one table that reader, writer, schema, templates, <c>--set</c> and the manual read.</summary>
public static class ProfileKeys
{
    public static IReadOnlyList<ProfileKey> Printer => PrinterKeys.All;

    public static IReadOnlyList<ProfileKey> Material => MaterialKeys.All;

    public static IReadOnlyList<ProfileKey> Settings => SettingsKeys.All;
}
