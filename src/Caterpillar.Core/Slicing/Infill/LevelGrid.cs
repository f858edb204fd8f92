namespace Caterpillar.Slicing;

/// <summary>
/// Values of a field on a square grid whose step is halved until no curve reaches over an edge and back by more than the tolerance without being seen at a
/// node.
/// </summary>
internal sealed class LevelGrid
{
    private const int MaxNodes = 4_000_000;

    public double[] Values = [];

    public int Columns { get; private set; }

    public int Rows { get; private set; }

    public double Step { get; private set; }

    private double _x;
    private double _y;

    public void Sample(LevelField field, Bounds box, double spacing, double width)
    {
        // Twice as fine as what is tested, a whole part of a mm where the spacing is large.
        Step = Math.Min(spacing / 4, 0.5);
        while (true)
        {
            Evaluate(field, box);
            if (Step <= Math.Min(width / 4, field.Tolerance * 4) || 4.0 * Columns * Rows > MaxNodes || !Hides(field)) return;
            Step /= 2;
        }
    }

    public Vec3 Node(int column, int row) => new(_x + column * Step, _y + row * Step);

    private void Evaluate(LevelField field, Bounds box)
    {
        // Nodes are multiples of the step, so that layers share them. A step so small that they would be too many is made larger.
        while (((box.Max.X - box.Min.X) / Step + 4) * ((box.Max.Y - box.Min.Y) / Step + 4) > MaxNodes) Step *= 2;
        double left = Math.Floor(box.Min.X / Step) - 1, bottom = Math.Floor(box.Min.Y / Step) - 1;
        Columns = (int)(Math.Ceiling(box.Max.X / Step) - left) + 2;
        Rows = (int)(Math.Ceiling(box.Max.Y / Step) - bottom) + 2;
        (_x, _y) = (left * Step, bottom * Step);
        if (Values.Length < Columns * Rows) Values = new double[Columns * Rows];
        for (var j = 0; j < Rows; j++)
        {
            for (var i = 0; i < Columns; i++) Values[j * Columns + i] = field.At(_x + i * Step, _y + j * Step);
        }
    }

    // On the grid of twice the step, is there an edge with equal signs at its ends and another sign, clearly, in its middle? On this grid it would be a quarter
    // as deep.
    private bool Hides(LevelField field)
    {
        for (var j = 1; j + 1 < Rows; j++)
        {
            for (var i = 1; i + 1 < Columns; i++)
            {
                var n = j * Columns + i;
                var middle = Values[n];
                var negative = middle < 0;
                var row = (j & 1) == 0 && (i & 1) == 1 && Values[n - 1] < 0 != negative && Values[n + 1] < 0 != negative;
                var column = (i & 1) == 0 && (j & 1) == 1 && Values[n - Columns] < 0 != negative && Values[n + Columns] < 0 != negative;
                if (!row && !column) continue;
                double dx = Values[n + 1] - Values[n - 1], dy = Values[n + Columns] - Values[n - Columns];
                var slope = Math.Sqrt(dx * dx + dy * dy) / (2 * Step);
                if (Math.Abs(middle) > 4 * field.Tolerance * slope) return true;
            }
        }
        return false;
    }
}
