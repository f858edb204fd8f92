using System;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Machines;

public class ProfileRecordTests
{
    [Test]
    public void Values_out_of_range_are_rejected_with_the_key()
    {
        Assert.That(() => new PrintSettings { LayerHeight = -0.1 }, Throws.InstanceOf<ArgumentOutOfRangeException>().With.Message.Contains("layer_height_mm"));
        Assert.That(() => new PrintSettings { LayerHeight = double.NaN }, Throws.InstanceOf<ArgumentOutOfRangeException>());
        Assert.That(() => new Material { FlowRatio = -1 }, Throws.InstanceOf<ArgumentOutOfRangeException>().With.Message.Contains("flow_ratio"));
        Assert.That(() => new Printer { BuildVolume = new Vec3(200, 0, 200) },
            Throws.InstanceOf<ArgumentOutOfRangeException>().With.Message.Contains("build_volume_mm"));
        Assert.That(() => new Printer { HeadOutline = new ValueList<HeadPoint>(new HeadPoint(3, 0), new(2, 4)) },
            Throws.InstanceOf<ArgumentOutOfRangeException>());
        Assert.That(() => new Printer { StartGCode = new ValueList<string>("G28\nG1 Z5") }, Throws.InstanceOf<ArgumentOutOfRangeException>());
    }

    [Test]
    public void Profiles_compare_by_value()
    {
        Assert.That(new Printer { StartGCode = new ValueList<string>("G28") }, Is.EqualTo(new Printer { StartGCode = new ValueList<string>("G28") }));
        Assert.That(new Printer { StartGCode = new ValueList<string>("G28") }, Is.Not.EqualTo(new Printer()));
        Assert.That(new PrintSetup(), Is.EqualTo(new PrintSetup()));
    }

    [Test]
    public void The_space_of_a_centered_round_bed_is_a_cylinder()
    {
        var delta = new Printer { Origin = BedOrigin.Center, BedShape = BedShape.Round, BuildVolume = new Vec3(200, 200, 300) };
        Assert.That(delta.BuildBounds, Is.EqualTo(new Bounds(new Vec3(-100, -100, 0), new Vec3(100, 100, 300))));
        Assert.That(delta.CanReach(new Vec3(70, 70, 10)), Is.True);
        Assert.That(delta.CanReach(new Vec3(75, 75, 10)), Is.False);
        Assert.That(delta.CanReach(new Vec3(0, -100, 300)), Is.True);
        Assert.That(delta.CanReach(new Vec3(0, 0, 301)), Is.False);
    }

    [Test]
    public void Speeds_of_roles_fall_back_to_the_print_speed()
    {
        var settings = new PrintSettings { PrintSpeed = 50, OuterWallSpeed = 30, InfillSpeed = 0, FirstLayerSpeed = 20 };
        Assert.That(settings.SpeedOf(Role.OuterWall), Is.EqualTo(30));
        Assert.That(settings.SpeedOf(Role.Infill), Is.EqualTo(50));
        Assert.That(settings.SpeedOf(Role.InnerWall, firstLayer: true), Is.EqualTo(20));
        Assert.That((settings with { FirstLayerSpeed = 0 }).SpeedOf(Role.OuterWall, firstLayer: true), Is.EqualTo(30));
        Assert.That((settings with { FirstLayerSpeed = 40 }).SpeedOf(Role.OuterWall, firstLayer: true), Is.EqualTo(40));
        Assert.That((settings with { FirstLayerSpeed = 60 }).SpeedOf(Role.OuterWall, firstLayer: true), Is.EqualTo(50));
    }

    [Test]
    public void The_weaker_of_machine_and_material_limits_the_flow()
    {
        var setup = new PrintSetup { Printer = new Printer { MaxFlow = 12 }, Material = new Material { MaxFlow = 8 } };
        Assert.That(setup.MaxFlow, Is.EqualTo(8));
        Assert.That((setup with { Material = new Material() }).MaxFlow, Is.EqualTo(12));
        Assert.That((setup with { Material = new Material(), Printer = new Printer { MaxFlow = 0 } }).MaxFlow, Is.EqualTo(double.PositiveInfinity));
    }

    [TestCase(190, 190, 8)]
    [TestCase(210, 0, 11)]
    [TestCase(215, 210, 11)]
    [TestCase(210, 230, 11)]
    [TestCase(300, 300, 12)]
    public void The_most_flow_follows_the_temperatures(double temperature, double first, double flow)
    {
        var material = new Material
        {
            NozzleTemperature = temperature, FirstLayerNozzleTemperature = first, MaxFlow = 3, FlowLimits = new(new FlowLimit(200, 8), new(220, 14)),
        };
        Assert.That(new PrintSetup { Printer = new Printer { MaxFlow = 12 }, Material = material }.MaxFlow, Is.EqualTo(flow).Within(1e-12));
        Assert.That(() => new Material { FlowLimits = new(new FlowLimit(220, 8), new(200, 14)) }, Throws.InstanceOf<ArgumentOutOfRangeException>());
    }
}
