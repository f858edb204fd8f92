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

            On the canvas: [Print Setup](components/PrintSetup.md), [Deconstruct Setup](components/DeconstructSetup.md), [Printer](components/Printer.md),
            [Material](components/Material.md), [Print Settings](components/PrintSettings.md).

            A print needs three profiles: a **printer** (build volume, limits, G-code format), a **material** and **settings** (how to print).
            They are JSON files with one key per line. Keys end in their unit. The built-in profiles are in `printers/`, `printers/materials/` and
            `printers/settings/`. Profiles in your own folder override them
            (`~/.config/Caterpillar/printers` in the terminal; `%APPDATA%\Caterpillar\printers` on Windows).

            ```
            caterpillar printers                    # all profiles
            caterpillar printers ender3             # all keys of a profile, to start your own
            caterpillar printers --import old.ini -o mine               # those of another slicer
            caterpillar printers --import HEADER FOOTER -o mine.json    # a printer from two G-code files, as in ExtruderTurtle
            caterpillar slice part.stl --printer ender3 --material petg --settings fine --set layer_height_mm=0.15
            ```

            `--printer`, `--material` and `--settings` take a name or a file. The default printer is `generic`, with its default material and
            settings. `--set key=value` changes any key of the three. Write lists with commas (`build_volume_mm=300,300,400`), and lists of lists
            with semicolons between them.

            A profile may begin with `"inherits": "name"`. Then it contains only keys that differ. Your profile may inherit the built-in one of
            the same name. Unknown keys, keys with another unit (`layer_height_cm`) and values out of range are errors that name file, line and
            key. [Names in other slicers](names.md) lists the names of PrusaSlicer, OrcaSlicer and Cura for these keys.

            Sizes that are 0 or not given follow from the nozzle: `line_width_mm` is 112.5 % of its diameter, `layer_height_mm` and
            `first_layer_height_mm` are half of it. So `--set nozzle_diameter_mm=0.8` alone gives lines of 0.9 mm and layers of 0.4 mm.
            Widths of extrusions (keys in `line_width_mm`, `min_wall_width_mm`, `max_wall_width_mm`) are in mm, or in % of the nozzle diameter:
            `"outer_wall_line_width_mm": "120%"`.


            """);
        Keys(text, docs, "Printer", ProfileKeys.Printer, library.PrinterNames);
        Keys(text, docs, "Material", ProfileKeys.Material, library.MaterialNames);
        Keys(text, docs, "Settings", ProfileKeys.Settings, library.SettingsNames);
        text.Append(
            """
            ## Templates

            `start_gcode` and `end_gcode` are the lines before and after the print, `layer_change_gcode` those before each layer except the first,
            `tool_change_gcode` those for a tool change. Braces contain any key of the three profiles, any name from the list below, or a formula
            (`{min(print_max_z_mm + 10, bed_max_z_mm)}`). `{{` and `}}` are literal braces. Numbers are written with up to five decimals.
            Keys of materials are those of tool 0, in `tool_change_gcode` those of the new tool.

            ```
            {if bed_temperature_c > 0}
            M190 S{bed_temperature_c} ; wait for the bed
            {elsif nozzle_temperature_c > 0}
            G4 S10
            {else}
            ; nothing is heated
            {endif}
            ```

            A line with only a directive gives no line. An unknown name is an error with line and column of the template. After the start G-code
            Caterpillar writes its own modes (`G90`, then `M82` or `M83`, and `G92 E0` if E is absolute), so a template cannot leave the print in
            the wrong ones.


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
