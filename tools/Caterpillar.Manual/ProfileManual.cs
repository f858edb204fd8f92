using System.Collections.Generic;
using System.Linq;
using System.Text;
using Caterpillar.Machines;

namespace Caterpillar.Manual;

/// <summary>The manual of the profiles, <c>docs/profiles.md</c>, made from the table of keys.</summary>
internal static class ProfileManual
{
    /// <summary>The page as Markdown.</summary>
    public static string Write(ProfileLibrary library, SettingDocs docs)
    {
        var text = new StringBuilder();
        text.Append(
            """
            # Printers, materials and settings

            <!-- Made from the table of keys: CATERPILLAR_RENEW=1 ./test.sh rewrites it. -->

            A print needs three profiles: a **printer** (its build volume, its limits, the style of its G-code), a **material**
            (what is extruded) and **settings** (how it is printed). They are JSON files with one key per line; keys include
            their unit. They live in `printers/`, `printers/materials/` and `printers/settings/`, come with the library,
            and profiles in a folder of your own override them
            (`~/.config/Caterpillar/printers` in the terminal; `%APPDATA%\Caterpillar\printers` on Windows).

            ```
            caterpillar printers                    # all profiles
            caterpillar printers ender3             # one of them with all its keys, a starting point for your own
            caterpillar printers --import HEADER FOOTER -o mine.json    # a printer from two files of G-code, such as those of ExtruderTurtle
            caterpillar slice part.stl --printer ender3 --material petg --settings fine --set layer_height_mm=0.15
            ```

            `--printer`, `--material` and `--settings` take a name or a file; without them the printer is `generic`, and material and settings are those that
            the printer names. `--set key=value` changes any
            key of the three; lists are written with commas (`build_volume_mm=300,300,400`), lists of lists also with semicolons.

            A profile may begin with `"inherits": "name"` and states only what differs; your profile may inherit the
            built-in one of the same name. Keys that do not exist, keys with another unit (`layer_height_cm`) and values
            outside their range are errors that name file, line and key.


            """);
        Keys(text, docs, "Printer", ProfileKeys.Printer, library.PrinterNames);
        Keys(text, docs, "Material", ProfileKeys.Material, library.MaterialNames);
        Keys(text, docs, "Settings", ProfileKeys.Settings, library.SettingsNames);
        text.Append(
            """
            ## Templates

            `start_gcode` and `end_gcode` are the lines before and after the print, `layer_change_gcode` those before each layer except the first,
            `tool_change_gcode` those for a tool change. Braces contain any key of
            the three profiles, any name from the list below, or a formula of these (`{min(print_max_z_mm + 10, bed_max_z_mm)}`); `{{` and `}}` are literal
            braces. Numbers are written with up to five decimals.

            ```
            {if bed_temperature_c > 0}
            M190 S{bed_temperature_c} ; wait for the bed
            {elsif nozzle_temperature_c > 0}
            G4 S10
            {else}
            ; nothing is heated
            {endif}
            ```

            A line with only a directive gives no line. A wrong name is an error with the line and column of the template. After the start code
            Caterpillar states its own modes (`G90`, then
            `M82` or `M83`, and `G92 E0` if E is absolute), so a template cannot leave the print in the wrong ones.


            """);
        text.Append("| name | meaning |\n|---|---|\n");
        foreach (var name in PrintTemplate.Names) text.Append("| `").Append(name.Key).Append("` | ").Append(name.Value).Append(" |\n");
        return text.ToString();
    }

    private static void Keys(StringBuilder text, SettingDocs docs, string title, IReadOnlyList<ProfileKey> keys, IEnumerable<string> names)
    {
        text.Append("## ").Append(title).Append("\n\nProfiles: ").Append(string.Join(", ", names.Select(n => "`" + n + "`")))
            .Append(".\n\n| key | meaning | range |\n|---|---|---|\n");
        foreach (var key in keys) text.Append("| `").Append(key.Name).Append("` | ").Append(docs[key].Sentence).Append(" | ").Append(key.Range).Append(" |\n");
        text.Append('\n');
    }
}
