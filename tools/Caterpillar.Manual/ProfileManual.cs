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

            Your print needs three profiles: a **printer** (build volume, limits, G-code format), a **material** and **settings** (how to print).
            This page lists every key with its range.

            - **On the canvas** you choose profiles in the menus of *Print Setup*. To change single values, place *Printer*, *Material* or
              *Print Settings*. Zoom in, press a small +, and name the new port after the key.
            - **In the terminal**, `--printer`, `--material` and `--settings` take a name or a file. `--set key=value` changes any key of the three.
              Write lists with commas (`build_volume_mm=300,300,400`), and lists of lists with semicolons between them.

            ```
            caterpillar printers                    # all profiles
            caterpillar printers ender3             # all keys of a profile, to start your own
            caterpillar slice part.stl --printer ender3 --material petg --settings fine --set layer_height_mm=0.15
            ```

            If you name none, the printer is `generic`. Material and settings are those that the printer names.

            ## Files

            Profiles are JSON files with one key per line. Keys end in their unit. The built-in ones are in `printers/`, `printers/materials/` and
            `printers/settings/`. Your own are in `Caterpillar/printers` of your application data ([Printers](printers.md#add-a-printer)), and
            replace built-in ones of the same name.

            A profile may begin with `"inherits": "name"`. Then it contains only the keys that differ, and yours may inherit the built-in one of
            the same name. Unknown keys, keys with another unit (`layer_height_cm`) and values out of range are errors that name file, line and key.
            If you know the name in PrusaSlicer, OrcaSlicer or Cura, find the key in [Names in other slicers](names.md).

            Sizes that are 0 or not given follow from the nozzle: `line_width_mm` is 112.5 % of its diameter, `layer_height_mm` and
            `first_layer_height_mm` are half of it. So `--set nozzle_diameter_mm=0.8` alone gives you lines of 0.9 mm and layers of 0.4 mm.
            Widths of extrusions (keys in `line_width_mm`, `min_wall_width_mm`, `max_wall_width_mm`) are in mm, or in % of the nozzle diameter:
            `"outer_wall_line_width_mm": "120%"`.


            """);
        Keys(text, docs, "Printer", ProfileKeys.Of<Printer>(), library.Names<Printer>());
        Keys(text, docs, "Material", ProfileKeys.Of<Material>(), library.Names<Material>());
        Keys(text, docs, "Settings", ProfileKeys.Of<PrintSettings>(), library.Names<PrintSettings>());
        text.Append(
            """
            ## Templates

            Your start and end code can use values of the print. `start_gcode` and `end_gcode` are the lines before and after the print. The lines of
            `layer_change_gcode` come before each layer except the first, and those of `tool_change_gcode` for a tool change.

            Braces contain any key of the three profiles, any name from the list below, or a formula (`{min(print_max_z_mm + 10, bed_max_z_mm)}`).
            `{{` and `}}` are literal braces. Numbers have up to five decimals. Keys of materials are those of tool 0, and in `tool_change_gcode`
            those of the new tool.

            ```
            {if bed_temperature_c > 0}
            M190 S{bed_temperature_c} ; wait for the bed
            {elsif nozzle_temperature_c > 0}
            G4 S10
            {else}
            ; nothing is heated
            {endif}
            ```

            A line with only a directive gives no line. An unknown name is an error with line and column of the template. A template cannot leave
            the print in the wrong modes: after the start code Caterpillar writes its own (`G90`, then `M82` or `M83`, and `G92 E0` if E is absolute).


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
