using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.GH.Components.Simulate;
using Caterpillar.GH.Goos;
using Caterpillar.GH.Tests.Host;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.GH.Tests.Components;

[NonParallelizable]
public sealed class ViewerPageTests
{
    private static readonly ToolpathGoo Goo = new(Planner.Plan(
        [new PrintPath([new Vec3(50, 50, 0.2), new Vec3(80, 50, 0.2)], new Bead(0.08, 0.2, 40))], new PrintSetup()).Value!, new PrintSetup());

    private readonly List<string> _opened = [];
    private string _file = "";
    private Action<string> _opens = _ => { };

    [SetUp]
    public void SetUp()
    {
        _file = Path.Combine(Path.GetTempPath(), "caterpillar-" + Guid.NewGuid().ToString("N") + ".html");
        _opens = ViewerPageComponent.Opens;
        ViewerPageComponent.Opens = _opened.Add;
    }

    [TearDown]
    public void TearDown()
    {
        ViewerPageComponent.Opens = _opens;
        File.Delete(_file);
    }

    [Test]
    public void A_press_saves_the_page_and_another_opens_it()
    {
        var canvas = Fed();
        Assert.That((canvas.All("Path").Single(), File.Exists(_file)), Is.EqualTo(((object?)null, false)), "Nothing is pressed.");
        canvas.Feed("Save", true).Solve();
        Assert.That(canvas.Errors, Is.Empty);
        Assert.That(canvas.One<string>("Path"), Is.EqualTo(_file));
        Assert.That(File.ReadAllText(_file), Does.StartWith("<!").And.Contains(Path.GetFileNameWithoutExtension(_file)));
        Assert.That(_opened, Is.Empty);
        canvas.Feed("Save", false).Feed("Open", true).Solve();
        Assert.That(_opened, Is.EqualTo(new[] { _file }));
        canvas.Solve();
        Assert.That(_opened, Has.Count.EqualTo(1), "A button that is held opens it once.");
    }

    [Test]
    public void An_existing_file_is_overwritten_only_if_asked_for()
    {
        File.WriteAllText(_file, "mine");
        var canvas = Fed().Feed("Save", true).Solve();
        Assert.That(canvas.Errors, Has.One.Contains("already exists. Set Overwrite to true"));
        Assert.That(File.ReadAllText(_file), Is.EqualTo("mine"));
        canvas.Feed("Save", false).Solve();
        canvas.Feed("Overwrite", true).Feed("Save", true).Solve();
        Assert.That(canvas.Errors, Is.Empty);
        Assert.That(File.ReadAllText(_file), Is.Not.EqualTo("mine"));
    }

    [Test]
    public void Without_a_page_there_is_nothing_to_open_and_a_missing_browser_is_named()
    {
        var canvas = Fed().Feed("Open", true).Solve();
        Assert.That(canvas.Errors, Has.One.Contains("There is no page yet. Press Save first."));
        File.WriteAllText(_file, "a page");
        ViewerPageComponent.Opens = _ => throw new PlatformNotSupportedException("There is no browser.");
        canvas.Feed("Open", false).Solve();
        canvas.Feed("Open", true).Solve();
        Assert.That(canvas.Errors, Has.One.Contains("There is no browser."));
    }

    private Canvas<ViewerPageComponent> Fed()
        => new Canvas<ViewerPageComponent>().Feed("Toolpath", Goo).Feed("File", _file).Feed("Save", false).Feed("Open", false).Solve();
}
