using System;
using Rhino;

namespace Caterpillar.GH.Tests.Host;

/// <summary>A Rhino document in other units for the duration of a test.</summary>
internal sealed class InDocument : IDisposable
{
    public InDocument(UnitSystem units = UnitSystem.Millimeters) => RhinoDoc.ActiveDoc = Document = new RhinoDoc { ModelUnitSystem = units };

    public RhinoDoc Document { get; }

    public void Dispose() => RhinoDoc.ActiveDoc = null;
}
