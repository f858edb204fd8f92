using System.Globalization;

namespace GH_IO.Types
{
    public struct GH_Point3D
    {
        public double x;
        public double y;
        public double z;

        public GH_Point3D(double nx, double ny, double nz)
        {
            x = nx;
            y = ny;
            z = nz;
        }
    }

    public struct GH_Plane
    {
        public GH_Point3D Origin;
        public GH_Point3D XAxis;
        public GH_Point3D YAxis;
    }

    public struct GH_Version
    {
        public int major;
        public int minor;
        public int revision;

        public GH_Version(int v_major, int v_minor, int v_revision)
        {
            major = v_major;
            minor = v_minor;
            revision = v_revision;
        }

        public override string ToString() => string.Format(CultureInfo.InvariantCulture, "{0}.{1}.{2:0000}", major, minor, revision);
    }

    public enum GH_Types
    {
        unset = 0,
        gh_bool = 1,
        gh_byte = 2,
        gh_int32 = 3,
        gh_int64 = 4,
        gh_single = 5,
        gh_double = 6,
        gh_decimal = 7,
        gh_date = 8,
        gh_guid = 9,
        gh_string = 10,
        gh_bytearray = 20,
        gh_doublearray = 21,
        gh_drawing_point = 30,
        gh_drawing_pointf = 31,
        gh_drawing_size = 32,
        gh_drawing_sizef = 33,
        gh_drawing_rectangle = 34,
        gh_drawing_rectanglef = 35,
        gh_drawing_color = 36,
        gh_drawing_bitmap = 37,
        gh_point2d = 50,
        gh_point3d = 51,
        gh_point4d = 52,
        gh_interval1d = 60,
        gh_interval2d = 61,
        gh_line = 70,
        gh_boundingbox = 71,
        gh_plane = 72,
        gh_version = 80,
    }
}
