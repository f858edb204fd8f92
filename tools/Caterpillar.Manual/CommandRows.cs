using System.Collections.Generic;
using System.Linq;
using System.Text;
using Caterpillar.Basics;
using Caterpillar.Flavors;

namespace Caterpillar.Manual;

/// <summary>The table of all commands in <c>docs/gcode.md</c>, made from <see cref="CommandTable"/>.</summary>
internal static class CommandRows
{
    private static readonly string[] Uses =
    [
        "ok: harmless.", "tracked: the decoder follows it.", "untracked: moves the head or shifts its coordinates, and the decoder does not follow it.",
        "start: only before the print. Within it an error.", "end: only after the print. Within it an error.", "pause: waits with a hot nozzle. A note.",
        "never: moves unpredictably, or loses position, scale or heat. Within the print an error, elsewhere a note.",
        "depends: on the configuration of the machine. A note.", "ignored: unknown to the firmware, which ignores it.",
    ];

    /// <summary>Adds the table.</summary>
    public static void Write(StringBuilder text)
    {
        text.Append("\n## All commands\n\nEvery command of every flavor, what it does, and what it means in a print (between the first extrusion of the first "
            + "layer and the last extrusion):\n\n");
        foreach (var use in Uses) text.Append("- ").Append(use).Append('\n');
        text.Append("\nOf several rows for a command, the first that fits counts: `S0` is S with the value 0, `!Z` is without Z, `~x` is the text x. "
            + "`buddy` is Marlin 2 of the Prusa MK4, XL and Mini, `fluidnc` is Grbl of FluidNC.\n");
        text.Append("Macros of a printer are declared by its key `macros`. What is in no row is not understood: `check` warns, and a writer refuses it.\n\n");
        text.Append("| command | flavors | acts on | in a print | effect | source |\n|---|---|---|---|---|---|\n");
        foreach (var row in CommandTable.Rows)
        {
            var first = row.Commands[0];
            string[] cells =
            [
                string.Join(", ", row.Commands.Select(Code)), string.Join(", ", row.Flavors), Words.Spaced(first.Class.ToString()),
                first.Use.ToString().ToLowerInvariant(), first.Effect, first.Source,
            ];
            text.Append("| ").Append(string.Join(" | ", cells)).Append(" |\n");
        }
        text.Append('\n');
        foreach (var source in CommandTable.Sources) text.Append("- ").Append(source.Key).Append(": ").Append(source.Value).Append('\n');
    }

    /// <summary>A command with the words that it needs.</summary>
    public static string Code(FlavorCommand command) => "`" + (command.Name + " " + command.When).TrimEnd() + "`";
}
