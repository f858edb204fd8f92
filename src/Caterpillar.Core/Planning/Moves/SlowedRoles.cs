namespace Caterpillar.Planning;

/// <summary>Roles that are printed more slowly than requested because of the maximum volumetric flow.</summary>
internal sealed class SlowedRoles
{
    private static readonly int Roles = Enum.GetValues(typeof(Role)).Length;
    private readonly double[] _wanted = new double[Roles];
    private readonly double[] _least = new double[Roles];
    private readonly int[] _moves = new int[Roles];

    private double _limit = double.PositiveInfinity;

    /// <summary>A move of a role at a lower speed than wanted, mm/s, because of a maximum flow, mm³/s.</summary>
    public void Add(Role role, double wanted, double speed, double limit)
    {
        if (!(speed < wanted)) return;
        _limit = Math.Min(_limit, limit);
        var i = (int)role;
        if (_moves[i]++ == 0 || speed < _least[i]) (_wanted[i], _least[i]) = (wanted, speed);
    }

    /// <summary>One note that names the roles and their lowest speeds.</summary>
    /// <param name="diagnostics">Where to add it.</param>
    public void Report(DiagnosticList diagnostics)
    {
        var parts = new List<string>();
        var moves = 0;
        for (var i = 0; i < Roles; i++)
        {
            if (_moves[i] == 0) continue;
            moves += _moves[i];
            parts.Add($"{Named((Role)i)} from {NumberFormatter.Format(_wanted[i], 1)} to {NumberFormatter.Format(_least[i], 1)} mm/s");
        }
        if (moves == 0) return;
        diagnostics.Add(Severity.Note, "plan.flow_slowed",
            $"Printing is slowed down to the maximum volumetric flow of {NumberFormatter.Format(_limit, 2)} mm³/s: {string.Join(", ", parts)}.", null,
                moves);
    }

    private static string Named(Role role) => role == Role.Unspecified ? "paths" : Words.Snake(role.ToString()).Replace('_', ' ');
}
