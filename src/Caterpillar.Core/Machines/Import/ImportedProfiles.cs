namespace Caterpillar.Machines;

/// <summary>Profiles from files of other programs.</summary>
/// <param name="Printers">The printers. Their default material and settings are among the others, if the file has them.</param>
/// <param name="Materials">The materials.</param>
/// <param name="Settings">The print settings.</param>
/// <param name="Start">Position of the nozzle after a header, mm; null if unknown or given as <c>{x}</c>, <c>{y}</c>, <c>{z}</c>.</param>
public sealed record ImportedProfiles(
    IReadOnlyList<Printer> Printers, IReadOnlyList<Material> Materials, IReadOnlyList<PrintSettings> Settings, Vec3? Start = null);
