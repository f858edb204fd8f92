namespace Caterpillar.GH.Components.Slice;

/// <summary>Makes the recipe of a field from the ports of Layer Field.</summary>
internal sealed class FieldPorts(Run run, List<Diagnostic> problems)
{
    private static readonly SourceLocation Expressions = new(Key: "expressions");

    /// <summary>The recipe. Null after problems.</summary>
    /// <exception cref="InputProblem">Inputs contradict each other.</exception>
    public FieldRecipe? Read()
    {
        var kind = run.Choice<FieldKind>(0);
        var texts = run.List<GH_String>(run["Expressions"]).Select(t => t.Value.Trim()).ToArray();
        var origin = run.MaybePoint(run["Origin"]);
        switch (kind)
        {
            case FieldKind.Vertical: return Vertical(Only(Plans()));
            case FieldKind.Normal: return Normal();
            case FieldKind.Between: return Between(Plans());
            case FieldKind.Formula:
                if (texts.Length != 1) throw new InputProblem("Formula needs exactly one expression.");
                var level = LayerField.Formula(texts[0], Affine.Move(origin ?? Vec3.Zero), Expressions);
                return Accept(level) is { } formula ? new FieldRecipe("Formula " + texts[0], [origin], formula) : null;
            case FieldKind.Cone: return Cone(origin);
            case FieldKind.Overhangs: return Overhangs();
            case FieldKind.Smooth: return new FieldRecipe("Smooth", [], (models, setup, _) => LayerField.Smooth(models, setup));
            case FieldKind.Deformed:
                if (texts.Length != 3) throw new InputProblem("Deformed needs three expressions: the bent x, y and z.");
                var bent = LayerField.Deformed(texts[0], texts[1], texts[2], Affine.Move(origin ?? Vec3.Zero), Expressions);
                return Accept(bent) is { } deformed ? new FieldRecipe("Deformed " + string.Join("; ", texts), [origin], deformed) : null;
            case FieldKind.Harmonic or FieldKind.Geodesic: return BetweenEnds(kind);
            default: throw new InputProblem("Kind is not a kind of field.");
        }
    }

    private FieldRecipe? Vertical(Plan? plan)
    {
        if (plan is null) return null;
        var (from, to) = (Number("Blend From") ?? 0, Number("Blend To"));
        if (to is null && from != 0) throw new InputProblem("Blend From needs Blend To.");
        if (to is { } end && !(from >= 0 && end > from)) throw new InputProblem("Blend To must be greater than Blend From, and Blend From must be 0 or more.");
        LayerBlend? blend = to is { } top ? new LayerBlend(from, top) : null;
        return new FieldRecipe("Vertical", [plan.Key, from, to], (models, _, _) => new Result<LayerField>(LayerField.Vertical(plan.Make(models), blend), []));
    }

    private FieldRecipe Normal()
    {
        var meshes = Meshes();
        if (meshes.Length == 0) throw new InputProblem("Normal needs a surface.") { IsMissing = true };
        return new FieldRecipe("Normal", [.. meshes], LayerField.Offset(ModelMesh.Joined(meshes)!));
    }

    private FieldRecipe? Between(IReadOnlyList<Plan>? plans)
    {
        if (plans is null) return null;
        if (plans.Count == 0) throw new InputProblem("Between needs at least one surface.") { IsMissing = true };
        return new FieldRecipe("Between", [.. plans.Select(p => p.Key)], (models, _, _) =>
        {
            var surfaces = plans.Select(p => p.Make(models)).ToList();
            // One surface: from the bottom of the solids up to it.
            if (surfaces.Count == 1) surfaces.Insert(0, PlanSurface.Level(ModelPlacement.BoxOf(models).Min.Z));
            return new Result<LayerField>(LayerField.Between(surfaces.ToArray()), []);
        });
    }

    private FieldRecipe BetweenEnds(FieldKind kind)
    {
        var (upper, lower) = (Ends(run["Surfaces"]), Ends(run["Lower Boundaries"]));
        if (Numbers("Upper Vertices") is var ends && Numbers("Lower Vertices") is var starts && ends.Length + starts.Length > 0)
        {
            if (upper.Length + lower.Length > 0) throw new InputProblem("Give either vertices, or surfaces and curves.");
            return BetweenVertices(kind, ends, starts);
        }
        if (upper.Length == 0 && lower.Length > 0) throw new InputProblem("Lower Boundaries need Surfaces at which layers end.");
        return new FieldRecipe(kind.ToString(), [.. upper.Select(e => e.Key), "from", .. lower.Select(e => e.Key)], (models, _, _) =>
        {
            var part = TriMesh.Merge(models.Select(m => m.Mesh));
            var ends = upper.Length == 0 ? MeshBoundaries.Find(part)
                : MeshBoundaries.Near(part, lower.Length == 0 ? null : BoundaryShape.Of(lower.Select(e => e.Shape).ToArray()),
                    upper.Select(e => e.Shape).ToArray());
            return FieldOf(kind, ends);
        });
    }

    private static FieldRecipe BetweenVertices(FieldKind kind, int[] upper, int[] lower)
        => new(kind.ToString(), [string.Join(" ", upper), "from", string.Join(" ", lower)], (models, _, vertexAt) =>
        {
            if (models.Count != 1) return Missing("Boundaries by vertices need exactly one solid.");
            var mesh = models[0].Mesh;
            // Equal vertices are one in the library. Adding zero makes a negative zero positive.
            var places = mesh.Vertices.Select((v, i) => (v, i)).ToDictionary(p => p.v + Vec3.Zero, p => p.i);
            foreach (var number in upper.Concat(lower))
            {
                if (vertexAt(number) is not { } point || !places.ContainsKey(point + Vec3.Zero))
                    return Missing($"The solid has no vertex {NumberFormatter.Format(number)}.");
            }
            int[] Own(int[] numbers) => Array.ConvertAll(numbers, n => places[vertexAt(n)!.Value + Vec3.Zero]);
            return FieldOf(kind, MeshBoundaries.Of(mesh, Own(lower), Own(upper)));
        });

    private static Result<LayerField> FieldOf(FieldKind kind, Result<MeshBoundaries> ends) => new(
        ends.Value is not { } found ? null : kind == FieldKind.Harmonic ? LayerField.Harmonic(found) : LayerField.Geodesic(found), ends.Diagnostics);

    private static Result<LayerField> Missing(string message) => new(null, [new Diagnostic(Severity.Error, "curved.no_boundary", message)]);

    private int[] Numbers(string port) => run.List<GH_Integer>(run[port]).Select(n => n.Value).ToArray();

    // Curves and surfaces on the solids, with their keys.
    private (BoundaryShape Shape, object Key)[] Ends(int port)
    {
        var tolerance = run.Positive(run["Tolerance"]);
        return run.List<IGH_GeometricGoo>(port).Select(g =>
        {
            if (Wrapped.Bare(g.ScriptVariable()) is not Rg.Curve curve)
            {
                var mesh = run.ModelOf(g, tolerance);
                return (BoundaryShape.Of(mesh.Triangles), (object)mesh);
            }
            var chords = RhinoCurves.Chords(curve, tolerance, run.Units);
            return (BoundaryShape.Of([chords]), string.Join(" ", chords.Points));
        }).ToArray();
    }

    private FieldRecipe Cone(Vec3? axis)
    {
        var angle = Angle() ?? throw new InputProblem("Cone needs an angle.") { IsMissing = true };
        return new FieldRecipe($"Cone {NumberFormatter.Format(angle, 3)}°", [axis, angle], (models, _, _) => new Result<LayerField>(
            LayerField.Vertical(PlanSurface.Cone(axis ?? ModelPlacement.BoxOf(models).Center, angle)), []));
    }

    private FieldRecipe Overhangs()
    {
        var angle = Angle();
        return new FieldRecipe("Overhangs", [angle], (models, setup, _) =>
        {
            var plan = PlanSurface.AgainstOverhangs(models, setup, angle);
            return new Result<LayerField>(plan.Value is { } found ? LayerField.Vertical(found) : null, plan.Diagnostics);
        });
    }

    private double? Angle() => Number("Angle") switch
    {
        null => null,
        >= -80 and <= 80 and var angle => angle,
        _ => throw new InputProblem("Angle must be from -80 to 80 degrees."),
    };

    private double? Number(string port) => run.MaybeValue<double>(run[port]) is null ? null : run.Finite(run[port]);

    private static Plan? Only(IReadOnlyList<Plan>? plans) => plans switch
    {
        null => null,
        { Count: 1 } => plans[0],
        { Count: 0 } => throw new InputProblem("Vertical needs a surface, an expression for its height, or an image.") { IsMissing = true },
        _ => throw new InputProblem("Vertical needs exactly one surface. Use Between for several."),
    };

    /// <summary>The surfaces from geometry, formulas and the image, in this order. Null after problems.</summary>
    private List<Plan>? Plans()
    {
        var plans = new List<Plan>();
        var sources = run.Choices<SurfaceSource>(run["Sources"]) ?? [];
        var texts = sources.Contains(SurfaceSource.Formula) ? run.List<GH_String>(run["Heights"]).Select(t => t.Value.Trim()) : [];
        var origin = run.MaybePoint(run["Origin"]);
        foreach (var mesh in sources.Contains(SurfaceSource.Geometry) ? Meshes() : [])
        {
            var surface = PlanSurface.Of(mesh.Triangles);
            plans.Add(new Plan(mesh, _ => surface));
        }
        foreach (var text in texts)
        {
            if (Accept(PlanSurface.Formula(text, Expressions)) is not { } height) return null;
            var surface = height.Moved(origin ?? Vec3.Zero);
            plans.Add(new Plan((text, origin), _ => surface));
        }
        if (sources.Contains(SurfaceSource.HeightMap) && run.Maybe<string>(run["Image"]) is { Length: > 0 } name)
        {
            if (HeightMap(run.FileAt(name)) is not { } map) return null;
            plans.Add(map);
        }
        return plans;
    }

    private ModelMesh[] Meshes() => run.Models(run["Surfaces"], run.Positive(run["Tolerance"]));

    private Plan? HeightMap(FileInfo file)
    {
        var (low, high) = (run.Finite(run["Low"]), run.Finite(run["High"]));
        if (!(high >= low)) throw new InputProblem("High must not be less than Low.");
        var (path, written) = (file.FullName, file.LastWriteTimeUtc);
        if (Accept(run.Cached([path, written], () => ImageReader.Read(path))) is not { } image) return null;
        return new Plan((path, written, low, high), models =>
        {
            var box = ModelPlacement.BoxOf(models);
            return PlanSurface.HeightMap(image, new Bounds(box.Min.WithZ(low), box.Max.WithZ(high)));
        });
    }

    private T? Accept<T>(Result<T> result)
        where T : class
    {
        problems.AddRange(result.Diagnostics);
        return result.HasErrors ? null : result.Value;
    }

    /// <summary>A surface that may depend on the models, and a key for it.</summary>
    private sealed record Plan(object Key, Func<IReadOnlyList<NamedMesh>, PlanSurface> Make);
}
