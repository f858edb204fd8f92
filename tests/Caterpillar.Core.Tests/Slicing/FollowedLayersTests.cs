using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Slicing;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Slicing;

/// <summary>Layers that are given on as soon as they are finished are those of the result.</summary>
[Category("Runtime")]
public sealed class FollowedLayersTests
{
    private static readonly TriMesh[] Two = [Solids.Block(0, 0, 0, 12, 12, 16), Solids.Cone(0, 6, 9, 3).Moved(new Vec3(40, 0, 0))];

    private static IEnumerable<TestCaseData> Kinds()
    {
        yield return new TestCaseData(new PrintSettings(), true).SetArgDisplayNames("plain");
        yield return new TestCaseData(new PrintSettings { MinLayerTime = 60, MinPrintSpeed = 15 }, true).SetArgDisplayNames("slow layers");
        yield return new TestCaseData(new PrintSettings { RaftLayers = 3 }, true).SetArgDisplayNames("raft");
        yield return new TestCaseData(new PrintSettings { BrimWidth = 4, SkirtLoops = 2 }, true).SetArgDisplayNames("skirt and brim");
        // As soon as the supports are found.
        yield return new TestCaseData(new PrintSettings { Support = SupportKind.Grid }, null).SetArgDisplayNames("supports");
        yield return new TestCaseData(new PrintSettings { Support = SupportKind.Tree, SupportAngle = 10 }, null).SetArgDisplayNames("trees");
        yield return new TestCaseData(new PrintSettings { SpiralVase = true }, true).SetArgDisplayNames("vases");
        yield return new TestCaseData(new PrintSettings { SpiralVase = true, Support = SupportKind.Grid, BottomLayers = 0 }, null).SetArgDisplayNames("all");
        yield return new TestCaseData(new PrintSettings { PrintSequence = PrintSequence.ByObject }, false).SetArgDisplayNames("one after the other");
    }

    private static IEnumerable<TestCaseData> SomeKinds() => Rounds.Some(Kinds(), 3);

    [TestCaseSource(nameof(SomeKinds))]
    public void They_come_in_order_and_complete(PrintSettings settings, bool? early)
    {
        var models = Two.Select((m, i) => new SliceModel(new NamedMesh("m" + i, m), settings)).ToArray();
        var whole = PlanarSlicer.SliceEach(models, settings);
        foreach (var threads in new[] { 1, 2, 8 })
        {
            var followed = new List<SlicedLayer>();
            var share = 0.0;
            var first = double.NaN;
            var options = new SliceOptions
            {
                Threads = threads,
                Take = layers =>
                {
                    Assert.That(layers.Select(l => l.Layer.Z).Distinct().Count(), Is.EqualTo(1));
                    Assert.That(followed.Count == 0 || layers[0].Layer.Z != followed[followed.Count - 1].Layer.Z, "a height is complete");
                    if (followed.Count == 0) first = share;
                    followed.AddRange(layers);
                },
            };
            var result = PlanarSlicer.SliceEach(models, settings, options, new Reported(value => share = value));

            Assert.That(result.Diagnostics, Is.EqualTo(whole.Diagnostics));
            Assert.That(result.Value!.Layers.Select(l => l.Layer), Is.EqualTo(whole.Value!.Layers.Select(l => l.Layer)));
            Assert.That(result.Value.ToSteps(), Is.Empty, "they are gone");
            if (early is { } known) Assert.That(first < 0.9, Is.EqualTo(known));
            Assert.That(Told(followed.SelectMany(l => l.Steps)), Is.EqualTo(Told(whole.Value.ToSteps())));
        }
    }

    private static IEnumerable<(StepGroup?, Role, Layer?, int, Vec3, Vec3, double)> Told(IEnumerable<Step> steps)
        => steps.Cast<PathStep>().Select(s => (s.Group, s.Path.Role, s.Path.Layer, s.Path.Points.Count, s.Path.Start, s.Path.End, s.Path.BeadOf(0).Speed));

    private sealed class Reported(Action<double> hear) : IProgress<double>
    {
        public void Report(double value) => hear(value);
    }
}
