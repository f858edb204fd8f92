namespace Caterpillar.Toolpaths;

/// <summary>A coordinate of a path.</summary>
public enum PathAxis : byte
{
    X,
    Y,
    Z,
}

/// <summary>The word of a rotary axis in G-code.</summary>
public enum RotaryWord : byte
{
    A,
    B,
    C,
}

/// <summary>
/// A rotary axis of a machine. A positive word turns the tool against the work counterclockwise, seen from the plus end of the axis (ISO 841), whether the
/// head turns or the work.
/// </summary>
/// <param name="Word">Its word in G-code.</param>
/// <param name="TurnsWork">It turns the work; otherwise the head.</param>
/// <param name="About">Its direction at rest.</param>
/// <param name="Point">A point of it, mm: of an axis of the head from the tip at zero, of an axis of the work in the coordinates of the machine.</param>
public sealed record RotaryAxis(RotaryWord Word, bool TurnsWork, PathAxis About, Vec3 Point)
{
    /// <summary>True for a machine that counts the other way.</summary>
    public bool IsReversed { get; init; }

    /// <summary>Minimum of the word, degrees; minus infinity for an axis without end.</summary>
    public double Min { get; init; } = double.NegativeInfinity;

    /// <summary>Maximum of the word, degrees; infinity for an axis without end.</summary>
    public double Max { get; init; } = double.PositiveInfinity;

    /// <summary>Maximum speed, degrees/s; infinity if unknown.</summary>
    public double MaxSpeed { get; init; } = double.PositiveInfinity;

    /// <summary>Maximum acceleration, degrees/s²; infinity if unknown.</summary>
    public double MaxAcceleration { get; init; } = double.PositiveInfinity;

    /// <summary>
    /// Reads <c>B head y at 0 0 42 from -110 to 110 speed 60 acceleration 1000</c>: what follows the direction may be left out, and <c>-y</c> counts in
    /// the other direction. Null if the text is invalid.
    /// </summary>
    public static RotaryAxis? Parse(string text)
    {
        var words = (text ?? throw new ArgumentNullException(nameof(text))).Split([' '], StringSplitOptions.RemoveEmptyEntries);
        if (words.Length < 3 || words[0].Length != 1 || words[1] is not ("head" or "work")) return null;
        var reversed = words[2].StartsWith("-", StringComparison.Ordinal);
        var word = "ABC".IndexOf(words[0], StringComparison.OrdinalIgnoreCase);
        var about = "xyz".IndexOf(words[2].Substring(reversed ? 1 : 0), StringComparison.Ordinal);
        if (word < 0 || about < 0 || words[2].Length != (reversed ? 2 : 1)) return null;
        var axis = new RotaryAxis((RotaryWord)word, words[1] == "work", (PathAxis)about, Vec3.Zero) { IsReversed = reversed };
        for (var i = 3; i < words.Length; i++)
        {
            var name = words[i];
            var numbers = new double[name == "at" ? 3 : 1];
            for (var k = 0; k < numbers.Length; k++)
            {
                if (++i >= words.Length || !NumberReader.TryParse(words[i], out numbers[k]) || !(Math.Abs(numbers[k]) < 1e6)) return null;
            }
            switch (name)
            {
                case "at": axis = axis with { Point = new Vec3(numbers[0], numbers[1], numbers[2]) }; break;
                case "from": axis = axis with { Min = numbers[0] }; break;
                case "to": axis = axis with { Max = numbers[0] }; break;
                case "speed" when numbers[0] > 0: axis = axis with { MaxSpeed = numbers[0] }; break;
                case "acceleration" when numbers[0] > 0: axis = axis with { MaxAcceleration = numbers[0] }; break;
                default: return null;
            }
        }
        return axis.Min < axis.Max ? axis : null;
    }

    /// <summary>The text that <see cref="Parse"/> reads.</summary>
    public override string ToString()
    {
        static string Text(double value) => NumberFormatter.Format(value, 6);
        static string Part(string name, double value) => double.IsInfinity(value) ? "" : $" {name} {Text(value)}";
        var at = Point == Vec3.Zero ? "" : $" at {Text(Point.X)} {Text(Point.Y)} {Text(Point.Z)}";
        return $"{Word} {(TurnsWork ? "work" : "head")} {(IsReversed ? "-" : "")}{"xyz"[(int)About]}{at}"
            + Part("from", Min) + Part("to", Max) + Part("speed", MaxSpeed) + Part("acceleration", MaxAcceleration);
    }

    /// <summary>The word of this axis among A, B and C, degrees.</summary>
    internal double Of(Vec3 words) => Word switch { RotaryWord.A => words.X, RotaryWord.B => words.Y, _ => words.Z };

    /// <summary>The words with another value of this axis.</summary>
    internal Vec3 With(Vec3 words, double value) => Word switch
    {
        RotaryWord.A => new Vec3(value, words.Y, words.Z),
        RotaryWord.B => new Vec3(words.X, value, words.Z),
        _ => new Vec3(words.X, words.Y, value),
    };

    /// <summary>The angle by which the tool turns against the work, degrees.</summary>
    internal double Angle(Vec3 words) => IsReversed ? -Of(words) : Of(words);

    /// <summary>The word for such an angle, degrees.</summary>
    internal Vec3 WithAngle(Vec3 words, double angle) => With(words, IsReversed ? -angle : angle);

    /// <summary>A vector turned about the direction of the axis, degrees.</summary>
    internal Vec3 Turned(Vec3 v, double angle)
    {
        var (sin, cos) = Basics.Angle.SinCos(angle);
        return About switch
        {
            PathAxis.X => new Vec3(v.X, v.Y * cos - v.Z * sin, v.Y * sin + v.Z * cos),
            PathAxis.Y => new Vec3(v.X * cos + v.Z * sin, v.Y, v.Z * cos - v.X * sin),
            _ => new Vec3(v.X * cos - v.Y * sin, v.X * sin + v.Y * cos, v.Z),
        };
    }
}
