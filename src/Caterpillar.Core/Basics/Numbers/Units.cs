namespace Caterpillar.Basics;

/// <summary>Units that files use besides millimeters.</summary>
internal static class Units
{
    public const double MmPerInch = 25.4;
}
