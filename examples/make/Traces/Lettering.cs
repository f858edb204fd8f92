using System;
using System.Collections.Generic;
using Caterpillar.Files;
using Caterpillar.Shaping;

namespace Caterpillar.Examples;

/// <summary>Capital letters of 5 × 7 dots, white on black, with an empty column after each letter and an empty row above and below.</summary>
internal static class Lettering
{
    private static readonly Dictionary<char, string[]> Dots = new()
    {
        ['A'] = [".###.", "#...#", "#...#", "#####", "#...#", "#...#", "#...#"],
        ['C'] = [".###.", "#...#", "#....", "#....", "#....", "#...#", ".###."],
        ['E'] = ["#####", "#....", "#....", "####.", "#....", "#....", "#####"],
        ['I'] = [".###.", "..#..", "..#..", "..#..", "..#..", "..#..", ".###."],
        ['L'] = ["#....", "#....", "#....", "#....", "#....", "#....", "#####"],
        ['P'] = ["####.", "#...#", "#...#", "####.", "#....", "#....", "#...."],
        ['R'] = ["####.", "#...#", "#...#", "####.", "#.#..", "#..#.", "#...#"],
        ['T'] = ["#####", "..#..", "..#..", "..#..", "..#..", "..#..", "..#.."],
        [' '] = [".....", ".....", ".....", ".....", ".....", ".....", "....."],
    };

    public static GrayImage Draw(string text)
    {
        int width = 6 * text.Length, height = 9;
        var pixels = new double[width * height];
        for (var letter = 0; letter < text.Length; letter++)
        {
            if (!Dots.TryGetValue(text[letter], out var rows)) throw new ArgumentException("Unknown letter: " + text[letter], nameof(text));
            for (var y = 0; y < 7; y++)
            {
                for (var x = 0; x < 5; x++) pixels[(y + 1) * width + 6 * letter + x] = rows[y][x] == '#' ? 1 : 0;
            }
        }
        return new GrayImage(width, height, pixels);
    }
}
