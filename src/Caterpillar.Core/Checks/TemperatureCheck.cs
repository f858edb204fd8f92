using System;
using Caterpillar.Basics;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;

namespace Caterpillar.Checks;

/// <summary>Temperatures, of the material and of the events along a toolpath, against the highest that hot end and bed allow.</summary>
internal static class TemperatureCheck
{
    /// <summary>Adds errors <c>limit.nozzle_temperature</c> and <c>limit.bed_temperature</c>.</summary>
    public static void Run(Toolpath toolpath, PrintSetup setup, Findings findings)
    {
        var (printer, material) = (setup.Printer, setup.Material);
        Nozzle(Math.Max(material.NozzleTemperature, material.FirstLayerNozzleTemperature), -1, printer, findings);
        Bed(material.BedTemperature, -1, printer, findings);
        for (var i = 0; i < toolpath.Events.Count; i++)
        {
            var (move, what) = (toolpath.Events[i].Move, toolpath.Events[i].Event);
            if (what is NozzleTemperatureEvent nozzle) Nozzle(nozzle.Celsius, move, printer, findings);
            else if (what is BedTemperatureEvent bed) Bed(bed.Celsius, move, printer, findings);
        }
    }

    private static void Nozzle(double celsius, int move, Printer printer, Findings findings)
    {
        if (celsius > printer.MaxNozzleTemperature)
            findings.Add(Severity.Error, "limit.nozzle_temperature", move, () => Sentence("nozzle", celsius, printer.MaxNozzleTemperature, printer));
    }

    private static void Bed(double celsius, int move, Printer printer, Findings findings)
    {
        if (celsius > printer.MaxBedTemperature)
            findings.Add(Severity.Error, "limit.bed_temperature", move, () => Sentence("bed", celsius, printer.MaxBedTemperature, printer));
    }

    private static string Sentence(string part, double celsius, double most, Printer printer)
        => most == 0
            ? $"The {part} is to be heated to {Number(celsius)} °C; {printer.Title} cannot heat it."
            : $"The {part} is to be heated to {Number(celsius)} °C; {printer.Title} allows {Number(most)} °C at most.";

    private static string Number(double celsius) => NumberFormatter.Format(celsius, 1);
}
