using System;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using NUnit.Framework;

namespace Caterpillar.Tests.Basics;

public class AngleTests
{
    [Test]
    public void Right_angles_are_exact()
    {
        for (var k = -8; k <= 8; k++)
        {
            var (sin, cos) = Angle.SinCos(90 * k);
            var quarter = ((k % 4) + 4) % 4;
            Assert.That(sin, Is.EqualTo(quarter == 1 ? 1 : quarter == 3 ? -1 : 0));
            Assert.That(cos, Is.EqualTo(quarter == 0 ? 1 : quarter == 2 ? -1 : 0));
        }
    }

    [TestCase(30, 0.5)]
    [TestCase(150, 0.5)]
    [TestCase(210, -0.5)]
    [TestCase(330, -0.5)]
    [TestCase(-30, -0.5)]
    [TestCase(390, 0.5)]
    public void Multiples_of_30_degrees_are_exact(double degrees, double sin)
    {
        Assert.That(Angle.Sin(degrees), Is.EqualTo(sin));
        Assert.That(Angle.Cos(degrees - 90), Is.EqualTo(sin));
    }

    [Test]
    public void Sine_and_cosine_agree_with_the_runtime_to_the_last_place()
    {
        var random = new Random(3);
        for (var i = 0; i < 100_000; i++)
        {
            var degrees = (random.NextDouble() - 0.5) * 720;
            var (sin, cos) = Angle.SinCos(degrees);
            var isSame = Math.Abs(sin - Math.Sin(degrees / 180 * Math.PI)) <= 1.5e-15 && Math.Abs(cos - Math.Cos(degrees / 180 * Math.PI)) <= 1.5e-15;
            if (!isSame || !(Math.Abs(sin * sin + cos * cos - 1) <= 3e-16)) Assert.Fail($"{degrees} degrees: {sin} and {cos}");
        }
    }

    [Test]
    public void Ten_million_degrees_lose_nothing() => Assert.That(Angle.Sin(360e6 + 17), Is.EqualTo(Angle.Sin(17)));

    [TestCase(0, 1, 0)]
    [TestCase(1, 0, 90)]
    [TestCase(0, -1, 180)]
    [TestCase(-1, 0, -90)]
    [TestCase(1, 1, 45)]
    [TestCase(-1, -1, -135)]
    [TestCase(0, 0, 0)]
    public void The_angle_of_a_vector_is_exact_on_the_axes(double y, double x, double degrees)
        => Assert.That(Angle.Atan2(y, x), Is.EqualTo(degrees));

    [Test]
    public void A_million_turns_keep_a_frame_orthonormal()
    {
        var random = new Random(11);
        var frame = Frame.World;
        for (var i = 0; i < 1_000_000; i++)
        {
            var a = random.NextDouble() * 360;
            frame = (i % 3) switch { 0 => frame.Yaw(a), 1 => frame.Pitch(a), _ => frame.Roll(a) };
        }
        Assert.That(frame.X.Length, Is.EqualTo(1).Within(1e-12));
        Assert.That(frame.Y.Length, Is.EqualTo(1).Within(1e-12));
        Assert.That(Vec3.Dot(frame.X, frame.Y), Is.EqualTo(0).Within(1e-12));
        Assert.That(frame.Z.DistanceTo(Vec3.Cross(frame.X, frame.Y)), Is.EqualTo(0).Within(1e-12));
    }

    [Test]
    public void Yaw_turns_left_pitch_raises_the_nose_and_roll_raises_the_left_side()
    {
        Assert.That(Frame.World.Yaw(90).X, Is.EqualTo(Vec3.UnitY));
        Assert.That(Frame.World.Pitch(90).X, Is.EqualTo(Vec3.UnitZ));
        Assert.That(Frame.World.Pitch(90).Z, Is.EqualTo(-Vec3.UnitX));
        Assert.That(Frame.World.Roll(90).Y, Is.EqualTo(Vec3.UnitZ));
        Assert.That(Frame.World.Roll(90).X, Is.EqualTo(Vec3.UnitX));
    }
}
