using Caterpillar.Geometry;

namespace Caterpillar.Machines;

/// <summary>What a header and a footer of G-code say of a machine.</summary>
/// <param name="Printer">The machine, with both files as templates.</param>
/// <param name="Material">A material with the temperatures of the header; 0 where it heats nothing.</param>
/// <param name="Start">Where the header leaves the nozzle, mm; null where it does not say, or has <c>{x}</c>, <c>{y}</c>, <c>{z}</c> for it.</param>
public sealed record ImportedPrinter(Printer Printer, Material Material, Vec3? Start);
