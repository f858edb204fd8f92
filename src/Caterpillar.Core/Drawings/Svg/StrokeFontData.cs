namespace Caterpillar.Drawings;

/// <summary>The shapes of <see cref="StrokeFont"/>: a digit for the width, then strokes. Points of strokes are a digit for x and a letter for y.</summary>
internal static class StrokeFontData
{
    /// <summary>The middle of the marks, in the units of the letters.</summary>
    public const double MarkCenter = 3;

    // From the space to the tilde.
    private static readonly string[] Ascii =
    [
        "4", "10q0i 0f0e", "30q0n 3q3n", "82e3q 5e6q 0i8i 0m8m", "88o6q2q0o0m2k6k8i8g6e2e0g 4d4r", "80e8q 1q0p0n1m2m3n3p2q1q 6i5h5f6e7e8f8h7i6i",
        "88e2n2p3q4q5p5n0i0g2e4e8i", "10q0n", "22r0n0g2c", "20r2n2g0c", "63g3o 0i6m 0m6i", "63f3l 0i6i", "11f1e0c", "60i6i", "10e0f", "60d6r",
        "62e0g0o2q4q6o6g4e2e", "40o2q2e 0e4e", "60o2q4q6o6m0e6e", "60o2q4q6o6m4k6i6g4e2e0g 4k2k", "64e4q0h6h", "66q0q0k4k6i6g4e2e0g",
        "66o4q2q0o0g2e4e6g6i4k2k0i", "60q6q2e", "62k0m0o2q4q6o6m4k2k0i0g2e4e6g6i4k", "60g2e4e6g6o4q2q0o0m2k4k6m", "10e0f 0k0l", "11f1e0c 1k1l",
        "66n0i6d", "60g6g 0k6k", "60n6i0d", "60o2q4q6o6m3k3i 3f3e", "86h5g4g3h3k4l5l6k6h7g8h8m6p3p0m0h3e7e", "80e4q8e 1h7h",
        "80e0q5q7o7m5k0k 5k8i8g6e0e", "88o6q2q0o0g2e6e8g", "80e0q5q8n8h5e0e", "77e0e0q7q 0k5k", "70e0q7q 0k5k", "88o6q2q0o0g2e6e8g8k5k",
        "80e0q 8e8q 0k8k", "40e4e 2e2q 0q4q", "66q6g4e2e0g", "80e0q 8q0i 3l8e", "60q0e6e", "80e0q4k8q8e", "80e0q8e8q", "82e0g0o2q6q8o8g6e2e",
        "80e0q6q8o8m6k0k", "82e0g0o2q6q8o8g6e2e 5h8e", "80e0q6q8o8m6k0k 4k8e", "88o6q2q0o0m2k6k8i8g6e2e0g", "84e4q 0q8q", "80q0g2e6e8g8q", "80q4e8q",
        "80q2e4k6e8q", "80e8q 0q8e", "80q4k8q 4k4e", "80q8q0e8e", "22r0r0c2c", "60r6d", "20r2r2c0c", "60m3q6m", "60c6c", "20q2o",
        "66e6m 6k4m2m0k0g2e4e6g", "60q0e 0g2e4e6g6k4m2m0k", "66l4m2m0k0g2e4e6f", "66q6e 6g4e2e0g0k2m4m6k", "60i6i6k4m2m0k0g2e4e6f", "41e1o3q4q 0m3m",
        "66m6c4a2a0b 6g4e2e0g0k2m4m6k", "60e0q 0k2m4m6k6e", "10e0m 0o0p", "33m3c1a0a 3o3p", "60e0q 6m0g 3j6e", "20q0g2e",
        "80e0m 0k1m3m4k4e 4k5m7m8k8e", "60e0m 0k2m4m6k6e", "62e0g0k2m4m6k6g4e2e", "60m0a 0g2e4e6g6k4m2m0k", "66m6a 6g4e2e0g0k2m4m6k", "40e0m 0k2m4m",
        "66l4m2m0k2i4i6g4e2e0f", "41q1g2e4e 0m4m", "60m0g2e4e6g 6m6e", "60m3e6m", "80m2e4k6e8m", "60e6m 0m6e", "60m3e 6m1a0a", "60m6m0e6e",
        "33r1q1l0i1f1d3c", "10r0c", "30r2q2l3i2f2d0c", "60h1j2j4h5h6j",
    ];

    // Each letter with an accent, the letter, and the accent.
    private const string Composed =
        "ÀA`ÁA'ÂA^ÃA~ÄA:ÅAoÇC,ÈE`ÉE'ÊE^ËE:ÌI`ÍI'ÎI^ÏI:ÑN~ÒO`ÓO'ÔO^ÕO~ÖO:ÙU`ÚU'ÛU^ÜU:ÝY'àa`áa'âa^ãa~äa:åaoçc,èe`ée'êe^ëe:"
        + "ìi`íi'îi^ïi:ñn~òo`óo'ôo^õo~öo:ùu`úu'ûu^üu:ýy'ÿy:ĀA-āa-ĂAuăauĄA,ąa,ĆC'ćc'ĈC^ĉc^ĊC.ċc.ČCvčcvĎDvďdvĒE-ēe-ĔEuĕeuĖE."
        + "ėe.ĘE,ęe,ĚEvěevĜG^ĝg^ĞGuğguĠG.ġg.ĢG,ģg,ĤH^ĥh^ĨI~ĩi~ĪI-īi-ĬIuĭiuĮI,įi,İI.ĴJ^ĵj^ĶK,ķk,ĹL'ĺl'ĻL,ļl,ĽLvľlvŃN'ńn'ŅN,"
        + "ņn,ŇNvňnvŌO-ōo-ŎOuŏouŐO\"őo\"ŔR'ŕr'ŖR,ŗr,ŘRvřrvŚS'śs'ŜS^ŝs^ŞS,şs,ŠSvšsvŢT,ţt,ŤTvťtvŨU~ũu~ŪU-ūu-ŬUuŭuuŮUoůuoŰU\""
        + "űu\"ŲU,ųu,ŴW^ŵw^ŶY^ŷy^ŸY:ŹZ'źz'ŻZ.żz.ŽZvžzv";

    /// <summary>The shape of a character. Empty = no shape.</summary>
    public static string Glyph(char character) => character switch
    {
        >= ' ' and <= '~' => Ascii[character - ' '],
        '\u00A0' => Ascii[0],
        '\u00DF' => "60e0o2q4q6o4k6i6g4e2e",
        '\u00D8' => "82e0g0o2q6q8o8g6e2e 0d8r",
        '\u00F8' => "62e0g0k2m4m6k6g4e2e 0d6n",
        '\u00B0' => "41m0n0p1q3q4p4n3m1m",
        '\u00B7' => "10i0j",
        '\u00D7' => "61g5k 5g1k",
        '\u2013' or '\u2212' => "60i6i",
        '\u2014' => "80i8i",
        '\u2018' or '\u2019' => "10q0n",
        '\u201C' or '\u201D' => "30q0n 3q3n",
        _ => "",
    };

    /// <summary>The letter below an accent, or null for other characters.</summary>
    public static (char Letter, char Mark)? Accented(char character)
    {
        if (character is < '\u00C0' or > '\u017F') return null;
        for (var i = 0; i < Composed.Length; i += 3)
        {
            if (Composed[i] == character) return (Composed[i + 1], Composed[i + 2]);
        }
        return null;
    }

    /// <summary>The shape of an accent above a letter of height 0, or below the baseline.</summary>
    public static string Mark(char mark) => mark switch
    {
        '`' => "2h4f",
        '\'' => "2f4h",
        '"' => "1f2h 4f5h",
        '^' => "1f3h5f",
        'v' => "1h3f5h",
        '~' => "0f2h4f6h",
        ':' => "1f1g 5f5g",
        'o' => "3f2g3h4g3f",
        'u' => "1h2f4f5h",
        '-' => "1g5g",
        '.' => "3f3g",
        _ => "3e4c2b",
    };
}
