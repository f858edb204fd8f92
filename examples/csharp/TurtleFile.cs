using System.Collections.Generic;
using Caterpillar.Jobs;
using Caterpillar.Machines;

namespace Caterpillar.Examples.CSharp;

/// <summary>Prints a turtle program from a file, with a value for one of its parameters.</summary>
public static class TurtleFile
{
    public static void Run(string script, string output)
    {
        var setup = new ProfileLibrary().Setup("generic").OrThrow();
        var values = new Dictionary<string, double> { ["layers"] = 3 };
        PrintJob.Turtle(script, setup, values).OrThrow().WriteFile(output).OrThrow();
    }
}
