namespace Caterpillar.Machines;

/// <summary>A printer from the G-code of a header and a footer.</summary>
/// <param name="Printer">The printer, with both files as templates.</param>
/// <param name="Material">A material with the temperatures of the header; 0 = not heated.</param>
/// <param name="Start">Position of the nozzle after the header, mm; null if unknown or given as <c>{x}</c>, <c>{y}</c>, <c>{z}</c>.</param>
public sealed record ImportedPrinter(Printer Printer, Material Material, Vec3? Start);
