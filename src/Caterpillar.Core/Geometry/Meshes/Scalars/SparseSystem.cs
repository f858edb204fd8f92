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
    /// <param name="size">Rows.</param>
    /// <param name="entries">Row and column of each off-diagonal entry, both halves of the matrix.</param>
    /// <param name="values">Their values.</param>
    /// <param name="diagonal">The diagonal.</param>
    public SparseSystem(int size, (int Row, int Column)[] entries, double[] values, double[] diagonal)
    {
        _starts = new int[size + 1];
        foreach (var (row, _) in entries) _starts[row + 1]++;
        for (var i = 0; i < size; i++) _starts[i + 1] += _starts[i];
        _columns = new int[entries.Length];
        _values = new double[entries.Length];
        var next = (int[])_starts.Clone();
        for (var k = 0; k < entries.Length; k++)
        {
            var at = next[entries[k].Row]++;
            _columns[at] = entries[k].Column;
            _values[at] = values[k];
        }
        _diagonal = diagonal;
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
        for (var i = 0; i < x.Length; i++)
        {
            var sum = _diagonal[i] * x[i];
            for (var k = _starts[i]; k < _starts[i + 1]; k++) sum += _values[k] * x[_columns[k]];
            result[i] = sum;
        }
    }
}
