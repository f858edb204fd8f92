namespace Caterpillar.Curved;

/// <summary>Problems found while paths were lifted back into the part. Reports of layers are merged in order.</summary>
internal sealed class LiftReport
{
    /// <summary>Pieces steeper than the head allows, in degrees.</summary>
    public Spot Steep { get; } = new();

    /// <summary>Pieces below the bed or inside the object printed on, in mm.</summary>
    public Spot Below { get; } = new();

    /// <summary>Pieces beyond the plan.</summary>
    public Spot Uncovered { get; } = new();

    /// <summary>Pieces that another layer prints, several layers at once.</summary>
    public Spot Thin { get; } = new();

    public void Add(LiftReport other)
    {
        Steep.Add(other.Steep);
        Below.Add(other.Below);
        Uncovered.Add(other.Uncovered);
        Thin.Add(other.Thin);
    }

    /// <summary>Pieces of one kind: their length, and the worst of them.</summary>
    public sealed class Spot
    {
        /// <summary>mm.</summary>
        public double Length { get; private set; }

        public double Worst { get; private set; } = double.NegativeInfinity;

        public Vec3 Place { get; private set; }

        public void Note(double length, double value, Vec3 place)
        {
            Length += length;
            if (!(value > Worst)) return;
            Worst = value;
            Place = place;
        }

        public void Add(Spot other) => Note(other.Length, other.Worst, other.Place);
    }
}
