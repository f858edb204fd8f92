using System.Text;
using Caterpillar.Machines;
using NUnit.Framework;

namespace Caterpillar.Tests.Machines;

/// <summary>
/// What holds where a profile states nothing: whoever changes a default changes prints, and has to see it. The files are in <c>GoldenFiles/defaults</c>.
/// </summary>
public class DefaultTests
{
    [Test]
    public void Printers_that_state_nothing() => Golden.Check("defaults/printer.json", Encoding.UTF8.GetBytes(ProfileWriter.Write(new Printer())));

    [Test]
    public void Materials_that_state_nothing() => Golden.Check("defaults/material.json", Encoding.UTF8.GetBytes(ProfileWriter.Write(new Material())));

    [Test]
    public void Settings_that_state_nothing() => Golden.Check("defaults/settings.json", Encoding.UTF8.GetBytes(ProfileWriter.Write(new PrintSettings())));
}
