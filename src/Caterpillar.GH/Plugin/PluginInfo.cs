using System.Reflection;
using Grasshopper;

namespace Caterpillar.GH.Plugin;

/// <summary>Information about the plug-in for Grasshopper and for package restore.</summary>
public sealed class PluginInfo : GH_AssemblyInfo
{
    /// <summary>Name of the tab.</summary>
    public const string Tab = "Caterpillar";

    /// <summary>Version of the plug-in, as it is stored in definitions.</summary>
    internal static Version Current { get; } = typeof(PluginInfo).Assembly.GetName().Version ?? new Version(0, 0);

    public override string Name => Tab;

    public override string Description => "Turns designs into 3D-printer motion, and G-code back into toolpaths.";

    public override Bitmap? Icon => Icons.Load("Plugin");

    public override Guid Id => new("f3ff75ca-289b-45b6-9986-65dad16f12ef");

    public override string AuthorName => "The Caterpillar authors";

    public override string AuthorContact => "";

    public override string Version
        => typeof(PluginInfo).Assembly.GetCustomAttribute<AssemblyInformationalVersionAttribute>()?.InformationalVersion.Split('+')[0] ?? Current.ToString(3);

    public override GH_LibraryLicense License => GH_LibraryLicense.opensource;
}

/// <summary>Names and draws the tab before the components are loaded.</summary>
public sealed class PluginPriority : GH_AssemblyPriority
{
    public override GH_LoadingInstruction PriorityLoad()
    {
        var icon = Icons.Load("Plugin");
        if (icon is not null) Instances.ComponentServer.AddCategoryIcon(PluginInfo.Tab, icon);
        Instances.ComponentServer.AddCategorySymbolName(PluginInfo.Tab, 'C');
        return GH_LoadingInstruction.Proceed;
    }
}
