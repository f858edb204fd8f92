
namespace Caterpillar.Cli;

/// <summary>Answers to options of other slicers, which are keys or options with other names here.</summary>
internal static class SlicerWords
{
    /// <summary>
    /// Words for a key with an example value, or for an option of a verb (* = any verb that has it). Names of keys in other slicers come from
    /// <see cref="SlicerName"/>.
    /// </summary>
    public static readonly (string Words, string Answer)[] Table =
    [
        ("support supports tree generate_support", "support=tree"),
        ("brim", "brim_width_mm=5"),
        ("raft", "raft_layers=3"),
        ("skirt", "skirt_loops=2"),
        ("infill fill infill_density density", "infill_density_percent=20"),
        ("infill_type pattern", "infill_pattern=gyroid"),
        ("wall walls perimeter shells", "wall_count=3"),
        ("spiral vase spiralize vase_mode", "spiral_vase=true"),
        ("layer layers quality", "layer_height_mm=0.2"),
        ("first_layer initial_layer_height", "first_layer_height_mm=0.25"),
        ("width", "line_width_mm=0.45"),
        ("speed print_speed", "print_speed_mm_s=60"),
        ("temp nozzle_temp hotend_temperature", "nozzle_temperature_c=215"),
        ("bed bed_temp", "bed_temperature_c=60"),
        ("nozzle nozzle_size", "nozzle_diameter_mm=0.4"),
        ("bed_size build_volume", "build_volume_mm=220,220,250"),
        ("firmware flavor", "gcode_flavor=klipper"),
        ("relative_e", "e_mode=relative"),
        ("fan fan_speed cooling", "max_fan_speed_percent=100"),
        ("retract retraction", "retraction_length_mm=0.8"),
        ("zhop hop", "z_hop_mm=0.4"),
        ("flow flow_rate flow_ratio", "flow_ratio=0.95"),
        ("seam", "seam_position=rear"),
        ("ironing", "ironing=true"),
        ("fuzzy", "fuzzy_skin_thickness_mm=0.3"),
        ("adaptive", "adaptive_layers=true"),
        ("elephant_foot", "elephant_foot_compensation_mm=0.2"),
        ("xy_compensation", "xy_size_compensation_mm=-0.1"),
        ("arcs fit_arcs", "arc_fitting_tolerance_mm=0.05"),
        ("sequential one_at_a_time", "print_sequence=by_object"),
        ("combing", "avoid_crossing_walls=true"),
        ("arachne", "variable_wall_width=true"),
        ("scarf seam_slope_type", "scarf_seam_length_mm=20"),
        ("repair fix", "repair_meshes=true"),
        ("duplicate count quantity", "slice --copies N"),
        ("scale_to_fit size", "slice --scale X,Y,Zmm"),
        ("rotate_x", "slice --rotate 90,0,0"),
        ("rotate_y", "slice --rotate 0,90,0"),
        ("rotate_z turn", "slice --rotate 90"),
        ("orient auto_orient", "slice --lay-flat"),
        ("dont_arrange", "slice --keep-position"),
        ("place position align_xy", "slice --center X,Y"),
        ("temperature_at_height temperature_at_layer temperature_tower temp_tower", "convert --gcode-at-layer \"N=M104 S210\""),
        ("gcode_at_height insert_at_layer", "convert --gcode-at-layer N=LINE"),
        ("color_change change_filament filament_change", "convert --gcode-at-layer N=M600"),
        ("pause pause_at_height pause_at", "convert --pause-at-layer N"),
        ("g gcode export_gcode out output_file outputdir", "* --output FILE"),
        ("l load config profile preset load_settings", "* --settings NAME"),
        ("filament filament_profile load_filaments", "* --material NAME"),
        ("machine printer_profile", "* --printer NAME"),
        ("time estimate print_time", "decode --stats"),
        ("help_fff list_keys", "printers --keys"),
        ("preview gcodeviewer show", "view --open"),
    ];

    /// <summary>A sentence with the key or option for a word of another slicer, or null.</summary>
    /// <param name="option">The unknown option.</param>
    /// <param name="value">The number that follows it, or null.</param>
    /// <param name="verb">The verb.</param>
    /// <param name="verbs">All verbs.</param>
    public static string? Advice(string option, string? value, Command verb, IEnumerable<Command> verbs)
    {
        var word = option.TrimStart('-').Replace('-', '_').ToLowerInvariant();
        var answer = Table.FirstOrDefault(t => t.Words.Split(' ').Contains(word)).Answer;
        if (answer is null && SlicerName.Answer(word, value) is { } name) (answer, value) = (ExampleOf(name.Key), value is null ? null : name.Value ?? "VALUE");
        else if (answer is null && KeyOf(word) is { } key) answer = ExampleOf(key);
        if (answer is null)
        {
            var others = verbs.Where(v => v.Options.Any(o => o.Name == option)).Select(v => v.Name).ToArray();
            return others.Length > 0 ? $"It is an option of {string.Join(", ", others)}." : null;
        }
        if (answer.IndexOf('=') is > 0 and var equals && !answer.Contains(' '))
        {
            var set = value is null ? answer : answer[..(equals + 1)] + value;
            return verb.Name is "slice" or "turtle" or "curves" ? $"Set the key: --set {set}" : $"Set the key for slicing: caterpillar slice MODEL --set {set}";
        }
        var parts = answer.Split(' ', 2);
        if (parts[0] == "*") return verb.Options.Any(o => o.Name == parts[1].Split(' ')[0]) ? $"Use {parts[1]}" : null;
        var input = verbs.FirstOrDefault(v => v.Name == parts[0])?.Arguments.FirstOrDefault(a => a.Arity.MinimumNumberOfValues > 0);
        return parts[0] == verb.Name ? $"Use {parts[1]}" : $"Use: caterpillar {parts[0]} {(input is null ? "" : input.Name + " ")}{parts[1]}";
    }

    private static string ExampleOf(string key)
        => Table.FirstOrDefault(t => t.Answer.StartsWith(key + "=", StringComparison.Ordinal)).Answer ?? key + "=VALUE";

    // A key with or without its unit.
    private static string? KeyOf(string word)
    {
        var known = ProfileKeys.Settings.Concat(ProfileKeys.Material).Concat(ProfileKeys.Printer).Select(k => k.Name).Where(k => k != "title").ToArray();
        return known.Contains(word) ? word : KeyAdvice.OtherUnit(word, known);
    }
}
