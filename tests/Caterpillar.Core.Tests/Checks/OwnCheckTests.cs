using System.IO;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Checks;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Checks;

/// <summary>Checks of the user stand beside those of Caterpillar.</summary>
public sealed class OwnCheckTests
{
    [Test]
    public void An_error_of_an_own_check_refuses_to_write_and_names_the_first_move_and_the_number()
    {
        var print = new SmallPrint().Print(30, 10, 0.2).Print(60, 10, 0.2).Print(60, 40, 0.2).Go(10, 10, 0.2).Build();
        var setup = WithLongest(15);
        var refused = SafeWriter.ToDocument(print, setup);
        Assert.That(refused.Value, Is.Null);
        var found = refused.Diagnostics.Single(d => d.Code == "own.long");
        Assert.That((found.Severity, found.Message, found.Count), Is.EqualTo((Severity.Error, "31.623 mm", 3)));
        Assert.That((found.Source!.Move, found.Source.Step), Is.EqualTo((0, 0)));
        Assert.That(SafeWriter.ToDocument(print, setup, "a test").Value!.ToString(), Is.Not.Null);
        Assert.That(SafeWriter.ToDocument(print, WithLongest(50)).Diagnostics, Is.Empty);
        Assert.That(PrintCheck.Run(print, setup).Single(d => d.Code == "own.long").Count, Is.EqualTo(3));
    }

    [Test]
    public void It_sees_each_move_once_and_where_it_begins()
    {
        var print = new SmallPrint();
        for (var i = 0; i < ToolpathBlock.Capacity + 100; i++) print.Go(i % 2 == 0 ? 60 : 10, 10 + 0.001 * i, 0.2);
        var seen = new Seen();
        var setup = SmallPrint.Setup(p => p with { CheckSeverities = new(CheckCodes.All.Select(r => new CheckSeverity(r.Code, null))) });
        Assert.That(SafeWriter.Write(print.Build(), setup with { OwnChecks = new(() => seen) }, new MemoryStream(), isDraft: true).Value, Is.Not.Null);
        Assert.That(seen.Count, Is.EqualTo(ToolpathBlock.Capacity + 100));
    }

    private static PrintSetup WithLongest(double most) => SmallPrint.Setup() with { OwnChecks = new(() => new LongExtrusions(most)) };

    private sealed class LongExtrusions(double most) : IOwnCheck
    {
        public Diagnostic? Look(in Move move)
            => move.Kind == MoveKind.Print && move.Length > most
                ? new Diagnostic(Severity.Error, "own.long", NumberFormatter.Format(move.Length, 3) + " mm") : null;
    }

    private sealed class Seen : IOwnCheck
    {
        private Vec3? _end;

        public int Count { get; private set; }

        public Diagnostic? Look(in Move move)
        {
            Assert.That(move.Index, Is.EqualTo(Count++));
            Assert.That(_end is null || move.Start == _end);
            _end = move.End;
            return null;
        }
    }
}
