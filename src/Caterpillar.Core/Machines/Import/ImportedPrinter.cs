using Caterpillar.Geometry;

namespace Caterpillar.Machines;

/// <summary>What the G-code of a header and a footer states about a machine.</summary>
/// <param name="Printer">The machine, with both files as templates.</param>
/// <param name="Material">A material with the temperatures of the header; 0 if it heats nothing.</param>
/// <param name="Start">Where the header leaves the nozzle, mm; null if unknown or given as <c>{x}</c>, <c>{y}</c>, <c>{z}</c>.</param>
public sealed record ImportedPrinter(Printer Printer, Material Material, Vec3? Start);
