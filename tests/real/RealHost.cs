using System;
using System.Collections.Generic;
using System.Reflection;
using System.Runtime.InteropServices;
using NUnit.Framework;
using Rhino;

namespace Caterpillar.GH.Tests.Host
{
    /// <summary>What the tests ask of Rhino itself, answered by a small library in the place of Rhino.</summary>
    internal static class Shim
    {
        [DllImport("rhcommon_c")]
        public static extern void shim_set_document(uint id, byte units);

        [DllImport("rhcommon_c")]
        public static extern IntPtr shim_log();

        [DllImport("rhcommon_c")]
        public static extern void shim_clear_log();
    }

    /// <summary>What was shown on the status bar.</summary>
    internal sealed class ShimLog : List<string>
    {
        public ShimLog() => AddRange(Marshal.PtrToStringAnsi(Shim.shim_log())!.Split(['\n'], StringSplitOptions.RemoveEmptyEntries));

        public new void Clear() => Shim.shim_clear_log();
    }

    internal static class RealHost
    {
        extension(Rhino.UI.StatusBar)
        {
            public static ShimLog Log => [];
        }
    }

    /// <summary>A Rhino document in other units for the duration of a test.</summary>
    internal sealed class InDocument : IDisposable
    {
        public InDocument(UnitSystem units = UnitSystem.Millimeters) => Shim.shim_set_document(7, (byte)units);

        public RhinoDoc Document => RhinoDoc.ActiveDoc;

        public void Dispose() => Shim.shim_set_document(0, 2);
    }
}

/// <summary>Breps ask Rhino's settings once whether to set their flags: answered in advance.</summary>
[SetUpFixture]
public sealed class WithoutRhino
{
    [OneTimeSetUp]
    public void Prepare() => typeof(Rg.Brep).GetField("_setTolerancesBoxesAndFlagsOnConstruct", BindingFlags.NonPublic | BindingFlags.Static)
        ?.SetValue(null, (bool?)false);
}
