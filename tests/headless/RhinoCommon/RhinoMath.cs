using System;

namespace Rhino
{
    public enum UnitSystem : byte
    {
        None = 0,
        Microns = 1,
        Millimeters = 2,
        Centimeters = 3,
        Meters = 4,
        Kilometers = 5,
        Inches = 8,
        Feet = 9,
        Miles = 10,
        CustomUnits = 11,
        Unset = 255,
    }

    public static class RhinoMath
    {
        public const double ZeroTolerance = 2.3283064365386963E-10;
        public const double UnsetValue = -1.23432101234321E+308;
        public const double HalfPI = 1.5707963267948966;
        public const double TwoPI = 6.283185307179586;
        public const double Epsilon = 2.220446049250313E-16;
        public const double SqrtEpsilon = 1.490116119385E-08;

        public static double ToRadians(double degrees) => degrees * (Math.PI / 180.0);

        public static double ToDegrees(double radians) => radians * (180.0 / Math.PI);

        public static bool IsValidDouble(double x) => x != UnsetValue && !double.IsInfinity(x) && !double.IsNaN(x);

        public static double UnitScale(UnitSystem from, UnitSystem to)
        {
            if (from == UnitSystem.Unset || to == UnitSystem.Unset) return double.NaN;
            if (from == to || Micrometres(from) == 0 || Micrometres(to) == 0) return 1;
            return Micrometres(from) / Micrometres(to);
        }

        public static double MetersPerUnit(UnitSystem units) => Micrometres(units) == 0 ? 1 : Micrometres(units) / 1e6;

        private static double Micrometres(UnitSystem unit)
        {
            switch (unit)
            {
                case UnitSystem.Microns: return 1;
                case UnitSystem.Millimeters: return 1000;
                case UnitSystem.Centimeters: return 1e4;
                case UnitSystem.Meters: return 1e6;
                case UnitSystem.Kilometers: return 1e9;
                case UnitSystem.Inches: return 25400;
                case UnitSystem.Feet: return 304800;
                case UnitSystem.Miles: return 1609344000;
                default: return 0;
            }
        }
    }
}
