using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.GH.Plugin;
using Grasshopper.Kernel;

namespace Caterpillar.GH.Tests.Plugin;

/// <summary>The components and parameters of the plug-in.</summary>
internal static class PluginTypes
{
    public static IEnumerable<Type> Objects { get; } = typeof(PluginInfo).Assembly.GetTypes()
        .Where(t => !t.IsAbstract && typeof(IGH_DocumentObject).IsAssignableFrom(t)).OrderBy(t => t.FullName, StringComparer.Ordinal).ToArray();

    public static IEnumerable<Type> Components { get; } = Objects.Where(t => typeof(GH_Component).IsAssignableFrom(t)).ToArray();

    public static IEnumerable<Type> Params { get; } = Objects.Where(t => typeof(IGH_Param).IsAssignableFrom(t)).ToArray();

    public static T Make<T>(Type type) => (T)Activator.CreateInstance(type)!;
}
