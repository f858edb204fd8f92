using System;
using Caterpillar.GH.Components.Setup;
using Caterpillar.GH.Tests.Base;
using Grasshopper;
using Grasshopper.Kernel;
using NUnit.Framework;
using Rhino;

namespace Caterpillar.GH.Tests.Recorded;

/// <summary>Where work may outlive a solution. What it changes belongs to the whole host.</summary>
[NonParallelizable]
public sealed class OnCanvasTests
{
    private readonly GH_Document _document = new();

    [TearDown]
    public void TearDown()
    {
        RhinoApp.Headless = false;
        Instances.DocumentServer.RemoveDocument(_document);
        _document.Owner = null;
    }

    [Test]
    public void Only_in_a_definition_that_is_open_in_the_editor()
    {
        var may = new SlowComponent().Background.MayLeave;
        Assert.That(may(null), Is.False, "In no document.");
        Assert.That(may(_document), Is.False, "A server and a script make their own document.");
        Instances.DocumentServer.AddDocument(_document);
        Assert.That(may(_document), Is.True);
        RhinoApp.Headless = true;
        Assert.That(may(_document), Is.False);
        RhinoApp.Headless = false;
        _document.Owner = new Cluster();
        Assert.That(may(_document), Is.False, "A cluster gives its outputs when its inside is solved.");
        _document.Owner = null;
        var wait = new WaitForResultsComponent();
        _document.AddObject(wait, false);
        Assert.That(may(_document), Is.False, "The definition asks for it.");
        wait.Locked = true;
        Assert.That(may(_document), Is.True);
    }

    private sealed class Cluster : IGH_DocumentOwner
    {
        public void DocumentModified(GH_Document document) => throw new NotSupportedException();

        public void DocumentClosed(GH_Document document) => throw new NotSupportedException();

        public GH_Document OwnerDocument() => throw new NotSupportedException();
    }
}
