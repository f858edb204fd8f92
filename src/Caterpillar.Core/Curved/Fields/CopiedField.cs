namespace Caterpillar.Curved;

/// <summary>The field of a part for its copies as well: each place has the field of the nearest copy.</summary>
internal sealed class CopiedField : WrappedField
{
    private readonly IReadOnlyList<NamedMesh> _copies;
    private readonly Footprint[] _outlines;
    private readonly Vec3[] _shifts;

    public CopiedField(LayerField inner, IReadOnlyList<NamedMesh> copies) : base(inner)
    {
        _copies = copies;
        _outlines = copies.Select(c => Footprint.Of(c.Mesh)).ToArray();
        _shifts = copies.Select(c => c.Placed.Shift - copies[0].Placed.Shift).ToArray();
    }

    internal override Func<Vec3, Vec3>? Side => Inner.Side is { } side ? point => side(point - ShiftAt(point.X, point.Y)) : null;

    internal override double Spread(Vec3 point) => Inner.Spread(point - ShiftAt(point.X, point.Y));

    internal override LayerField ForPartial() => new CopiedField(Inner.ForPartial(), _copies);

    internal override LayerField FitTo(PartColumns part, PrintSettings settings, DiagnosticList problems)
        => new CopiedField(Inner.FitTo(PartColumns.Of([_copies[0].Mesh]), settings, problems), _copies);

    internal override TriMesh? FlatMesh(TriMesh mesh)
    {
        var copy = _copies.ToList().FindIndex(c => ReferenceEquals(c.Mesh, mesh));
        return copy < 0 ? null : Inner.FlatMesh(_copies[0].Mesh)?.Moved(_shifts[copy]);
    }

    internal override SheetField? Sheet => Inner.Sheet;

    internal override (SheetField Field, Vec3 Shift)? SheetOf(TriMesh mesh)
    {
        var copy = _copies.ToList().FindIndex(c => ReferenceEquals(c.Mesh, mesh));
        return copy < 0 ? Inner.SheetOf(mesh) : Inner.SheetOf(_copies[0].Mesh) is var (field, _) ? (field, _shifts[copy]) : null;
    }

    public override double Value(Vec3 point) => Inner.Value(point - ShiftAt(point.X, point.Y));

    public override double Height(double x, double y, double value)
    {
        var shift = ShiftAt(x, y);
        return Inner.Height(x - shift.X, y - shift.Y, value);
    }

    public override bool Covers(double x, double y)
    {
        var shift = ShiftAt(x, y);
        return Inner.Covers(x - shift.X, y - shift.Y);
    }

    public override Vec3 Normal(Vec3 point) => Inner.Normal(point - ShiftAt(point.X, point.Y));

    internal override (double First, double Second) Heights(double x, double y, double first, double second)
    {
        var shift = ShiftAt(x, y);
        return Inner.Heights(x - shift.X, y - shift.Y, first, second);
    }

    private Vec3 ShiftAt(double x, double y)
    {
        var place = new Footprint([new Vec3(x, y)], 0);
        var (best, least) = (0, double.PositiveInfinity);
        for (var i = 0; i < _outlines.Length; i++)
        {
            // Outlines are looked at only where boxes do not tell.
            if (!place.IsApart(_outlines[i], least) && _outlines[i].Separation(place) is var away && away < least) (best, least) = (i, away);
        }
        return _shifts[best];
    }
}
