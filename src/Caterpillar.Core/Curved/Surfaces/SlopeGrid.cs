namespace Caterpillar.Curved;

/// <summary>A grid of nodes in plan, on which heights change by no more than a slope allows: distances are those of steps between near nodes.</summary>
/// <param name="Corner">The first node, mm.</param>
/// <param name="Cell">Distance of nodes, mm.</param>
/// <param name="Columns">Nodes along X.</param>
/// <param name="Rows">Nodes along Y.</param>
internal sealed record SlopeGrid(Vec3 Corner, double Cell, int Columns, int Rows)
{
    /// <summary>Distances along steps between nodes are longer than straight ones by up to this factor (Borgefors 1986, masks of 5 × 5).</summary>
    public const double Detour = 1.028;

    // Steps to the nodes that come before one in the order of rows.
    private static readonly (int X, int Y, double Length)[] Steps
        = [(-1, 0, 1), (-1, -1, Math.Sqrt(2)), (0, -1, 1), (1, -1, Math.Sqrt(2)),
            (-2, -1, Math.Sqrt(5)), (2, -1, Math.Sqrt(5)), (-1, -2, Math.Sqrt(5)), (1, -2, Math.Sqrt(5))];

    public int Count => Columns * Rows;

    /// <summary>The grid over a part, with a margin.</summary>
    /// <param name="bounds">The part, mm.</param>
    /// <param name="nodes">Maximum number of nodes.</param>
    public static SlopeGrid Over(Bounds bounds, double nodes)
    {
        const double Finest = 0.4;
        var cell = Math.Max(Finest, Math.Sqrt(bounds.Size.X * bounds.Size.Y / nodes));
        return new SlopeGrid(bounds.Min - new Vec3(2.5 * cell, 2.5 * cell), cell, (int)(bounds.Size.X / cell) + 6, (int)(bounds.Size.Y / cell) + 6);
    }

    public Vec3 At(int node) => new(Corner.X + node % Columns * Cell, Corner.Y + node / Columns * Cell);

    /// <summary>The node before a place along both axes, and how far toward the next ones it is, 0 to 1. Places outside move onto the edge.</summary>
    public (int Node, double U, double V) Locate(double x, double y)
    {
        var u = Math.Max(0, Math.Min(Columns - 1.001, (x - Corner.X) / Cell));
        var v = Math.Max(0, Math.Min(Rows - 1.001, (y - Corner.Y) / Cell));
        int i = (int)u, j = (int)v;
        return (j * Columns + i, u - i, v - j);
    }

    /// <summary>The value at a place between nodes, linear along both axes.</summary>
    /// <param name="values">One for each node.</param>
    /// <param name="place">From <see cref="Locate"/>.</param>
    public double Between(double[] values, (int Node, double U, double V) place)
    {
        int near = place.Node, far = near + Columns;
        var low = values[near] + (values[near + 1] - values[near]) * place.U;
        var high = values[far] + (values[far + 1] - values[far]) * place.U;
        return low + (high - low) * place.V;
    }

    /// <summary>Goes from nodes outward, step by step to the next ones along both axes.</summary>
    /// <param name="first">Where to begin.</param>
    /// <param name="enter">Called with a node and one next to it: whether to go on from there.</param>
    public void Grow(IEnumerable<int> first, Func<int, int, bool> enter)
    {
        var front = new Queue<int>(first);
        while (front.Count > 0)
        {
            var n = front.Dequeue();
            int column = n % Columns, row = n / Columns;
            if (column > 0 && enter(n, n - 1)) front.Enqueue(n - 1);
            if (column + 1 < Columns && enter(n, n + 1)) front.Enqueue(n + 1);
            if (row > 0 && enter(n, n - Columns)) front.Enqueue(n - Columns);
            if (row + 1 < Rows && enter(n, n + Columns)) front.Enqueue(n + Columns);
        }
    }

    /// <summary>The highest surface below given heights that nowhere rises faster than a slope, mm per mm.</summary>
    public void Lower(double[] heights, double slope)
    {
        var rises = Array.ConvertAll(Steps, step => slope * Cell * step.Length);
        for (var y = 0; y < Rows; y++)
        {
            for (var x = 0; x < Columns; x++) Lower(heights, x, y, 1, rises);
        }
        for (var y = Rows - 1; y >= 0; y--)
        {
            for (var x = Columns - 1; x >= 0; x--) Lower(heights, x, y, -1, rises);
        }
    }

    private void Lower(double[] heights, int x, int y, int sign, double[] rises)
    {
        var height = heights[y * Columns + x];
        for (var k = 0; k < rises.Length; k++)
        {
            int i = x + sign * Steps[k].X, j = y + sign * Steps[k].Y;
            if (i < 0 || j < 0 || i >= Columns || j >= Rows) continue;
            var reached = heights[j * Columns + i] + rises[k];
            if (reached < height) height = reached;
        }
        heights[y * Columns + x] = height;
    }
}
