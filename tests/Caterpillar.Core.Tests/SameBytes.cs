using System;
using System.Text;
using NUnit.Framework.Constraints;

namespace Caterpillar.Tests;

/// <summary>The same bytes, compared in plain code: <c>Is.EqualTo</c> takes as long for one byte as this does for a thousand.</summary>
internal sealed class SameBytes : Constraint
{
    private readonly byte[] _expected;

    private SameBytes(byte[] expected)
    {
        _expected = expected;
        Description = expected.Length + " given bytes";
    }

    public static SameBytes As(byte[] expected) => new(expected);

    public override ConstraintResult ApplyTo<TActual>(TActual actual)
    {
        if (actual is not byte[] bytes) return new ConstraintResult(this, actual, false);
        var at = 0;
        while (at < bytes.Length && at < _expected.Length && bytes[at] == _expected[at]) at++;
        var isSame = at == bytes.Length && at == _expected.Length;
        return isSame ? new ConstraintResult(this, actual, true)
            : new ConstraintResult(this, $"{bytes.Length} bytes, another at {at}: {Near(bytes, at)} instead of {Near(_expected, at)}", false);
    }

    // Some bytes before and after the difference, as text.
    private static string Near(byte[] bytes, int at)
    {
        var from = Math.Max(0, at - 40);
        return "\"" + Encoding.GetEncoding(28591).GetString(bytes, from, Math.Min(bytes.Length, at + 40) - from) + "\"";
    }
}
