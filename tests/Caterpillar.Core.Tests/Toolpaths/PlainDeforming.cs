using System;
using Caterpillar.Geometry;
using Caterpillar.Shaping;
using Caterpillar.Toolpaths;

namespace Caterpillar.Tests;

/// <summary>Deforms toolpaths by a function of points.</summary>
internal static class PlainDeforming
{
    public static Toolpath Deform(this Toolpath toolpath, MoveFilter filter, Func<Vec3, Vec3> map, double tolerance = 0.01)
        => toolpath.Deform(filter, Deformation.Cartesian(p => map(p)), tolerance).OrThrow();
}
