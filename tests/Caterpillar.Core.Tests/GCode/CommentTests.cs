using System;
using System.Linq;
using System.Text;
using Caterpillar.GCode;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.GCode;

/// <summary>What single comments of slicers mean.</summary>
public class CommentTests
{
    [TestCase(";LAYER:12", 12, double.NaN)]
    [TestCase(";LAYER:-3", -3, double.NaN)]
    [TestCase(";LAYER 3", 3, double.NaN)]
    [TestCase("; Layer 3", 3, double.NaN)]
    [TestCase("; layer 12, Z = 0.300", 12, 0.3)]
    [TestCase("; layer 12, Z = x", 12, double.NaN)]
    [TestCase("; layer 12, Z = 1e9", 12, 1.0)]
    [TestCase("; layer x", null, double.NaN)]
    [TestCase(";LAYER:999999999", 999_999_999, double.NaN)]
    [TestCase(";LAYER:1000000000", null, double.NaN)]
    [TestCase(";LAYER:-1000000000", null, double.NaN)]
    public void Numbers_of_layers_are_read(string text, int? number, double z)
    {
        var meaning = Read(text);
        Assert.That(meaning.Kind, Is.EqualTo(number is null ? CommentKind.None : CommentKind.LayerNumber));
        if (number is { } known) Assert.That((meaning.Number, meaning.Z), Is.EqualTo((known, z)));
    }

    [TestCase(";Z:0.2", CommentKind.Z, 0.2)]
    [TestCase(";Z: .2  ", CommentKind.Z, 0.2)]
    [TestCase("; Z_HEIGHT: 0.2", CommentKind.Z, 0.2)]
    [TestCase(";HEIGHT:0.25", CommentKind.Height, 0.25)]
    [TestCase("; LAYER_HEIGHT: 0.25", CommentKind.Height, 0.25)]
    [TestCase(";Z:999999999", CommentKind.Z, 999_999_999.0)]
    [TestCase(";Z:1e9", CommentKind.None, 0)]
    [TestCase(";Z:-1e9", CommentKind.None, 0)]
    [TestCase(";Z:", CommentKind.None, 0)]
    [TestCase(";WIDTH:0.4", CommentKind.None, 0)]
    [TestCase(";WIPE_START = 1", CommentKind.None, 0)]
    public void Heights_are_read(string text, object kind, double value)
    {
        var meaning = Read(text);
        Assert.That((meaning.Kind, meaning.Z, meaning.Height), Is.EqualTo(((CommentKind)kind, value, value)));
    }

    [TestCase("; BEGIN_LAYER_OBJECT z=0.30 z_thickness=0.25", 0.3, 0.25)]
    [TestCase("; BEGIN_LAYER_OBJECT z=0.30", 0.3, 0)]
    [TestCase("; BEGIN_LAYER_OBJECT z_thickness=0.25 z=0.30", 0.3, 0.25)]
    [TestCase("; BEGIN_LAYER_OBJECT z=x z_thickness=0", double.NaN, 0)]
    [TestCase("; BEGIN_LAYER_OBJECT z=1000000000", double.NaN, 0)]
    [TestCase("; BEGIN_LAYER_OBJECT", double.NaN, 0)]
    public void Layers_of_objects_state_their_height_and_thickness(string text, double z, double thickness)
    {
        var meaning = Read(text);
        Assert.That((meaning.Kind, meaning.Number, meaning.Z, meaning.Height), Is.EqualTo((CommentKind.LayerChange, 1, z, thickness)));
        foreach (var plain in new[] { ";LAYER_CHANGE", "; CHANGE_LAYER" })
            Assert.That((Read(plain).Kind, Read(plain).Number), Is.EqualTo((CommentKind.LayerChange, 0)));
    }

    [TestCase(";MESH:cube.stl", CommentKind.ObjectStart, "cube.stl")]
    [TestCase(";MESH:NONMESH", CommentKind.ObjectEnd, null)]
    [TestCase("; printing object A id:0 copy 0", CommentKind.ObjectStart, "A id:0 copy 0")]
    [TestCase("; stop printing object A", CommentKind.ObjectEnd, null)]
    [TestCase("; start printing object, unique label id: 5", CommentKind.ObjectStart, "unique label id: 5")]
    [TestCase("; thumbnail begin 16x16 100", CommentKind.Thumbnail, "thumbnail begin 16x16 100")]
    [TestCase("; thumbnails = 16x16", CommentKind.Setting, "thumbnails")]
    [TestCase("; feature = 5", CommentKind.Setting, "feature")]
    [TestCase("; Feature = 5", CommentKind.Setting, "Feature")]
    [TestCase("; a = b", CommentKind.Setting, "a")]
    [TestCase("; a =b", CommentKind.Setting, "a")]
    [TestCase("; a=b", CommentKind.None, null)]
    [TestCase("; a =", CommentKind.None, null)]
    [TestCase(";", CommentKind.None, null)]
    [TestCase(";  \t ", CommentKind.None, null)]
    public void Objects_settings_and_images_are_named(string text, object kind, string? name)
        => Assert.That((Read(text).Kind, Read(text).Text), Is.EqualTo(((CommentKind)kind, name)));

    [Test]
    public void Long_comments_are_cut_or_no_settings()
    {
        string Long(int n) => new('x', n);
        Assert.That(Read(";MESH:" + Long(200)).Text, Has.Length.EqualTo(200));
        Assert.That(Read(";MESH:" + Long(201)).Text, Has.Length.EqualTo(200));
        // The sign of equality stands among the first 80 characters.
        Assert.That(Read(";" + Long(78) + " = 1").Kind, Is.EqualTo(CommentKind.Setting));
        Assert.That(Read(";" + Long(79) + " = 1").Kind, Is.EqualTo(CommentKind.None));
        Assert.That(Read("; a = " + Long(5000)).Value, Has.Length.EqualTo(4094), "with the space before it");
        Assert.That(Read("; thumbnail " + Long(69)).Kind, Is.EqualTo(CommentKind.Thumbnail));
        Assert.That(Read("; thumbnail " + Long(70)).Kind, Is.EqualTo(CommentKind.None));
        Assert.That(Read(";TYPE:" + Long(60)).Kind, Is.EqualTo(CommentKind.Role));
        Assert.That(Read(";TYPE:" + Long(61)).Kind, Is.EqualTo(CommentKind.None));
        Assert.That(CommentReader.NextLayer(Encoding.ASCII.GetBytes("; move to next layer (12)"), 0, 25), Is.EqualTo(12));
        Assert.That(CommentReader.NextLayer(Encoding.ASCII.GetBytes("; move to next layer (1e9"), 0, 25), Is.EqualTo(1));
        Assert.That(CommentReader.NextLayer(Encoding.ASCII.GetBytes("; move to next layer (-2)"), 0, 25), Is.EqualTo(-1));
        Assert.That(CommentReader.NextLayer(Encoding.ASCII.GetBytes("; move to next layer (x)"), 0, 24), Is.EqualTo(-1));
    }

    [TestCase(Role.OuterWall, "WALL-OUTER, External perimeter, Outer wall, outer perimeter, External perimeters, Perimeter Path, Outer Perimeter Path, Thin "
        + "wall")]
    [TestCase(Role.InnerWall, "WALL-INNER, Perimeter, Internal perimeter, Inner wall, inner perimeter, Perimeters, Loop Path, single extrusion")]
    [TestCase(Role.OverhangWall, "Overhang perimeter, Overhang wall")]
    [TestCase(Role.Infill, "FILL, Internal infill, infill, Sparse infill, Sparse Infill Path, Stacked Sparse Infill Path, FILL-SPARSE")]
    [TestCase(Role.SolidInfill, "Solid infill, Internal solid infill, solid layer, SKIN, Solid Path, SOLID-FILL, solid fill, Solid, Floating vertical shell")]
    [TestCase(Role.TopSurface, "Top solid infill, Top surface, Crown Path, TOP-FILL, top solid fill, SKIN-TOP")]
    [TestCase(Role.BottomSurface, "Bottom surface, bottom solid infill, BOTTOM-FILL, SKIN-BOTTOM")]
    [TestCase(Role.Bridge, "Bridge infill, Internal bridge infill, bridge, Internal Bridge, BRIDGE-INFILL")]
    [TestCase(Role.GapFill, "Gap fill, Gap infill, GAP-FILL, gap")]
    [TestCase(Role.Ironing, "Ironing")]
    [TestCase(Role.Skirt, "SKIRT, Skirt/Brim, Skirt Path, ooze shield")]
    [TestCase(Role.Brim, "Brim, Brim Path")]
    [TestCase(Role.Raft, "Raft, Raft Path")]
    [TestCase(Role.Support, "SUPPORT, Support material, Support (may Stack) Path, Support Path, Support transition, dense support material")]
    [TestCase(Role.SupportInterface, "SUPPORT-INTERFACE, Support material interface, Support interface, dense support, Support Interface Path")]
    [TestCase(Role.PrimeTower, "PRIME-TOWER, Wipe tower, Prime tower, prime pillar, Pillar Path, Prime Pillar Path, Purge, WIPE-TOWER")]
    [TestCase(Role.Purge, "Custom, start gcode, end gcode")]
    [TestCase(Role.Unspecified, "Unspecified, Unknown, Mixed, Travel, something else")]
    public void Roles_have_these_names(Role role, string names)
    {
        foreach (var name in names.Split([", "], StringSplitOptions.None))
        {
            foreach (var text in new[] { ";TYPE:" + name, "; FEATURE: " + name, "; feature " + name })
                Assert.That((Read(text).Kind, Read(text).Role), Is.EqualTo((CommentKind.Role, role)), text);
        }
        Assert.That(Read("; 'Perimeter Path', 0.4 [feed mm/s]").Role, Is.EqualTo(Role.OuterWall));
        Assert.That(Read("; 'Perimeter Path").Kind, Is.EqualTo(CommentKind.None));
        Assert.That(Read("; 'else'").Kind, Is.EqualTo(CommentKind.None));
    }

    [Test]
    public void Names_of_roles_that_are_written_are_read_again()
    {
        foreach (Role role in Enum.GetValues(typeof(Role)))
            Assert.That(Read(";TYPE:" + RoleNames.Of(role)).Role, Is.EqualTo(role));
    }

    private static CommentMeaning Read(string text) => CommentReader.Read(Encoding.UTF8.GetBytes(text), 0, Encoding.UTF8.GetByteCount(text));
}
