using System;

namespace Caterpillar.Machines;

/// <summary>Everything that planning, writing and checking need to know: the machine, the material and how to print. Immutable.</summary>
public sealed record PrintSetup
{
    /// <summary>The generic printer with PLA and standard settings, without start and end code.</summary>
    public PrintSetup()
        : this(new Printer(), new Material(), new PrintSettings())
    {
    }

    public PrintSetup(Printer printer, Material material, PrintSettings settings)
    {
        Printer = printer ?? throw new ArgumentNullException(nameof(printer));
        Material = material ?? throw new ArgumentNullException(nameof(material));
        Settings = settings ?? throw new ArgumentNullException(nameof(settings));
    }

    public Printer Printer { get; init; }

    public Material Material { get; init; }

    public PrintSettings Settings { get; init; }

    /// <summary>How amounts of E follow from strands.</summary>
    public ExtrusionLaw Extrusion => new(Printer.ExtrusionUnit, Material.FilamentDiameter, Material.FlowMultiplier);

    /// <summary>What machine and material can push, mm³/s; infinite where neither says.</summary>
    public double MaxFlow
    {
        get
        {
            var machine = Printer.MaxFlow > 0 ? Printer.MaxFlow : double.PositiveInfinity;
            var material = Material.MaxFlow > 0 ? Material.MaxFlow : double.PositiveInfinity;
            return Math.Min(machine, material);
        }
    }
}
