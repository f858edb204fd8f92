namespace Caterpillar.GH.Params;

/// <summary>Printers. Text is the name of a profile.</summary>
public sealed class PrinterParam() : StoredParam<PrinterGoo>("Printer", "Printer", "Contains printers. Text is read as the name of a profile.", Panel.Setup)
{
    public override Guid ComponentGuid => new("496bcf2b-b6ed-43f1-8b3d-8c504772512c");
}

/// <summary>Materials. Text is the name of a profile.</summary>
public sealed class MaterialParam() : StoredParam<MaterialGoo>(
    "Material", "Material", "Contains materials. Text is read as the name of a profile.", Panel.Setup)
{
    public override Guid ComponentGuid => new("103ba614-b4c1-4392-9ef2-5de22cbbe88a");
}

/// <summary>Print settings. Text is the name of a profile.</summary>
public sealed class SettingsParam() : StoredParam<SettingsGoo>(
    "Print Settings", "Settings", "Contains print settings. Text is read as the name of a profile.", Panel.Setup)
{
    public override Guid ComponentGuid => new("af3fca63-c2d4-4ddd-aa9a-d8a1ed78e443");
}

/// <summary>Print setups. Text is the name of a printer profile.</summary>
public sealed class SetupParam() : StoredParam<SetupGoo>(
    "Print Setup", "Setup", "Contains print setups: printer, material, settings, and what is printed on. Text is read as the name of a printer "
        + "profile.", Panel.Setup)
{
    public override Guid ComponentGuid => new("e84a0b17-6c5f-4d92-b1e8-0f7d3a9c2b24");

    private protected override string Question => "Printer profile";
}
