namespace Caterpillar.GCode;

/// <summary>Changes of moves in a conversion: the unit and the mode of E, arcs, letters. An edit changes none of them.</summary>
internal sealed class MoveConversion(SpliceContext context)
{
    private readonly ConvertTarget? _target = context.Target;
    private readonly ParsedLine _line = context.Line;
    private bool _diameterStated;

    public double ChordTolerance => _target?.Options.ChordTolerance ?? 0.01;

    public bool ExpandArcs => _target is { Options.ExpandArcs: true };

    /// <summary>The move with E in the unit of the target, and with the effect of M221 if the target reads it differently.</summary>
    public TargetMove Scale(TargetMove move)
    {
        if (_target is null || move.E == 0) return move;
        var e = move.E;
        var (from, to) = (context.Read.State.Extrusion.Flow, context.Written.State.Extrusion.Flow);
        if (from != to && context.Read.LastMoves.Count == 1) e += context.Read.LastMoves.Deposited[0] * (1 / to - 1 / from);
        return move with { E = e * _target.Factor(move.Tool) };
    }

    /// <summary>True for a move in place in a target without E: nothing of it is left.</summary>
    public bool IsLost(TargetMove move)
        => context.Extruder == 0 && _target is not null && context.Decoding.Axis.HasAmounts
            && move.Kind is MoveKind.Retract or MoveKind.Deretract or MoveKind.Prime;

    /// <summary>True if the target reads words of the line differently, or not at all, although the move is the same.</summary>
    public bool MustRewrite()
    {
        if (_target is null) return false;
        if (ExpandArcs && context.Read.LastArc is not null) return true;
        if (_target.Millimeters && context.Read.State.Modes.Inches) return true;
        return context.Axis != context.Decoding.Axis && HasExtruderWord();
    }

    /// <summary>True if the current line has a word that extrudes in the file.</summary>
    public bool HasExtruderWord()
    {
        var from = context.Decoding.Axis;
        return from == ExtrusionAxis.Both ? _line.Find('A') >= 0 || _line.Find('B') >= 0 : from.Letter != 0 && _line.Find((char)from.Letter) >= 0;
    }

    /// <summary>Writes the mode of E of the target (otherwise of the file) if another mode is active, and once that E is a volume.</summary>
    public void StateModeOfE(double e)
    {
        if (_target is null || e == 0 || context.Extruder == 0) return;
        if (_target.StatedDiameter is { } diameter && !_diameterStated)
        {
            _diameterStated = true;
            context.Command("M200 D" + SpliceContext.Format(diameter));
        }
        var modes = context.Written.State.Modes;
        var relative = _target.Options.RelativeE ?? context.Read.State.Modes.RelativeE;
        if (modes.RelativeE == relative || context.Rules.RelativeE == RelativeERule.OnlyG90G91) return;
        // In G91 most firmwares take E as relative whatever M82 says.
        if (!relative && context.Rules.RelativeE == RelativeERule.EitherG91OrM83 && modes.Relative) return;
        context.Command(relative ? "M83" : "M82");
    }
}
