namespace Caterpillar.Geometry;

/// <summary>
/// A sparse symmetric system of equations with a positive definite matrix, solved by conjugate gradients with a diagonal preconditioner. Rows are compressed.
/// </summary>
internal sealed class SparseSystem
{
    private readonly int[] _starts;
    private readonly int[] _columns;
    private readonly double[] _values;
    private readonly double[] _diagonal;

    /// <summary>A matrix of entries in any order; those of one place add up.</summary>
    /// <param name="entries">Each off-diagonal entry of one half of the matrix; its other half is the same.</param>
    /// <param name="diagonal">The diagonal.</param>
    public SparseSystem(IReadOnlyCollection<(int Row, int Column, double Value)> entries, double[] diagonal)
    {
        _diagonal = diagonal;
        _starts = new int[diagonal.Length + 1];
        foreach (var (row, column, _) in entries) (_starts[row + 1], _starts[column + 1]) = (_starts[row + 1] + 1, _starts[column + 1] + 1);
        for (var i = 0; i < diagonal.Length; i++) _starts[i + 1] += _starts[i];
        (_columns, _values) = (new int[2 * entries.Count], new double[2 * entries.Count]);
        var next = (int[])_starts.Clone();
        foreach (var (row, column, value) in entries)
        {
            Put(row, column, value);
            Put(column, row, value);
        }

        void Put(int row, int column, double value) => (_columns[next[row]], _values[next[row]++]) = (column, value);
    }

    /// <summary>Solves for a right side, beginning with a guess, which becomes the solution.</summary>
    /// <param name="right">The right side.</param>
    /// <param name="x">The guess, and the result.</param>
    /// <param name="accuracy">The rest of the equations in parts of the right side.</param>
    /// <param name="cancel">Cancels the call.</param>
    /// <returns>False if it did not converge.</returns>
    public bool Solve(double[] right, double[] x, double accuracy, CancellationToken cancel)
    {
        var n = x.Length;
        double[] rest = new double[n], direction = new double[n], image = new double[n];
        Multiply(x, image);
        double squareRight = 0, rho = 0;
        for (var i = 0; i < n; i++)
        {
            rest[i] = right[i] - image[i];
            direction[i] = rest[i] / _diagonal[i];
            rho += rest[i] * direction[i];
            squareRight += right[i] * right[i] / _diagonal[i];
        }
        var goal = accuracy * accuracy * Math.Max(squareRight, 1e-300);
        var most = 20 * (int)Math.Sqrt(n) + 1000;
        for (var step = 0; step < most && rho > goal; step++)
        {
            if (step % 16 == 0) cancel.ThrowIfCancellationRequested();
            Multiply(direction, image);
            var bend = 0.0;
            for (var i = 0; i < n; i++) bend += direction[i] * image[i];
            if (!(bend > 0)) break;
            var length = rho / bend;
            var next = 0.0;
            for (var i = 0; i < n; i++)
            {
                x[i] += length * direction[i];
                rest[i] -= length * image[i];
                next += rest[i] * rest[i] / _diagonal[i];
            }
            var share = next / rho;
            rho = next;
            for (var i = 0; i < n; i++) direction[i] = rest[i] / _diagonal[i] + share * direction[i];
        }
        return rho <= goal;
    }

    private void Multiply(double[] x, double[] result)
    {
        const int Block = 4096;
        Parallel.For(0, (x.Length + Block - 1) / Block, block =>
        {
            var end = Math.Min(x.Length, (block + 1) * Block);
            for (var i = block * Block; i < end; i++)
            {
                var sum = _diagonal[i] * x[i];
                for (var k = _starts[i]; k < _starts[i + 1]; k++) sum += _values[k] * x[_columns[k]];
                result[i] = sum;
            }
        });
    }
}
